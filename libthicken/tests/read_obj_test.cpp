// SPDX-License-Identifier: LGPL-2.1-or-later
#include <cmath>

#include "scratch_folder.h"

namespace thicken {
namespace {

using namespace test;

constexpr const char* kVertices = "v 0 0 0\nv 1.5 0 0\nv 1.5 2 .25\nv 0 2 -0.125\n";

TriangleMesh meshOf(const std::string& text) {
  const ScratchFolder folder;
  return readMesh(folder.put("a.obj", text));
}

std::string refusal(const std::string& text) {
  const ScratchFolder folder;
  return refusalOf(folder.put("a.obj", text));
}

TEST(ReadObj, ReadsFacesInAllSpellings) {
  expectSame(meshOf(std::string(kVertices) + "f 1 2 3\nf 1 3 4\n"), twoTriangles());
  expectSame(meshOf(std::string(kVertices) + "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1/1/1 3/1/1 4/1/1"),
             twoTriangles());
  expectSame(meshOf(std::string(kVertices) + "vn 0 0 1\nf 1//1 2//1 3//1\nf -4//-1 -2//-1 -1//-1\n"),
             twoTriangles());
  expectSame(meshOf("f 1 2 3\nf 1 3 4\n" + std::string(kVertices)), twoTriangles());
}

TEST(ReadObj, PassesWhatSaysNothingAboutTriangles) {
  expectSame(meshOf("\xEF\xBB\xBF# comment\r\nmtllib a.mtl\r\no part\r\nv 0 0 0 1.0 # weight\r\n  v  1.5\t0 "
                    "0 255 0 0\r\n"
                    "v 1.5 2 .25\r\nv 0 2 -0.125\r\n\r\ng\r\nusemtl steel\r\ns off\r\nl 1 2\r\nf 1 2 3#\r\nf "
                    "1 3 4  \r\n"),
             twoTriangles());
}

TEST(ReadObj, JoinsLinesAtABackslash) {
  expectSame(meshOf(std::string(kVertices) + "f 1 2 \\\n3\nf 1 3\\\r\n 4\n"), twoTriangles());
}

TEST(ReadObj, SplitsPolygons) {
  const TriangleMesh mesh = meshOf("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
  double area = 0;  // a fan from the first corner would have triangles that overlap
  for (const Triangle& t : mesh.triangles) {
    const Vec3 u = mesh.positions[t[1]] - mesh.positions[t[0]],
               v = mesh.positions[t[2]] - mesh.positions[t[0]];
    area += std::abs(u.x() * v.y() - u.y() * v.x()) / 2;
  }
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_DOUBLE_EQ(area, 10);
}

TEST(ReadObj, RoundsEveryNumberCorrectly) {
  const TriangleMesh mesh =
      meshOf("v 0.1 1e-300 1e300\nv 5.0000000000000009 -0 17.999999999999996\nv +1.0 1e5 nan\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], Vec3(0.1, 1e-300, 1e300));
  EXPECT_EQ(mesh.positions[1], Vec3(5.0000000000000009, 0, 17.999999999999996));
  EXPECT_TRUE(std::signbit(mesh.positions[1].y()));
  EXPECT_TRUE(std::isnan(mesh.positions[2].z()));
}

TEST(ReadObj, ReadsAFileWithoutFaces) {
  EXPECT_TRUE(meshOf(kVertices).triangles.empty());
}

TEST(ReadObj, RefusesCornersThatAreNoVertices) {
  const std::string vertices = kVertices;
  EXPECT_CONTAINS(refusal(vertices + "f 0 1 2\n"), "line 5: a face names vertex 0");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 3\nf 1 2 5\nf 1 2 3\n"), "line 6: there is no vertex 5");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 99999999999\n"), "line 5: there is no vertex 99999999999");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 -5\n"), "line 5: a face names vertex \"-5\"");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 a\n"), "line 5: \"a\"");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 3/x\n"), "line 5: \"3/x\"");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2 3.0\n"), "line 5: \"3.0\"");
  EXPECT_CONTAINS(refusal(vertices + "f 1 2\n"), "line 5: a face has 2 corners");
  EXPECT_CONTAINS(refusal(vertices + "f\n"), "line 5: a face has 0 corners");
}

TEST(ReadObj, RefusesWhatItWouldHaveToGuess) {
  EXPECT_CONTAINS(refusal("v 1 0 zero\n"), "line 1: the z coordinate is \"zero\"");
  EXPECT_CONTAINS(refusal("v 0 0 0\nv 1 0\nv 0 1 0\n"), "line 2: the line ends before the z coordinate");
  EXPECT_CONTAINS(refusal("solid part\n"), "line 1 begins with \"solid\"");
  EXPECT_CONTAINS(refusal(std::string(kVertices) + "surf 0 1 0 1 1 2 3 4\n"), "freeform surfaces");
  EXPECT_CONTAINS(refusal("# only a comment\n"), "no vertex");
  EXPECT_CONTAINS(refusal(std::string("\xFF\xFEv\0 \0", 6)), "UTF-16");
}

TEST(ReadObj, PassesUnknownStatementsAndSaysSo) {
  const ScratchFolder folder;
  const std::string text = "newmtl x\nKd 1 1 1\n" + std::string(kVertices) + "my_tag 7\nf 1 2 3\n";
  const MeshFile file = readMeshFile(folder.put("a.obj", text));
  EXPECT_EQ(file.mesh.triangles.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_CONTAINS(file.warnings[0], "line 1: \"newmtl\"");
  EXPECT_CONTAINS(file.warnings[0], "2 more lines");
}

}  // namespace
}  // namespace thicken
