// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A z-buffer. Pixels are drawn kSamples times finer along either side, and averaged.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/bounds.h"
#include "thicken/error.h"
#include "thicken/picture.h"

namespace thicken {
namespace {

constexpr int kSamples = 3;
constexpr int kMostPixels = 8192;  // along a side
constexpr double kFilled = 0.94;   // of the picture
// Pixels at an edge belong to both triangles there, whatever their rounding: no gaps, and the nearer one
// wins.
constexpr double kNear = 1e-6;
constexpr Colour kBackground{255, 255, 255};

// Right, up and towards the eye, as rows.
using Axes = Eigen::Matrix3d;

Axes axesOf(const View& view) {
  const Vec3 back = -view.towards.normalized();
  const Vec3 right = view.up.cross(back).normalized();
  Axes axes;
  axes.row(0) = right;
  axes.row(1) = back.cross(right);
  axes.row(2) = back;
  return axes;
}

void requireValid(const View& view, std::size_t triangles, std::size_t colours) {
  const auto refuse = [](const char* why) { throw Error(ErrorCode::kInvalidArgument, why); };
  if (view.width < 1 || view.height < 1 || view.width > kMostPixels || view.height > kMostPixels)
    refuse("a picture has 1 to 8192 pixels along each side");
  const double across = view.up.normalized().cross(view.towards.normalized()).norm();
  if (!(across > 1e-9)) refuse("a view needs two directions that are not along each other: towards, and up");
  if (view.cut && !(view.cut->normal.dot(view.towards) < 0)) refuse("the cutting plane has to face the eye");
  if (colours != 1 && colours != triangles)
    refuse("a picture needs a colour for each triangle, or one for all");
}

// A value that is linear over the picture.
struct Plane {
  double atZero = 0, alongX = 0, alongY = 0;
  double operator()(double x, double y) const { return atZero + alongX * x + alongY * y; }
};

// The plane with these growths that has `value` at `at`.
Plane planeThrough(const Vec3& at, double value, double alongX, double alongY) {
  return {value - alongX * at.x() - alongY * at.y(), alongX, alongY};
}

struct Canvas {
  Canvas(int w, int h)
      : width(w),
        height(h),
        depth(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
              -std::numeric_limits<float>::infinity()),
        colour(depth.size(), kBackground) {}
  int width, height;
  std::vector<float> depth;  // towards the eye
  std::vector<Colour> colour;
};

// Where a corner is in the picture, x to the right and y down, and how near to the eye; in samples.
struct Projection {
  Axes axes;
  Vec3 middle = Vec3::Zero();  // along the axes
  double scale = 1, centreX = 0, centreY = 0;

  [[nodiscard]] Vec3 operator()(const Vec3& p) const {
    const Vec3 eye = scale * (axes * p - middle);
    return {centreX + eye.x(), centreY - eye.y(), eye.z()};
  }
};

Projection projectionOf(const TriangleMesh& mesh, const View& view, const Canvas& canvas) {
  Projection projection{axesOf(view)};
  mesh::Bounds box;
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t) box.add(projection.axes * mesh.positions[v]);
  if (mesh.triangles.empty()) return projection;
  const Vec3 size = (box.high - box.low).cwiseMax(std::numeric_limits<double>::min());
  projection.middle = (box.low + box.high) / 2;
  projection.scale = kFilled * std::min(canvas.width / size.x(), canvas.height / size.y());
  projection.centreX = (canvas.width - 1) / 2.0;
  projection.centreY = (canvas.height - 1) / 2.0;
  return projection;
}

// How near to the eye something may be that is not cut off.
Plane limitOf(const View& view, const Projection& projection) {
  if (!view.cut) return {std::numeric_limits<double>::infinity(), 0, 0};
  const Vec3 normal = projection.axes * view.cut->normal;
  return planeThrough(projection(view.cut->point), projection(view.cut->point).z(), -normal.x() / normal.z(),
                      normal.y() / normal.z());
}

Colour shaded(const Colour& colour, const Vec3& normal) {
  static const Vec3 kLight = Vec3(-0.4, 0.5, 0.77).normalized();
  if (!(normal.z() > 0)) return kBackColour;  // flat, as the plane of a cut is
  const double brightness = 0.4 + 0.6 * std::abs(normal.dot(kLight));
  Colour result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = static_cast<std::uint8_t>(std::lround(colour[k] * brightness));
  return result;
}

void fill(Canvas& canvas, const std::array<Vec3, 3>& corner, const Colour& colour, const Plane& limit) {
  const Vec3 &a = corner[0], ab = corner[1] - a, ac = corner[2] - a;
  const double area = ab.x() * ac.y() - ab.y() * ac.x();
  if (area == 0 || !std::isfinite(area)) return;
  // The shares of the second and third corner, and the depth.
  const Plane b = planeThrough(a, 0, ac.y() / area, -ac.x() / area);
  const Plane c = planeThrough(a, 0, -ab.y() / area, ab.x() / area);
  const Plane z =
      planeThrough(a, a.z(), b.alongX * ab.z() + c.alongX * ac.z(), b.alongY * ab.z() + c.alongY * ac.z());
  const auto least = [&](int k) { return std::min({a[k], corner[1][k], corner[2][k]}); };
  const auto most = [&](int k) { return std::max({a[k], corner[1][k], corner[2][k]}); };
  const int left = std::max(0, static_cast<int>(std::ceil(least(0) - kNear)));
  const int right = std::min(canvas.width - 1, static_cast<int>(std::floor(most(0) + kNear)));
  const int top = std::max(0, static_cast<int>(std::ceil(least(1) - kNear)));
  const int bottom = std::min(canvas.height - 1, static_cast<int>(std::floor(most(1) + kNear)));
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x) {
      const double shareB = b(x, y), shareC = c(x, y), depth = z(x, y);
      if (shareB < -kNear || shareC < -kNear || shareB + shareC > 1 + kNear || depth > limit(x, y)) continue;
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width) + static_cast<std::size_t>(x);
      if (static_cast<float>(depth) <= canvas.depth[at]) continue;
      canvas.depth[at] = static_cast<float>(depth);
      canvas.colour[at] = colour;
    }
}

