// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scratch_folder.h"

namespace thicken {
namespace {

using namespace test;

TriangleMesh meshOf(const std::string& text) {
  const ScratchFolder folder;
  return readMesh(folder.put("a.off", text));
}

std::string refusal(const std::string& text) {
  const ScratchFolder folder;
  return refusalOf(folder.put("a.off", text));
}

constexpr const char* kBody = "0 0 0\n1.5 0 0\n1.5 2 .25\n0 2 -0.125\n3 0 1 2\n3 0 2 3\n";

TEST(ReadOff, ReadsCountsOnEitherLine) {
  expectSame(meshOf("OFF\n4 2 0\n" + std::string(kBody)), twoTriangles());
  expectSame(meshOf("OFF 4 2 0\n" + std::string(kBody)), twoTriangles());
  expectSame(meshOf("OFF\n4 2\n" + std::string(kBody)), twoTriangles());
}

TEST(ReadOff, PassesCommentsColoursAndNormals) {
  expectSame(meshOf("# one\n#two\nOFF # three\r\n\r\n4 2 0#\r\n0 0 0\r\n1.5 0 0 # here\r\n\r\n1.5 2 "
                    ".25#\r\n0 2 -0.125\r\n"
                    "3 0 1 2 255 0 0\r\n3 0 2 3 # end"),
             twoTriangles());
  expectSame(meshOf("COFF\n4 2 0\n0 0 0 1 0 0 1\n1.5 0 0 1 0 0 1\n1.5 2 .25 1 0 0 1\n0 2 -0.125 0.5 0 0 1\n3 "
                    "0 1 2\n3 0 2 3 0.1 0.2 0.3\n"),
             twoTriangles());
  expectSame(meshOf("STCNOFF\n4 2 0\n0 0 0 0 0 1 9 9 9 9 0 0\n1.5 0 0 0 0 1 9 9 9 9 0 1\n1.5 2 .25 0 0 1 9 9 "
                    "9 9 0 1\n0 2 -0.125 0 0 1 9 9 9 9 0 0\n"
                    "3 0 1 2\n3 0 2 3\n"),
             twoTriangles());
}

TEST(ReadOff, SplitsPolygons) {
  EXPECT_EQ(meshOf("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1\n2 3\n").triangles.size(), 2u);
}

TEST(ReadOff, ReadsAFileWithoutFaces) {
  EXPECT_TRUE(meshOf("OFF\n1 0 0\n1 2 3\n").triangles.empty());
}

TEST(ReadOff, RefusesCountsThatDoNotFit) {
  const std::string body = kBody;
  EXPECT_CONTAINS(refusal("OFF\n5 2 0\n" + body), "line 9");
  EXPECT_CONTAINS(refusal("OFF\n4 3 0\n" + body), "ends before the number of corners");
  EXPECT_CONTAINS(refusal("OFF\n4 1 0\n" + body), "line 8: \"3\" comes after the 1 faces");
  EXPECT_CONTAINS(refusal("OFF\n4000000000 2 0\n" + body), "line 2: the number of vertices is 4000000000");
  EXPECT_CONTAINS(refusal("OFF\n4 4000000000 0\n" + body), "line 2: the number of faces is 4000000000");
  EXPECT_CONTAINS(refusal("OFF\n-4 2 0\n" + body), "negative");
  EXPECT_CONTAINS(refusal("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4294967295 0 1 2\n"),
                  "line 7: the number of corners is 4294967295");
}

TEST(ReadOff, RefusesWhatIsNoMesh) {
  EXPECT_CONTAINS(refusal("OFF8 6 12\n"), "\"OFF8\"");
  EXPECT_CONTAINS(refusal("4OFF\n1 0 0\n0 0 0 0\n"), "dimension");
  EXPECT_CONTAINS(refusal("OFF BINARY\n"), "\"BINARY\"");
  EXPECT_CONTAINS(refusal("OFF\n1 0 0\n0 x 0\n"), "line 3: the y coordinate is \"x\"");
  EXPECT_CONTAINS(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "line 6: there is no vertex \"3\"");
  EXPECT_CONTAINS(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), "line 6: a face has 2 corners");
}

}  // namespace
}  // namespace thicken
