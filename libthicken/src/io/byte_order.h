// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers in files, in the byte order of the file.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>

namespace thicken::io {

/// The number of type T whose bytes, in `order`, start at `bytes` (any alignment).
template <class T>
[[nodiscard]] T load(const char* bytes, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// Appends `value` to `bytes`, least significant byte first.
template <class T>
void appendLittle(std::string& bytes, T value) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

}  // namespace thicken::io
