// SPDX-License-Identifier: LGPL-2.1-or-later
//
// PNG (ISO/IEC 15948): three chunks, compressed by zlib, which every package with libzip has already.
#include <zlib.h>

#include <new>
#include <string_view>

#include "io/target_file.h"
#include "thicken/error.h"
#include "thicken/picture.h"

namespace thicken {
namespace {

// Most significant byte first, as PNG has all numbers.
void appendBig(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

void appendChunk(std::string& png, std::string_view kind, std::string_view content) {
  appendBig(png, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = png.size();
  png += kind;
  png += content;
  const auto* checked = reinterpret_cast<const Bytef*>(png.data() + begin);
  appendBig(png, static_cast<std::uint32_t>(crc32(0, checked, static_cast<uInt>(png.size() - begin))));
}

// Each pixel less the one above it: what is flat or background becomes 0.
std::string filtered(const Picture& picture) {
  constexpr char kUp = 2;
  std::string rows;
  const auto width = static_cast<std::size_t>(picture.width);
  rows.reserve((3 * width + 1) * static_cast<std::size_t>(picture.height));
  for (std::size_t at = 0; at < picture.pixels.size(); ++at) {
    if (at % width == 0) rows += kUp;
    const Colour above = at < width ? Colour{} : picture.pixels[at - width];
    for (std::size_t k = 0; k < 3; ++k) rows += static_cast<char>(picture.pixels[at][k] - above[k]);
  }
  return rows;
}

std::string compressed(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();  // the only way to fail with a buffer of this size
  result.resize(size);
  return result;
}

}  // namespace

std::string toPng(const Picture& picture) {
  std::string header;
  appendBig(header, static_cast<std::uint32_t>(picture.width));
  appendBig(header, static_cast<std::uint32_t>(picture.height));
  constexpr std::string_view kEightBitsRgb("\x08\x02\0\0\0", 5);
  header += kEightBitsRgb;
  std::string png("\x89PNG\r\n\x1A\n");
  appendChunk(png, "IHDR", header);
  appendChunk(png, "IDAT", compressed(filtered(picture)));
  appendChunk(png, "IEND", {});
  return png;
}

void writePicture(const std::filesystem::path& path, const Picture& picture) {
  io::TargetFile file(path);
  file.write(toPng(picture));
  file.commit();
}

}  // namespace thicken
