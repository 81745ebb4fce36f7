// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/foreign_file.h"

#include <algorithm>
#include <array>

namespace thicken::io {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view beginning;
  const char* sentence;
};

constexpr auto kUtf16 = "is text in UTF-16; save it as UTF-8 or ASCII";
constexpr auto kArchive = "is a packed archive; unpack it, and read the mesh in it";
constexpr auto kZip =
    "is a zip archive, as packed files and .3mf are; unpack it, or name it .3mf if it is one";
constexpr auto kPage = "is a web page and no mesh; download the file itself";

constexpr std::array kKinds{
    Kind{"PK\3\4"sv, kZip},
    Kind{"PK\5\6"sv, kZip},
    Kind{"\x1F\x8B"sv, kArchive},
    Kind{"7z\xBC\xAF"sv, kArchive},
    Kind{"Rar!"sv, kArchive},
    Kind{"\xFF\xFE"sv, kUtf16},
    Kind{"\xFE\xFF"sv, kUtf16},
    Kind{"<!DOCTYPE"sv, kPage},
    Kind{"<!doctype"sv, kPage},
    Kind{"<html"sv, kPage},
    Kind{"%PDF"sv, "is a PDF document and no mesh"},
    Kind{"ISO-10303-21"sv, "is a STEP file; export it as a mesh"},
    Kind{"glTF"sv, "is a binary glTF file (.glb); export it as .ply, .obj or .stl"},
};

// Text in UTF-16 without a byte order mark: of each pair of bytes the same one is 0.
bool isUnmarkedUtf16(std::string_view bytes) {
  constexpr std::size_t kEnough = 64;
  if (bytes.size() < kEnough) return false;
  std::size_t zeros[2] = {0, 0};
  for (std::size_t i = 0; i < kEnough; ++i) zeros[i % 2] += bytes[i] == '\0';
  return (zeros[0] == kEnough / 2 && zeros[1] == 0) || (zeros[1] == kEnough / 2 && zeros[0] == 0);
}

}  // namespace

void refuseForeign(const SourceFile& file) {
  const std::string_view bytes = file.bytes();
  const auto* kind =
      std::ranges::find_if(kKinds, [bytes](const Kind& k) { return bytes.starts_with(k.beginning); });
  if (kind != kKinds.end()) file.fail(kind->sentence);
  if (isUnmarkedUtf16(bytes)) file.fail(kUtf16);
}

}  // namespace thicken::io
