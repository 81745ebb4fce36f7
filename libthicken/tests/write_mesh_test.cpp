// SPDX-License-Identifier: LGPL-2.1-or-later
#include <zip.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "io/formats.h"
#include "io/target_file.h"
#include "scratch_folder.h"

namespace thicken {
namespace {

using namespace test;
namespace fs = std::filesystem;

// A strip of triangles in which every vertex is used first in its own order, as weld() leaves it.
TriangleMesh strip(std::vector<Vec3> positions) {
  TriangleMesh mesh{std::move(positions), {}};
  for (VertexId v = 2; v < mesh.positions.size(); ++v) mesh.triangles.push_back({v - 2, v - 1, v});
  return mesh;
}

TriangleMesh stripOfDoubles() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::vector<Vec3> positions{{-0.0, 0.1, 1.0 / 3},
                              {1e300, -1e300, 1e-300},
                              {5e-324, -5e-324, 2.5},
                              {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 1}};
  for (int i = 0; i < 2000; ++i)
    positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return strip(positions);
}

TriangleMesh stripOfFloats() {
  std::mt19937 random(6);
  std::uniform_real_distribution<float> coordinate(-100, 100);
  std::vector<Vec3> positions{
      {-0.0, double{0.1f}, 0.25},
      {double{std::numeric_limits<float>::max()}, double{std::numeric_limits<float>::denorm_min()}, 1},
      {double{1e-30f}, double{-1e30f}, 2}};
  for (int i = 0; i < 2000; ++i) {
    const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
    positions.emplace_back(x, y, z);
  }
  return strip(positions);
}

TEST(WriteMesh, IsReadBackBitForBitInEveryFormat) {
  const ScratchFolder folder;
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.3mf"}) {
    SCOPED_TRACE(name);
    writeMesh(folder / name, stripOfDoubles());
    expectSame(readMesh(folder / name), stripOfDoubles());
  }
  for (const char* name : {"a.stl", "b.ply", "b.obj", "B.OFF"}) {
    SCOPED_TRACE(name);
    writeMesh(folder / name, stripOfFloats());
    expectSame(readMesh(folder / name), stripOfFloats());
  }
}

TEST(WriteMesh, GivesTheSameBytesEveryTime) {
  const ScratchFolder folder;
  for (const char* extension : {"stl", "ply", "obj", "off", "3mf"}) {
    SCOPED_TRACE(extension);
    const std::string first = std::string("first.") + extension, second = std::string("second.") + extension;
    writeMesh(folder / first, stripOfFloats());
    ::setenv("TZ", "Asia/Tokyo", 1);
    writeMesh(folder / second, stripOfFloats());
    ::unsetenv("TZ");
    EXPECT_EQ(bytesOf(folder / first), bytesOf(folder / second));
  }
}

float floatAt(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(std::array{bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]});
}

TEST(WriteMesh, WritesBinaryStlThatNobodyTakesForText) {
  const ScratchFolder folder;
  writeMesh(folder / "a.stl", {{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}, {0, 0, 2}}, {{0, 1, 2}, {0, 2, 3}}});
  const std::string bytes = bytesOf(folder / "a.stl");
  ASSERT_EQ(bytes.size(), 84u + 2 * 50u);
  EXPECT_FALSE(bytes.starts_with("solid"));
  const auto number = [&bytes](std::size_t at) { return floatAt(bytes, at); };
  EXPECT_EQ(number(84), 0);
  EXPECT_EQ(number(88), -1);
  EXPECT_EQ(number(92), 0);
  for (const std::size_t k : {0u, 4u, 8u})
    EXPECT_EQ(number(134 + k), 0);  // no normal: the triangle is degenerate
}

