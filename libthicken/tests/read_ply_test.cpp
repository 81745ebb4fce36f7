// SPDX-License-Identifier: LGPL-2.1-or-later
#include <limits>

#include "io/byte_order.h"
#include "scratch_folder.h"

namespace thicken {
namespace {

using namespace test;

constexpr const char* kText = R"(ply
format ascii 1.0
comment two triangles
obj_info whatever
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
1.5 0 0
+1.5 2 .25
0 2e0 -0.125
3 0 1 2
3 0 2 3
)";

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  std::string raw;
  io::appendLittle(raw, value);
  if (order == std::endian::big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

// Coordinates of type X called `real`, list lengths of type N, indices of type I, between other
// elements, properties and lists.
template <class X, class N, class I>
std::string binary(std::endian order, const std::string& real, const std::string& length,
                   const std::string& index) {
  const TriangleMesh mesh = twoTriangles();
  std::string bytes =
      "ply\nformat " + std::string(order == std::endian::big ? "binary_big_endian" : "binary_little_endian") +
      " 1.0\nelement camera 1\nproperty double focus\nproperty list uchar short lens\nelement vertex 4\n"
      "property uchar red\nproperty " +
      real + " z\nproperty " + real +
      " x\nproperty list uint float weights\n"
      "property " +
      real + " y\nelement face 2\nproperty list uchar float texcoord\nproperty list " + length + " " + index +
      " vertex_index\nproperty int flags\nelement nothing 4000000000\nend_header\n";
  append(bytes, 1.0, order);
  append(bytes, std::uint8_t{2}, order);
  for (const int k : {1, 2}) append(bytes, static_cast<std::int16_t>(k), order);
  for (std::size_t v = 0; v < 4; ++v) {
    append(bytes, std::uint8_t{200}, order);
    append(bytes, static_cast<X>(mesh.positions[v].z()), order);
    append(bytes, static_cast<X>(mesh.positions[v].x()), order);
    append(bytes, static_cast<std::uint32_t>(v), order);
    for (std::size_t k = 0; k < v; ++k) append(bytes, 0.5f, order);
    append(bytes, static_cast<X>(mesh.positions[v].y()), order);
  }
  for (const Triangle& t : mesh.triangles) {
    append(bytes, std::uint8_t{1}, order);
    append(bytes, 0.25f, order);
    append(bytes, static_cast<N>(3), order);
    for (const VertexId v : t) append(bytes, static_cast<I>(v), order);
    append(bytes, -1, order);
  }
  return bytes;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

TEST(ReadPly, ReadsText) {
  const ScratchFolder folder;
  const std::string text = kText;
  expectSame(readMesh(folder.put("a.ply", text)), twoTriangles());
  for (const std::string end : {"\r\n", "\r", " \t\n", "\n\n"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    expectSame(readMesh(folder.put("b.ply", other)), twoTriangles());
  }
  expectSame(readMesh(folder.put("c.ply", "\xEF\xBB\xBF" + text)), twoTriangles());
  expectSame(readMesh(folder.put("d.ply", text.substr(0, text.size() - 1))), twoTriangles());
}

TEST(ReadPly, ReadsBothByteOrdersAndAllTypes) {
  const ScratchFolder folder;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    expectSame(readMesh(folder.put(
                   "a.ply", binary<float, std::uint8_t, std::int32_t>(order, "float", "uchar", "int"))),
               twoTriangles());
    expectSame(readMesh(folder.put("b.ply", binary<double, std::int32_t, std::uint32_t>(order, "float64",
                                                                                        "int32", "uint32"))),
               twoTriangles());
    expectSame(readMesh(folder.put(
                   "c.ply", binary<double, std::int8_t, std::uint8_t>(order, "double", "char", "uint8"))),
               twoTriangles());
    expectSame(readMesh(folder.put(
                   "d.ply", binary<float, std::uint16_t, std::int16_t>(order, "float32", "uint16", "short"))),
               twoTriangles());
    expectSame(
        readMesh(folder.put("e.ply", binary<float, std::int64_t, float>(order, "float", "int64", "float"))),
        twoTriangles());
  }
}

TEST(ReadPly, ReadsWholeNumbersAsCoordinates) {
  const ScratchFolder folder;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty int8 y\nproperty uint "
      "z\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  for (const int x : {-300, 0, 300}) {
    append(bytes, static_cast<std::int16_t>(x), std::endian::big);
    append(bytes, static_cast<std::int8_t>(-x / 3), std::endian::big);
    append(bytes, std::uint32_t{4'000'000'000}, std::endian::big);
  }
  bytes += std::string("\3\0\1\2", 4);
  EXPECT_EQ(readMesh(folder.put("a.ply", bytes)).positions,
            (std::vector<Vec3>{{-300, 100, 4e9}, {0, 0, 4e9}, {300, -100, 4e9}}));
}

TEST(ReadPly, KeepsDoublesThatFloatsCannotHold) {
  const ScratchFolder folder;
  const std::string text =
      replaced(replaced(kText, "1.5 0 0", "0.1 1e-300 1e300"), "+1.5", "1.0000000000000002");
  const TriangleMesh mesh = readMesh(folder.put("a.ply", text));
  EXPECT_EQ(mesh.positions[1], Vec3(0.1, 1e-300, 1e300));
  EXPECT_EQ(mesh.positions[2].x(), 1.0000000000000002);
}

TEST(ReadPly, DoesNotTakeTheFirstByteOfTheDataForALineEnd) {
  const ScratchFolder folder;
  // 10 is a line feed; the header's lines end with CR alone.
  std::string bytes =
      "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar x\rproperty uchar y\rproperty "
      "uchar z\r"
      "element face 1\rproperty list uchar uchar vertex_indices\rend_header\r";
  bytes += std::string("\n\0\0\0\1\0\0\0\1\3\0\1\2", 13);
  EXPECT_EQ(readMesh(folder.put("a.ply", bytes)).positions,
            (std::vector<Vec3>{{10, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
}

TEST(ReadPly, SplitsPolygons) {
  const ScratchFolder folder;
  const std::string text = replaced(replaced(kText, "3 0 1 2\n3 0 2 3", "4 0 1 2 3"), "face 2", "face 1");
  EXPECT_EQ(readMesh(folder.put("a.ply", text)).triangles.size(), 2u);
}

TEST(ReadPly, ReadsAFileWithoutFaces) {
  const ScratchFolder folder;
  const std::string text = kText;
  EXPECT_TRUE(
      readMesh(folder.put("a.ply", replaced(replaced(text, "3 0 1 2\n3 0 2 3\n", ""), "face 2", "face 0")))
          .triangles.empty());
  const std::string points = replaced(replaced(text, "3 0 1 2\n3 0 2 3\n", ""),
                                      "element face 2\nproperty list uchar int vertex_indices\n", "");
  EXPECT_TRUE(readMesh(folder.put("b.ply", points)).triangles.empty());
}

TEST(ReadPly, ReadsWhatIsNotFinite) {
  const ScratchFolder folder;
  const TriangleMesh mesh = readMesh(folder.put("a.ply", replaced(kText, "1.5 0 0", "nan -inf 0")));
  EXPECT_TRUE(std::isnan(mesh.positions[1].x()));
  EXPECT_EQ(mesh.positions[1].y(), -std::numeric_limits<double>::infinity());
}

TEST(ReadPly, RefusesIndicesThatNameNoVertex) {
  const ScratchFolder folder;
  EXPECT_CONTAINS(refusalOf(folder.put("a.ply", replaced(kText, "3 0 2 3", "3 0 2 4"))),
                  "line 17: face 1 names vertex 4");
  EXPECT_CONTAINS(refusalOf(folder.put("b.ply", replaced(kText, "3 0 2 3", "3 0 -2 3"))), "names vertex -2");
  EXPECT_CONTAINS(refusalOf(folder.put("c.ply", replaced(kText, "3 0 2 3", "3 0 2.5 3"))), "whole number");
  EXPECT_CONTAINS(refusalOf(folder.put("d.ply", replaced(kText, "3 0 2 3", "2 0 2"))),
                  "face 1 has 2 corners");
}

TEST(ReadPly, RefusesLinesOfMoreOrFewerValuesThanAnnounced) {
  const ScratchFolder folder;
  EXPECT_CONTAINS(refusalOf(folder.put("a.ply", replaced(kText, "1.5 0 0", "1.5 0 0 0"))),
                  "line 13: the line has more");
  EXPECT_CONTAINS(refusalOf(folder.put("b.ply", replaced(kText, "1.5 0 0", "1.5 0"))),
                  "line 13: the line has fewer");
  EXPECT_CONTAINS(refusalOf(folder.put("c.ply", replaced(kText, "1.5 0 0", "1.5 zero 0"))), "\"zero\"");
  EXPECT_CONTAINS(refusalOf(folder.put("d.ply", std::string(kText) + "3 0 1 3\n")), "more in the file");
}

TEST(ReadPly, TakesValuesThatHaveNoLinesOfTheirOwnAndSaysSo) {
  const ScratchFolder folder;
  const std::string text = kText;
  const std::size_t data = text.find("end_header\n") + 11;
  for (const char separator : {' ', '\n'}) {  // all on one line, or each on its own
    std::string other = text;
    for (std::size_t i = data; i < other.size(); ++i)
      if (other[i] == '\n' || other[i] == ' ') other[i] = separator;
    const MeshFile file = readMeshFile(folder.put("a.ply", other));
    expectSame(file.mesh, twoTriangles());
    ASSERT_EQ(file.warnings.size(), 1u);
    EXPECT_CONTAINS(file.warnings[0], "no lines of their own");
    // Nor may a value be missing or left over there.
    EXPECT_CONTAINS(refusalOf(folder.put("b.ply", other + "7 ")), "more in the file");
    EXPECT_CONTAINS(refusalOf(folder.put("c.ply", other.substr(0, other.size() - 2))), "cut off");
  }
  EXPECT_TRUE(readMeshFile(folder.put("d.ply", text)).warnings.empty());
}

TEST(ReadPly, RefusesHeadersThatSayNoMesh) {
  const ScratchFolder folder;
  const auto refusal = [&folder](const std::string& what, const std::string& by) {
    return refusalOf(folder.put("a.ply", replaced(kText, what, by)));
  };
  EXPECT_CONTAINS(refusal("ply\n", "plx\n"), "line 1");
  EXPECT_CONTAINS(refusal("format ascii 1.0\n", ""), "no \"format\"");
  EXPECT_CONTAINS(refusal("ascii", "morse"), "morse");
  EXPECT_CONTAINS(refusal("1.0", "2.0"), "line 2: version");
  EXPECT_CONTAINS(refusal("float x", "quaternion x"), "quaternion");
  EXPECT_CONTAINS(refusal("float x", "float u"), "no property \"x\"");
  EXPECT_CONTAINS(refusal("vertex_indices", "corners"), "vertex_indices");
  EXPECT_CONTAINS(refusal("element vertex", "element point"), "no element \"vertex\"");
  EXPECT_CONTAINS(refusal("element face", "element vertex"), "second element");
  EXPECT_CONTAINS(refusal("element face 2", "element face -2"), "-2");
  EXPECT_CONTAINS(refusal("comment", "property"), "line 3");
  EXPECT_CONTAINS(refusal("element face", "element tristrips"), "triangle strips");
  EXPECT_CONTAINS(refusalOf(folder.put("b.ply", replaced(kText, "end_header\n", "comment ").substr(0, 190))),
                  "end_header");
}

}  // namespace
}  // namespace thicken
