// SPDX-License-Identifier: LGPL-2.1-or-later
//
// SHA-256 (FIPS 180-4): what `sha256sum` prints. It tells whether bytes are the same; no secret depends on
// it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace thicken::io {

class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The digest of all that was added, as 64 hexadecimal digits. Nothing may be added after it.
  [[nodiscard]] std::string digits();

 private:
  static constexpr std::size_t kBlock = 64;  // bytes

  void addBlock(const unsigned char* block);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, kBlock> rest_{};  // bytes that do not fill a block yet
  std::uint64_t length_ = 0;                  // bytes that were added
};

/// The digest of a regular file's bytes; nothing where it cannot be read.
[[nodiscard]] std::optional<std::string> sha256Of(const std::filesystem::path& path);

}  // namespace thicken::io