// What ADMesh computes for needles, and calls an error in a file without it.
TEST(WriteMesh, GivesNeedlesTheNormalsThatAdmeshFinds) {
  const ScratchFolder folder;
  const auto normalOf = [&](const Vec3& b, const Vec3& c) {
    writeMesh(folder / "a.stl", {{{0, 0, 0}, b, c}, {{0, 1, 2}}});
    const std::string bytes = bytesOf(folder / "a.stl");
    return Vec3(floatAt(bytes, 84), floatAt(bytes, 88), floatAt(bytes, 92));
  };
  const auto f = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  EXPECT_EQ(normalOf({f(0.1), 0, f(0.7)}, {f(0.11), 0, f(0.77)}), Vec3(0, 1, 0));  // in truth (0, −1, 0)
  EXPECT_EQ(normalOf({f(1e-7), 0, 0}, {0, f(1e-7), 0}), Vec3(0, 0, 0));
  EXPECT_TRUE(normalOf({f(1e30), 0, 0}, {0, f(1e30), 0}).isApprox(Vec3(0, 0, 1)));
}

TEST(WriteMesh, RefusesToRoundForStl) {
  const ScratchFolder folder;
  for (const double x : {0.1, 1e39, 1e-50}) {
    try {
      writeMesh(folder / "a.stl", {{{0, 0, 0}, {1, 0, 0}, {x, 1, 0}}, {{0, 1, 2}}});
      ADD_FAILURE() << x << " was written";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritable);
      EXPECT_CONTAINS(error.what(), "vertex 2");
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(WriteMesh, RefusesMeshesThatAreNone) {
  const ScratchFolder folder;
  for (const char* name : {"a.stl", "a.ply", "a.obj", "a.off", "a.3mf"}) {
    SCOPED_TRACE(name);
    EXPECT_THROW(writeMesh(folder / name, {{{0, 0, 0}, {1, 0, 0}, {std::nan(""), 1, 0}}, {{0, 1, 2}}}),
                 Error);
    EXPECT_THROW(writeMesh(folder / name, {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}}), Error);
  }
  EXPECT_TRUE(folder.names().empty());
}

std::string unpacked(zip_t* archive, const char* part) {
  zip_stat_t facts;
  if (zip_stat(archive, part, 0, &facts) != 0) return {};
  std::string text(facts.size, '\0');
  zip_file_t* file = zip_fopen(archive, part, 0);
  EXPECT_EQ(zip_fread(file, text.data(), text.size()), static_cast<zip_int64_t>(text.size()));
  zip_fclose(file);
  return text;
}

TEST(WriteMesh, Writes3mfThatHoldsTheMesh) {
  const ScratchFolder folder;
  const TriangleMesh mesh{{{-0.0, 0.1, 1e-300}, {1.0 / 3, 2, 1e20}, {0, 5, 6}}, {{0, 1, 2}}};
  writeMesh(folder / "a.3mf", mesh);
  int error = 0;
  zip_t* archive = zip_open((folder / "a.3mf").c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &error);
  ASSERT_NE(archive, nullptr) << error;
  EXPECT_EQ(zip_get_num_entries(archive, 0), 4);
  EXPECT_CONTAINS(unpacked(archive, "[Content_Types].xml"),
                  "application/vnd.ms-package.3dmanufacturing-3dmodel+xml");
  EXPECT_CONTAINS(unpacked(archive, "_rels/.rels"), "Target=\"/3D/3dmodel.model\"");
  EXPECT_CONTAINS(unpacked(archive, "_rels/.rels"), "Target=\"/Metadata/thumbnail.png\"");
  EXPECT_CONTAINS(unpacked(archive, "[Content_Types].xml"), "image/png");
  EXPECT_TRUE(unpacked(archive, "Metadata/thumbnail.png").starts_with("\x89PNG"));
  const std::string model = unpacked(archive, "3D/3dmodel.model");
  EXPECT_CONTAINS(model, "unit=\"millimeter\"");
  EXPECT_CONTAINS(model,
                  "<vertices>\n<vertex x=\"-0\" y=\"0.1\" z=\"1e-300\"/>\n"
                  "<vertex x=\"0.3333333333333333\" y=\"2\" z=\"1e+20\"/>\n<vertex x=\"0\" y=\"5\" "
                  "z=\"6\"/>\n</vertices>");
  EXPECT_CONTAINS(model, "<triangles>\n<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n</triangles>");
  zip_discard(archive);
}

TEST(WriteMeshes, MakesAnObjectOfEachIn3mf) {
  const ScratchFolder folder;
  const std::vector<TriangleMesh> meshes{twoTriangles(), {{{7, 0, 0}, {8, 0, 0}, {7, 1, 0}}, {{0, 1, 2}}}};
  EXPECT_EQ(pathsOfMeshes("a.3mf", 2), (std::vector<fs::path>{"a.3mf"}));
  writeMeshes(folder / "a.3mf", meshes);
  int error = 0;
  zip_t* archive = zip_open((folder / "a.3mf").c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &error);
  ASSERT_NE(archive, nullptr) << error;
  const std::string model = unpacked(archive, "3D/3dmodel.model");
  zip_discard(archive);
  EXPECT_CONTAINS(model, "<object id=\"1\"");
  const auto second = model.find("<object id=\"2\"");
  ASSERT_NE(second, std::string::npos);
  EXPECT_GT(model.find("x=\"7\""), second);
  EXPECT_CONTAINS(model, "<item objectid=\"1\"/><item objectid=\"2\"/>");
}

TEST(WriteMeshes, RegionsBecomeColoursIn3mf) {
  const ScratchFolder folder;
  const std::vector<TriangleMesh> meshes{twoTriangles(), {{{7, 0, 0}, {8, 0, 0}, {7, 1, 0}}, {{0, 1, 2}}}};
  const std::vector<std::vector<Region>> regions{{Region::kShell, Region::kWall}, {Region::kOriginal}};
  writeMeshes(folder / "a.3mf", meshes, regions);
  int error = 0;
  zip_t* archive = zip_open((folder / "a.3mf").c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &error);
  ASSERT_NE(archive, nullptr) << error;
  const std::string model = unpacked(archive, "3D/3dmodel.model");
  zip_discard(archive);
  EXPECT_CONTAINS(model,
                  "<basematerials id=\"3\"><base name=\"surface\" displaycolor=\"#ECC95C\"/>"
                  "<base name=\"shell\" displaycolor=\"#6E96CD\"/><base name=\"wall\" "
                  "displaycolor=\"#C85246\"/></basematerials>");
  EXPECT_CONTAINS(model,
                  "<triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"3\" p1=\"1\"/>\n<triangle v1=\"0\" "
                  "v2=\"2\" v3=\"3\" pid=\"3\" p1=\"2\"/>");
  EXPECT_CONTAINS(model, "<triangle v1=\"0\" v2=\"1\" v3=\"2\" pid=\"3\" p1=\"0\"/>");
  EXPECT_TRUE(holdsColours("a.3mf"));
  EXPECT_FALSE(holdsColours("a.stl"));
  EXPECT_THROW(writeMeshes(folder / "a.ply", meshes, regions), Error);
  EXPECT_THROW(writeMeshes(folder / "b.3mf", meshes, std::span(regions).first(1)), Error);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.3mf"}));
}

TEST(WriteMeshes, NumbersFilesOfOtherFormatsAndWritesAllOrNone) {
  const ScratchFolder folder;
  const std::vector<TriangleMesh> meshes{twoTriangles(), twoTriangles()};
  writeMeshes(folder / "a.stl", meshes);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a-1.stl", "a-2.stl"}));
  expectSame(readMesh(folder / "a-2.stl"), twoTriangles());
  const std::vector<TriangleMesh> bad{twoTriangles(), {{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
  EXPECT_THROW(writeMeshes(folder / "b.stl", bad), Error);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a-1.stl", "a-2.stl"}));
  writeMeshes(folder / "c.stl", std::span(meshes).first(1));
  EXPECT_TRUE(fs::exists(folder / "c.stl")) << "one mesh needs no number";
}

TEST(WriteMesh, ReplacesAFileWholeOrNotAtAll) {
  const ScratchFolder folder;
  folder.put("a.stl", "what was there");
  EXPECT_THROW(writeMesh(folder / "a.stl", {{{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}), Error);
  EXPECT_EQ(bytesOf(folder / "a.stl"), "what was there");
  writeMesh(folder / "a.stl", twoTriangles());
  expectSame(readMesh(folder / "a.stl"), twoTriangles());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.stl"}));
}

TEST(WriteMesh, WritesThroughALinkAndLeavesItALink) {
  const ScratchFolder folder;
  fs::create_directory(folder / "parts");
  fs::create_symlink(folder / "parts/real.ply", folder / "link.ply");
  folder.put("parts/real.ply", "old");
  writeMesh(folder / "link.ply", twoTriangles());
  EXPECT_TRUE(fs::is_symlink(folder / "link.ply"));
  fs::create_symlink("parts/new.ply", folder / "fresh.ply");  // there is no such file yet
  writeMesh(folder / "fresh.ply", twoTriangles());
  EXPECT_TRUE(fs::is_symlink(folder / "fresh.ply"));
  EXPECT_TRUE(fs::is_regular_file(folder / "parts/new.ply"));
  expectSame(readMesh(folder / "parts/real.ply"), twoTriangles());
}

TEST(WriteMesh, SaysWhyAFileCannotBeWritten) {
  const ScratchFolder folder;
  fs::create_directory(folder / "folder.stl");
  const auto refusal = [](const fs::path& path) -> std::string {
    try {
      writeMesh(path, twoTriangles());
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kUnwritable);
      return error.what();
    }
    ADD_FAILURE() << path << " was written";
    return {};
  };
  EXPECT_CONTAINS(refusal(folder / "folder.stl"), "is a folder");
  EXPECT_CONTAINS(refusal(folder / "missing/a.stl"), "No such file or directory");
  EXPECT_CONTAINS(refusal(folder / "a.vtp"), ".stl, .ply, .obj, .off and .3mf");
  EXPECT_CONTAINS(refusal(folder / "a"), "no extension");
  EXPECT_CONTAINS(refusal("/proc/a.stl"), "No such file or directory");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"folder.stl"}));
}

TEST(WriteMesh, RespectsWriteProtection) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is write-protected for root";
  const ScratchFolder folder;
  folder.put("a.stl", "precious");
  fs::permissions(folder / "a.stl", fs::perms::owner_read);
  EXPECT_THROW(writeMesh(folder / "a.stl", twoTriangles()), Error);
  EXPECT_EQ(bytesOf(folder / "a.stl"), "precious");
}

TEST(TargetFile, LeavesNothingBehindWhenItIsNotCommitted) {
  const ScratchFolder folder;
  EXPECT_THROW(
      {
        io::TargetFile file(folder / "a.stl");
        file.write("half of it");
        EXPECT_EQ(folder.names().size(), 1u);
        throw std::runtime_error("anything");
      },
      std::runtime_error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(TargetFile, IsRemovedByAbandonWrites) {
  const ScratchFolder folder;
  io::TargetFile file(folder / "a.stl"), other(folder / "b.stl");
  file.write("half of it");
  EXPECT_EQ(folder.names().size(), 2u);
  abandonWrites();
  EXPECT_TRUE(folder.names().empty());
  EXPECT_THROW(file.commit(), Error);
}

TEST(TargetFile, ReportsAFullDisk) {
  // Every write to this device fails as on a full disk; a link gets the writer to it.
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const ScratchFolder folder;
  fs::create_symlink("/dev/full", folder / "a.stl");
  EXPECT_THROW(writeMesh(folder / "a.stl", twoTriangles()), Error);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.stl"}));
}

TEST(StoredPrecision, IsSingleForStlAlone) {
  EXPECT_EQ(storedPrecision("a.stl"), Precision::kSingle);
  EXPECT_EQ(storedPrecision("folder.ply/a.Stl"), Precision::kSingle);
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.3mf", "a", "stl"})
    EXPECT_EQ(storedPrecision(name), Precision::kDouble);
}

TEST(RequireWritable, KnowsTheFormatsByTheirExtension) {
  for (const char* name : {"a.stl", "a.PLY", "a.obj", "a.Off", "a.3mf"})
    EXPECT_NO_THROW(requireWritable(name)) << name;
  for (const char* name : {"a.vtp", "a", ".stl", "a.stl.gz", ""})
    EXPECT_THROW(requireWritable(name), Error) << name;
  for (const char* name : {"a.stl", "a.PLY", "a.obj", "a.Off", "a.3mf"})
    EXPECT_NO_THROW(requireReadable(name)) << name;
  for (const char* name : {"a.vtp", "a", ""}) EXPECT_THROW(requireReadable(name), Error) << name;
}

}  // namespace
}  // namespace thicken
