// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whatever a file holds, reading it ends soon, with a mesh or with a sentence.
#include <sys/stat.h>

#include <random>

#include "io/byte_order.h"
#include "scratch_folder.h"

namespace thicken {
namespace {

using namespace test;
namespace fs = std::filesystem;

// Either a mesh whose indices are in range, or a refusal that names the file.
bool endsWell(const fs::path& path) {
  try {
    const TriangleMesh mesh = readMesh(path);
    for (const Triangle& t : mesh.triangles) {
      for (const VertexId v : t) EXPECT_LT(v, mesh.positions.size());
    }
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnreadable) << error.what();
    EXPECT_CONTAINS(error.what(), path.filename().string());
    EXPECT_EQ(error.what()[std::strlen(error.what()) - 1], '.') << error.what();
    return false;
  }
}

TEST(HostileFile, NamesTheReasonWhenThereIsNoFile) {
  const ScratchFolder folder;
  fs::create_directory(folder / "folder.stl");
  ASSERT_EQ(::mkfifo((folder / "pipe.ply").c_str(), 0600), 0);
  EXPECT_CONTAINS(refusalOf(folder / "missing.stl"), "there is no such file");
  EXPECT_CONTAINS(refusalOf(folder / "folder.stl"), "is a folder");
  EXPECT_CONTAINS(refusalOf(folder / "pipe.ply"), "not a regular file");
  EXPECT_CONTAINS(refusalOf(folder.put("a.vtp", "<VTKFile/>")), ".stl, .ply, .obj, .off and .3mf");
  EXPECT_CONTAINS(refusalOf(folder.put("a", "solid")), "no extension");
  for (const char* name : {"e.stl", "e.ply", "e.obj", "e.off", "e.3mf"})
    EXPECT_CONTAINS(refusalOf(folder.put(name, "")), "is empty");
}

TEST(HostileFile, RefusesOneFormatUnderTheNameOfAnother) {
  const ScratchFolder folder;
  for (const char* from : {"stl", "ply", "obj", "off", "3mf"}) {
    writeMesh(folder / (std::string("a.") + from), twoTriangles());
    const std::string bytes = bytesOf(folder / (std::string("a.") + from));
    for (const std::string to : {"stl", "ply", "obj", "off", "3mf"}) {
      if (to != from) refusalOf(folder.put("wrong." + to, bytes));
    }
  }
}

TEST(HostileFile, AllocatesNothingForWhatAFileOnlyAnnounces) {
  const ScratchFolder folder;
  const std::string vertexProperties = "property float x\nproperty float y\nproperty float z\n";
  const std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string corners = "property list uint int vertex_indices\nend_header\n";
  for (const std::string count : {"4000000000", "4294967295", "9223372036854775807"}) {
    SCOPED_TRACE(count);
    refusalOf(folder.put("v.ply", binary + count + "\n" + vertexProperties + "element face 0\n" + corners));
    refusalOf(
        folder.put("f.ply", binary + "0\n" + vertexProperties + "element face " + count + "\n" + corners));
    refusalOf(folder.put("t.ply", "ply\nformat ascii 1.0\nelement vertex " + count + "\n" + vertexProperties +
                                      "end_header\n0 0 0\n"));
    refusalOf(folder.put("v.off", "OFF\n" + count + " 1 0\n0 0 0\n"));
    refusalOf(folder.put("f.off", "OFF\n1 " + count + " 0\n0 0 0\n"));
  }
  std::string list = binary + "1\n" + vertexProperties + "element face 1\n" + corners + std::string(12, '\0');
  io::appendLittle(list, 0xffffffffu);
  EXPECT_CONTAINS(refusalOf(folder.put("l.ply", list)), "4294967295 entries");
}

TEST(HostileFile, EndsWellCutOffAtAnyByte) {
  const ScratchFolder folder;
  for (const std::string name : {"a.stl", "a.ply", "a.obj", "a.off"}) {
    writeMesh(folder / name, twoTriangles());
    const std::string bytes = bytesOf(folder / name);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      SCOPED_TRACE(name + " of " + std::to_string(size) + " bytes");
      const bool read = endsWell(folder.put("cut" + name.substr(1), std::string_view(bytes).substr(0, size)));
      // Text without its last line end, or cut at the end of a statement, is a file of its own right.
      if (name == "a.stl" || name == "a.ply") {
        EXPECT_FALSE(read);
      }
    }
  }
}

TEST(HostileFile, EndsWellWithAnyBytesChanged) {
  const ScratchFolder folder;
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string name : {"a.stl", "a.ply", "a.obj", "a.off"}) {
    writeMesh(folder / name, twoTriangles());
    files.emplace_back(name, bytesOf(folder / name));
  }
  files.emplace_back(
      "t.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty int z\n"
      "property list uchar int more\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0\n1 0 0 2 1 1\n0 1 0 0\n3 0 1 2\n");
  files.emplace_back("t.stl",
                     "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                     "0\nendloop\nendfacet\nendsolid x\n");
  std::mt19937 random(11);
  const std::string telling = "0123456789-+.eE \n\r\t\\/#vfx" + std::string(1, '\0') + "\xFF\x80";
  std::size_t read = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    auto [name, bytes] = files[static_cast<std::size_t>(round) % files.size()];
    const int changes = 1 + static_cast<int>(random() % 4);
    for (int i = 0; i < changes && !bytes.empty(); ++i) {
      const std::size_t at = random() % bytes.size();
      switch (random() % 4) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          bytes[at] = telling[random() % telling.size()];
          break;
        case 2:
          bytes.erase(at, 1 + random() % 8);
          break;
        default:
          bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 16));
          break;
      }
    }
    ++(endsWell(folder.put("m" + name, bytes)) ? read : refused);
    if (HasFailure()) FAIL() << "round " << round << ": " << name << "\n" << bytes;
  }
  EXPECT_GT(read, 100u);
  EXPECT_GT(refused, 500u);
}

TEST(HostileFile, EndsSoonWhenAHeaderNamesManyElements) {
  const ScratchFolder folder;
  std::string header = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 200000; ++i) header += "element e" + std::to_string(i) + " 0\n";
  EXPECT_CONTAINS(refusalOf(folder.put("a.ply", header + "element e7 0\nend_header\n")), "second element");
}

TEST(HostileFile, EndsSoonWhenAPolygonIsATangle) {
  const ScratchFolder folder;
  std::mt19937 random(12);
  std::string text = "OFF\n60000 1 0\n", face = "60000";
  for (int i = 0; i < 60000; ++i) {
    text += std::to_string(random() % 100000) + ' ' + std::to_string(random() % 100000) + " 0\n";
    face += ' ' + std::to_string(i);
  }
  const auto path = folder.put("a.off", text + face + "\n");
  endsWell(path);
}

// A collection of broken files that is not part of this project; where it is kept beside it, it is tried too.
TEST(HostileFile, EndsWellOnTheCollectionBesideTheProject) {
  const fs::path collection = fs::path(THICKEN_SOURCE_DIR) / "../shared/data/bad";
  if (!fs::is_directory(collection)) GTEST_SKIP() << collection << " is absent";
  for (const auto& entry : fs::directory_iterator(collection)) {
    SCOPED_TRACE(entry.path());
    endsWell(entry.path());
  }
}

}  // namespace
}  // namespace thicken
