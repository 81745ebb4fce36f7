// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/picture.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <numeric>
#include <string>

#include "plain_shapes.h"
#include "thicken/error.h"

namespace thicken {
namespace {

constexpr Colour kWhite{255, 255, 255}, kGreen{0, 200, 0};
constexpr std::array<Colour, 1> kAllGreen{kGreen};

View straightDown(int width, int height) {
  View view;
  view.towards = {0, 0, -1};
  view.up = {0, 1, 0};
  view.width = width;
  view.height = height;
  return view;
}

const Colour& at(const Picture& picture, int x, int y) {
  return picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
}

// Brightness of what faces the eye.
Colour lit(const Colour& colour) {
  const double brightness = 0.4 + 0.6 * 0.77 / std::sqrt(0.4 * 0.4 + 0.5 * 0.5 + 0.77 * 0.77);
  Colour result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround(colour[k] * brightness));
  return result;
}

TEST(Picture, ShowsAnUprightSheetInTheMiddle) {
  // 2 wide and 1 high: it fills 0.94 of 100 pixels across, and half as many of 100 down.
  TriangleMesh sheet{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::array colours{Colour{200, 0, 0}, Colour{0, 0, 200}};  // below and above the diagonal
  const Picture picture = renderPicture(sheet, colours, straightDown(100, 100));
  EXPECT_EQ(at(picture, 1, 50), kWhite);
  EXPECT_EQ(at(picture, 50, 25), kWhite);
  EXPECT_EQ(at(picture, 80, 60), lit(colours[0]));
  EXPECT_EQ(at(picture, 20, 40), lit(colours[1]));
  const auto covered = std::count_if(picture.pixels.begin(), picture.pixels.end(),
                                     [](const Colour& c) { return c != kWhite; });
  EXPECT_NEAR(static_cast<double>(covered), 94 * 47, 94 * 2 + 47 * 2);
}

TEST(Picture, HasNoGapsBetweenTriangles) {
  const TriangleMesh sheet = shapes::flatSheet(37, 23, 0);
  const Picture picture = renderPicture(sheet, kAllGreen, straightDown(97, 83));
  for (int y = 20; y < 60; ++y)
    for (int x = 20; x < 75; ++x) ASSERT_EQ(at(picture, x, y), lit(kGreen)) << x << ", " << y;
}

TEST(Picture, TheNearerTriangleHidesTheOther) {
  TriangleMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                   {{0, 1, 2}, {3, 4, 5}}};
  const std::array colours{Colour{200, 0, 0}, kGreen};
  EXPECT_EQ(at(renderPicture(two, colours, straightDown(60, 60)), 20, 40), lit(kGreen));
  std::swap(two.triangles[0], two.triangles[1]);
  EXPECT_EQ(at(renderPicture(two, colours, straightDown(60, 60)), 20, 40), lit(colours[0]));
}

TEST(Picture, ACutShowsTheInsideOfWhatIsBehindIt) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {4, 4, 4});
  View view = straightDown(60, 60);
  EXPECT_EQ(at(renderPicture(box, kAllGreen, view), 30, 30), lit(kGreen));
  view.cut = View::Cut{{2, 2, 2}, {0, 0, 1}};
  EXPECT_EQ(at(renderPicture(box, kAllGreen, view), 30, 30), kBackColour);
  view.cut->normal = {1, 0,
                      1};  // takes away what is above x + z = 4: the right, all but the floor's left half
  const Picture slanted = renderPicture(box, kAllGreen, view);
  EXPECT_EQ(at(slanted, 45, 30), kBackColour);
  EXPECT_EQ(at(slanted, 15, 30), kBackColour);
  view.cut->point = {5, 0, 4};  // beyond the box
  EXPECT_EQ(at(renderPicture(box, kAllGreen, view), 30, 30), lit(kGreen));
}