Picture averaged(const Canvas& canvas) {
  Picture picture{canvas.width / kSamples, canvas.height / kSamples, {}};
  const auto stride = static_cast<std::size_t>(canvas.width);
  picture.pixels.reserve(canvas.colour.size() / (kSamples * kSamples));
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(picture.width); ++x) {
      std::array<int, 3> sum{};
      for (std::size_t i = 0; i < kSamples * kSamples; ++i) {
        const Colour& sample =
            canvas.colour[(y * kSamples + i / kSamples) * stride + x * kSamples + i % kSamples];
        for (std::size_t k = 0; k < 3; ++k) sum[k] += sample[k];
      }
      Colour& pixel = picture.pixels.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        pixel[k] = static_cast<std::uint8_t>((sum[k] + kSamples * kSamples / 2) / (kSamples * kSamples));
    }
  return picture;
}

}  // namespace

Vec3 viewDirection(const Vec3& up, double turn, double rise) {
  const Vec3 axis = up.normalized();
  Eigen::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vec3 side = axis.cross(Vec3::Unit(least)).normalized(), front = side.cross(axis);
  const double radians = std::numbers::pi / 180, t = turn * radians, r = rise * radians;
  return -std::cos(r) * (std::cos(t) * front + std::sin(t) * side) - std::sin(r) * axis;
}

Colour colourOf(Region region) noexcept {
  switch (region) {
    case Region::kOriginal:
      return {236, 201, 92};
    case Region::kShell:
      return {110, 150, 205};
    case Region::kWall:
      break;
  }
  return {200, 82, 70};
}

std::vector<Colour> coloursOf(std::span<const Region> regions) {
  std::vector<Colour> colours(regions.size());
  std::transform(regions.begin(), regions.end(), colours.begin(), colourOf);
  return colours;
}

Picture renderPicture(const TriangleMesh& mesh, std::span<const Colour> colours, const View& view) {
  requireValid(view, mesh.triangles.size(), colours.size());
  Canvas canvas(view.width * kSamples, view.height * kSamples);
  const Projection projection = projectionOf(mesh, view, canvas);
  const Plane limit = limitOf(view, projection);
  std::vector<Vec3> placed(mesh.positions.size());
  std::transform(mesh.positions.begin(), mesh.positions.end(), placed.begin(), projection);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    const std::array<Vec3, 3> corner{placed[a], placed[b], placed[c]};
    Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    normal = {-normal.x(), normal.y(), -normal.z()};  // in the picture y goes down
    fill(canvas, corner, shaded(colours[colours.size() == 1 ? 0 : t], normal), limit);
  }
  return averaged(canvas);
}

Picture renderSolids(std::span<const TriangleMesh> solids, std::span<const std::vector<Region>> regions,
                     const View& view) {
  constexpr Colour kSteel{120, 160, 205};
  TriangleMesh all;
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const auto first = static_cast<VertexId>(all.positions.size());
    all.positions.insert(all.positions.end(), solids[i].positions.begin(), solids[i].positions.end());
    for (const auto& [a, b, c] : solids[i].triangles)
      all.triangles.push_back({first + a, first + b, first + c});
    if (regions.empty()) continue;
    const std::vector<Colour> own = coloursOf(regions[i]);
    colours.insert(colours.end(), own.begin(), own.end());
  }
  return renderPicture(all, regions.empty() ? std::vector{kSteel} : colours, view);
}

Picture besideEachOther(std::span<const Picture> pictures) {
  Picture sheet;
  for (const Picture& picture : pictures) {
    if (picture.height != pictures.front().height)
      throw Error(ErrorCode::kInvalidArgument, "pictures beside each other have to be of one height");
    sheet.width += picture.width;
    sheet.height = picture.height;
  }
  for (std::size_t y = 0; y < static_cast<std::size_t>(sheet.height); ++y)
    for (const Picture& picture : pictures) {
      const auto row = picture.pixels.begin() + static_cast<std::ptrdiff_t>(y) * picture.width;
      sheet.pixels.insert(sheet.pixels.end(), row, row + picture.width);
    }
  return sheet;
}

}  // namespace thicken
