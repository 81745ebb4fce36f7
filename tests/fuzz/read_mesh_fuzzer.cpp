// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The property of every reader, for libFuzzer: whatever bytes a file holds, reading it gives a mesh whose
// indices are in range, or a refusal that names the file. A mesh that can be written reads back as it was.
// Crashes, endless loops and memory beyond reason are libFuzzer's and the sanitizers' to find.
//
// THICKEN_FUZZ_NAME is the name of the file, with the extension that tells the format.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken {
namespace {

namespace fs = std::filesystem;

// libFuzzer keeps the input of a program that aborts.
void require(bool holds, const std::string& otherwise) {
  if (holds) return;
  std::fprintf(stderr, "property: %s\n", otherwise.c_str());
  std::abort();
}

// A folder of this process's own below TMPDIR, which scripts/fuzz puts into memory and removes.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "thicken-fuzz-XXXXXX").string();
    require(::mkdtemp(name.data()) != nullptr, "there is no folder for the files");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// The corners in sequence. The order of the vertices is not kept by formats that store corners.
std::vector<Vec3> cornersOf(const TriangleMesh& mesh) {
  std::vector<Vec3> corners;
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) corners.push_back(mesh.positions[v]);
  }
  return corners;
}

bool isFinite(const TriangleMesh& mesh) {
  for (const Vec3& position : mesh.positions) {
    if (!position.allFinite()) return false;
  }
  return true;
}

void requireIndicesInRange(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const VertexId v : triangle) {
      require(v < mesh.positions.size(), "a triangle names a vertex that is not there");
      used[v] = true;
    }
  }
  for (const bool is : used) require(is, "a vertex is left that no triangle uses");
}

void requireGoodRefusal(const Error& error, const fs::path& file) {
  const std::string_view sentence = error.what();
  require(error.code() == ErrorCode::kUnreadable || error.code() == ErrorCode::kTooLarge,
          "the refusal has the code of something else: " + std::string(sentence));
  require(sentence.find(file.filename().string()) != std::string_view::npos && sentence.ends_with('.'),
          "the refusal is no sentence that names the file: " + std::string(sentence));
  for (const char c : sentence) require(static_cast<unsigned char>(c) >= 0x20, "a control character");
}

void requireReadsBack(const TriangleMesh& mesh, const fs::path& file) {
  writeMesh(file, mesh);
  require(cornersOf(readMesh(file)) == cornersOf(mesh), "the mesh does not read back as it was written");
}

void tryBytes(std::string_view bytes) {
  static const Folder folder;
  const fs::path file = folder.path() / THICKEN_FUZZ_NAME;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    const TriangleMesh mesh = readMesh(file);
    requireIndicesInRange(mesh);
    if (!mesh.triangles.empty() && isFinite(mesh)) requireReadsBack(mesh, file);
  } catch (const Error& error) {
    requireGoodRefusal(error, file);
  }
}

}  // namespace
}  // namespace thicken

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  thicken::tryBytes({reinterpret_cast<const char*>(data), size});
  return 0;
}