TEST(Picture, IsOfTheSideThatIsAskedFor) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
  const Vec3 towards = viewDirection({0, 0, 1}, 30, 35);
  EXPECT_NEAR(towards.norm(), 1, 1e-12);
  EXPECT_NEAR(towards.z(), -std::sin(35 * std::acos(-1) / 180), 1e-12);
  EXPECT_LT((towards - View().towards).norm(), 1e-3);
  const Vec3 below = viewDirection({0, 0, 1}, 210, -35);
  EXPECT_LT((below + towards).norm(), 1e-12);
}

TEST(Picture, RefusesViewsThatShowNothing) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 1, 1});
  const auto refused = [&](const View& view, std::size_t colours) {
    try {
      (void)renderPicture(box, std::vector<Colour>(colours, kGreen), view);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kInvalidArgument;
    }
    return false;
  };
  EXPECT_FALSE(refused(View(), 1));
  EXPECT_FALSE(refused(View(), 12));
  EXPECT_TRUE(refused(View(), 11));
  View view;
  view.up = 3 * view.towards;
  EXPECT_TRUE(refused(view, 1));
  view = straightDown(0, 60);
  EXPECT_TRUE(refused(view, 1));
  view = straightDown(60, 60);
  view.cut = View::Cut{{0, 0, 0}, {0, 0, -1}};
  EXPECT_TRUE(refused(view, 1));
  EXPECT_EQ(renderPicture({}, kAllGreen, straightDown(3, 2)).pixels, std::vector<Colour>(6, kWhite));
}

std::uint32_t bigAt(const std::string& bytes, std::size_t offset) {
  return std::accumulate(
      bytes.begin() + static_cast<std::ptrdiff_t>(offset),
      bytes.begin() + static_cast<std::ptrdiff_t>(offset) + 4, std::uint32_t{0},
      [](std::uint32_t value, char c) { return value << 8 | static_cast<std::uint8_t>(c); });
}

TEST(Picture, PngHoldsThePixels) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 2, 3});
  View view;
  view.width = 31;
  view.height = 17;
  const Picture picture = renderPicture(box, kAllGreen, view);
  const std::string png = toPng(picture);
  ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1A\n");
  std::size_t at = 8;
  std::string kinds, data;
  while (at < png.size()) {
    const std::uint32_t size = bigAt(png, at);
    const std::string checked = png.substr(at + 4, size + 4);
    EXPECT_EQ(crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())),
              bigAt(png, at + 8 + size));
    kinds += checked.substr(0, 4);
    if (checked.starts_with("IHDR")) {
      EXPECT_EQ(bigAt(checked, 4), 31u);
      EXPECT_EQ(bigAt(checked, 8), 17u);
    }
    if (checked.starts_with("IDAT")) data = checked.substr(4);
    at += 12 + size;
  }
  EXPECT_EQ(kinds, "IHDRIDATIEND");
  std::string rows(17 * (1 + 3 * 31), '\0');
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                       reinterpret_cast<const Bytef*>(data.data()), static_cast<uLong>(data.size())),
            Z_OK);
  ASSERT_EQ(size, rows.size());
  std::vector<Colour> pixels(picture.pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t row = i / 31 * (1 + 3 * 31);
    ASSERT_EQ(rows[row], 2);  // each less the one above
    for (std::size_t k = 0; k < 3; ++k)
      pixels[i][k] =
          static_cast<std::uint8_t>(rows[row + 1 + 3 * (i % 31) + k] + (i < 31 ? 0 : pixels[i - 31][k]));
  }
  EXPECT_EQ(pixels, picture.pixels);
}

TEST(Picture, PicturesStandBesideEachOther) {
  Picture left{1, 2, {kWhite, kGreen}}, right{2, 2, {kGreen, kWhite, kWhite, kGreen}};
  const Picture both = besideEachOther(std::array{left, right});
  EXPECT_EQ(both.width, 3);
  EXPECT_EQ(both.pixels, (std::vector<Colour>{kWhite, kGreen, kWhite, kGreen, kWhite, kGreen}));
  right = {1, 1, {kGreen}};
  EXPECT_THROW((void)besideEachOther(std::array{left, right}), Error);
}

}  // namespace
}  // namespace thicken
