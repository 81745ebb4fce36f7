// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The header of a PLY file: which elements follow, and what each of them is made of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/source_file.h"

namespace thicken::io {

enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble
};
[[nodiscard]] std::size_t sizeOf(PlyType type) noexcept;
[[nodiscard]] inline bool isReal(PlyType type) noexcept {
  return type >= PlyType::kFloat;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat;    ///< of the value, or of every entry of the list
  std::optional<PlyType> countType;  ///< of the number of entries; only lists have it
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;  ///< as announced; nothing says yet that the file holds so many
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::size_t dataOffset = 0;  ///< of the first byte after the header
  std::size_t dataLine = 0;    ///< the line that it is on
};

/// Throws Error(kUnreadable).
[[nodiscard]] PlyHeader readPlyHeader(const SourceFile& file);

}  // namespace thicken::io
