// SPDX-License-Identifier: LGPL-2.1-or-later
//
// For tests of files: a folder of their own, and what to put into it.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken::test {

/// A new empty folder that goes with the object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "thicken-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

  /// Puts a file of these bytes into the folder.
  std::filesystem::path put(std::string_view name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path_ / name;
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::filesystem::path path_;
};

inline std::string bytesOf(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Positions as bits, so that −0 differs from 0 and NaN equals itself.
inline std::vector<std::array<std::uint64_t, 3>> bitsOf(const std::vector<Vec3>& positions) {
  std::vector<std::array<std::uint64_t, 3>> bits(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    std::memcpy(bits[i].data(), positions[i].data(), sizeof(bits[i]));
  return bits;
}

inline void expectSame(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(bitsOf(a.positions), bitsOf(b.positions));
  EXPECT_EQ(a.triangles, b.triangles);
}

/// The sentence of the error that reading `path` ends with; an empty one after a failed expectation
/// when there is none, when the code is not kUnreadable or the file is not named.
inline std::string refusalOf(const std::filesystem::path& path) {
  try {
    const TriangleMesh mesh = readMesh(path);
    ADD_FAILURE() << path << " was read: " << mesh.triangles.size() << " triangles";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kUnreadable) << error.what();
    EXPECT_NE(std::string(error.what()).find(path.filename().string()), std::string::npos) << error.what();
    return error.what();
  }
  return {};
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << '"' << part << "\" is not in: " << text;
}
#define EXPECT_CONTAINS(text, part) EXPECT_TRUE(contains(text, part))

/// Two triangles that share an edge, with coordinates that are floats.
inline TriangleMesh twoTriangles() {
  return {{{0, 0, 0}, {1.5, 0, 0}, {1.5, 2, 0.25}, {0, 2, -0.125}}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace thicken::test
