// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/formats.h"

#include <algorithm>
#include <array>
#include <string>

namespace thicken::io {
namespace {

constexpr std::array kFormats{
    Format{".stl", readStl, writeStl, Precision::kSingle},
    Format{".ply", readPly, writePly, Precision::kDouble},
    Format{".obj", readObj, writeObj, Precision::kDouble},
    Format{".off", readOff, writeOff, Precision::kDouble},
    Format{".3mf", read3mf, write3mf, Precision::kDouble, writeObjects3mf},
};

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

const Format* formatOf(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  // ASCII only: std::tolower depends on the locale.
  for (char& c : extension) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto* found = std::ranges::find(kFormats, extension, &Format::extension);
  return found == kFormats.end() ? nullptr : &*found;
}

}  // namespace thicken::io
