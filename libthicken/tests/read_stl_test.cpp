// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>
#include <limits>

#include "io/byte_order.h"
#include "scratch_folder.h"

namespace thicken {
namespace {

using io::appendLittle;
using namespace test;

std::string binary(std::string header, const std::vector<std::array<float, 9>>& facets,
                   std::uint32_t announced) {
  header.resize(80, ' ');
  appendLittle(header, announced);
  for (const auto& facet : facets) {
    for (int k = 0; k < 3; ++k) appendLittle(header, 0.0f);
    for (const float x : facet) appendLittle(header, x);
    appendLittle(header, std::uint16_t{0});
  }
  return header;
}

const std::vector<std::array<float, 9>> kFacets{{0, 0, 0, 1.5f, 0, 0, 1.5f, 2, 0.25f},
                                                {0, 0, 0, 1.5f, 2, 0.25f, 0, 2, -0.125f}};

constexpr const char* kText = R"(solid two triangles
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1.5 0 0
   vertex +1.5E0 2 .25
  endloop
 endfacet
 facet normal -nan(ind) 0 0
  outer loop
   vertex 0 0 0
   vertex 1.5 2 0.25
   vertex 0 2 -125e-3
  endloop
 endfacet
endsolid two triangles
)";

TEST(ReadStl, TellsBinaryByItsSizeEvenWhenItsHeaderSaysSolid) {
  const ScratchFolder folder;
  expectSame(readMesh(folder.put("a.stl", binary("some program", kFacets, 2))), twoTriangles());
  expectSame(readMesh(folder.put("b.stl", binary("solid part\n facet normal", kFacets, 2))), twoTriangles());
  expectSame(readMesh(folder.put("C.STL", binary("", kFacets, 2))), twoTriangles());
}

TEST(ReadStl, ReadsText) {
  const ScratchFolder folder;
  const std::string text = kText;
  expectSame(readMesh(folder.put("a.stl", text)), twoTriangles());
  std::string other;  // CR LF, upper case, a byte order mark
  for (const char c : text) other += c == '\n' ? "\r\n" : std::string(1, static_cast<char>(std::toupper(c)));
  expectSame(readMesh(folder.put("b.stl", "\xEF\xBB\xBF" + other)), twoTriangles());
  std::string line = text;  // everything on one line but what follows "solid" and "endsolid"
  std::replace(line.begin() + 20, line.end() - 25, '\n', ' ');
  expectSame(readMesh(folder.put("c.stl", line)), twoTriangles());
}

TEST(ReadStl, JoinsTheSolidsOfOneFile) {
  const ScratchFolder folder;
  const TriangleMesh mesh = readMesh(folder.put("a.stl", std::string(kText) + "\n" + kText));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadStl, RoundsTextToTheFloatsThatTheFormatHolds) {
  const ScratchFolder folder;
  std::string text = kText;
  text.replace(text.find("1.5 0 0"), 7, "0.1 0.10000000149 1e39");
  const TriangleMesh mesh = readMesh(folder.put("a.stl", text));
  EXPECT_EQ(mesh.positions[1].x(), double{0.1f});
  EXPECT_EQ(mesh.positions[1].y(), double{0.1f});
  EXPECT_EQ(mesh.positions[1].z(), std::numeric_limits<double>::infinity());
}

TEST(ReadStl, LeavesItToTheCheckToFindWhatIsNotFinite) {
  const ScratchFolder folder;
  auto facets = kFacets;
  facets[1][3] = std::numeric_limits<float>::quiet_NaN();
  const TriangleMesh mesh = readMesh(folder.put("a.stl", binary("", facets, 2)));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(std::count_if(mesh.positions.begin(), mesh.positions.end(),
                          [](const Vec3& p) { return !p.allFinite(); }),
            1);
}

TEST(ReadStl, ReadsAFileWithoutTriangles) {
  const ScratchFolder folder;
  EXPECT_TRUE(readMesh(folder.put("a.stl", binary("", {}, 0))).triangles.empty());
  EXPECT_TRUE(readMesh(folder.put("b.stl", "solid nothing\nendsolid nothing\n")).triangles.empty());
}

TEST(ReadStl, PassesWhatComesAfterTheTrianglesAndSaysSo) {
  const ScratchFolder folder;
  const std::string whole = binary("", kFacets, 2);
  expectSame(readMesh(folder.put("a.stl", whole + std::string(100, '\0'))), twoTriangles());
  EXPECT_TRUE(readMeshFile(folder / "a.stl").warnings.empty());
  const MeshFile noted = readMeshFile(folder.put("b.stl", whole + "made by somebody"));
  expectSame(noted.mesh, twoTriangles());
  ASSERT_EQ(noted.warnings.size(), 1u);
  EXPECT_CONTAINS(noted.warnings[0], "16 bytes after the 2 triangles");
  // These may be triangles: the number of them is wrong.
  const MeshFile more = readMeshFile(folder.put("c.stl", binary("", kFacets, 1)));
  EXPECT_EQ(more.mesh.triangles.size(), 1u);
  ASSERT_EQ(more.warnings.size(), 1u);
  EXPECT_CONTAINS(more.warnings[0], "1 more triangles would take as many");
  EXPECT_CONTAINS(refusalOf(folder.put("d.stl", binary("", kFacets, 0))), "announces no triangles");
}

TEST(ReadStl, RefusesWhatIsCutOff) {
  const ScratchFolder folder;
  EXPECT_CONTAINS(refusalOf(folder.put("a.stl", binary("", kFacets, 1000))), "1000 triangles");
  EXPECT_CONTAINS(refusalOf(folder.put("b.stl", binary("", kFacets, 0xffffffffu))), "4294967295 triangles");
  EXPECT_CONTAINS(refusalOf(folder.put("c.stl", binary("", kFacets, 2).substr(0, 183))), "only 183");
  EXPECT_CONTAINS(refusalOf(folder.put("d.stl", std::string(50, '\1'))), "50 bytes");
  const std::string text = kText;
  EXPECT_CONTAINS(refusalOf(folder.put("e.stl", text.substr(0, 90))), "line 6: the file ends");
  EXPECT_CONTAINS(refusalOf(folder.put("f.stl", "solid nothing\n")), "endsolid");
}

TEST(ReadStl, TakesTextWithoutItsLastWordAndSaysSo) {
  const ScratchFolder folder;
  const std::string text = kText;
  const MeshFile file = readMeshFile(folder.put("a.stl", text.substr(0, text.find("endsolid"))));
  expectSame(file.mesh, twoTriangles());
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_CONTAINS(file.warnings[0], "without \"endsolid\", after 2 triangles");
  EXPECT_TRUE(readMeshFile(folder.put("b.stl", text)).warnings.empty());
}

TEST(ReadStl, SaysWhatAFileOfAnotherKindIs) {
  const ScratchFolder folder;
  const auto refusal = [&folder](const std::string& bytes) { return refusalOf(folder.put("a.stl", bytes)); };
  EXPECT_CONTAINS(refusal(std::string("PK\3\4") + std::string(200, '\0')), "zip archive");
  EXPECT_CONTAINS(refusal(std::string("\x1F\x8B\x08") + std::string(200, '\1')), "packed archive");
  EXPECT_CONTAINS(refusal("ISO-10303-21;\nHEADER;\n"), "STEP");
  EXPECT_CONTAINS(refusal("<!DOCTYPE html>\n<html>\n"), "web page");
  std::string little, big;
  for (const char c : std::string(kText)) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  for (const std::string& text : {"\xFF\xFE" + little, "\xFE\xFF" + big, little, big})
    EXPECT_CONTAINS(refusal(text), "UTF-16");
  // A binary file may begin with anything, as long as its size is right.
  std::string whole = binary("", kFacets, 2);
  whole.replace(0, 4, "PK\3\4");
  expectSame(readMesh(folder.put("b.stl", whole)), twoTriangles());
}

TEST(ReadStl, RefusesTextThatIsNoStl) {
  const ScratchFolder folder;
  EXPECT_CONTAINS(refusalOf(folder.put("a.stl", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
                  "line 1: begins with \"v\"");
  std::string text = kText;
  EXPECT_CONTAINS(refusalOf(folder.put("b.stl", std::string(text).replace(text.find("+1.5E0"), 6, "one"))),
                  "line 6: the x coordinate is \"one\"");
  EXPECT_CONTAINS(
      refusalOf(folder.put("c.stl", std::string(text).replace(text.find("endloop"), 7, "vertex 1 2 3"))),
      "line 7: \"vertex\" stands where \"endloop\" is due");
}

TEST(ReadStl, ReadsLargeFilesInShortTime) {
  const ScratchFolder folder;
  constexpr int kSide = 700;  // about a million triangles, 49 MB
  std::vector<std::array<float, 9>> facets;
  const auto z = [](int x, int y) { return static_cast<float>(std::sin(0.01 * x) * std::cos(0.02 * y)); };
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      const auto u = static_cast<float>(x), v = static_cast<float>(y);
      facets.push_back({u, v, z(x, y), u + 1, v, z(x + 1, y), u + 1, v + 1, z(x + 1, y + 1)});
      facets.push_back({u, v, z(x, y), u + 1, v + 1, z(x + 1, y + 1), u, v + 1, z(x, y + 1)});
    }
  }
  const auto path = folder.put("a.stl", binary("", facets, static_cast<std::uint32_t>(facets.size())));
  const TriangleMesh mesh = readMesh(path);
  EXPECT_EQ(mesh.triangles.size(), facets.size());
  EXPECT_EQ(mesh.positions.size(), std::size_t{kSide + 1} * (kSide + 1));
}

}  // namespace
}  // namespace thicken
