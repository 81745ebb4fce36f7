// SPDX-License-Identifier: LGPL-2.1-or-later
//
// STL, binary and ASCII. Single precision in either case: text is rounded to float, so that equal
// corners stay equal whatever digits they were written with.
#include <algorithm>

#include "io/byte_order.h"
#include "io/foreign_file.h"
#include "io/formats.h"
#include "io/polygon_soup.h"
#include "io/text_scanner.h"

namespace thicken::io {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kPreambleBytes = kHeaderBytes + 4;  // with the number of facets
constexpr std::size_t kFacetBytes = 50;                   // normal, three corners, attribute
constexpr std::size_t kNormalBytes = 12;
constexpr std::size_t kCornerBytes = 12;

char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool is(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, {}, lower);
}

std::size_t announcedFacets(std::string_view bytes) {
  return bytes.size() < kPreambleBytes
             ? 0
             : load<std::uint32_t>(bytes.data() + kHeaderBytes, std::endian::little);
}

TriangleMesh readBinary(const SourceFile& file) {
  const std::string_view bytes = file.bytes();
  const std::size_t facets = announcedFacets(bytes);
  requireNameable(3 * facets, "corners", file);
  TriangleMesh mesh;
  mesh.positions.reserve(3 * facets);
  mesh.triangles.reserve(facets);
  const char* facet = bytes.data() + kPreambleBytes;
  for (std::size_t i = 0; i < facets; ++i, facet += kFacetBytes) {
    for (int k = 0; k < 3; ++k) {
      const char* const corner = facet + kNormalBytes + k * kCornerBytes;
      mesh.positions.emplace_back(load<float>(corner, std::endian::little),
                                  load<float>(corner + 4, std::endian::little),
                                  load<float>(corner + 8, std::endian::little));
    }
    const auto first = static_cast<VertexId>(3 * i);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

void expect(TextScanner& text, std::string_view keyword) {
  const std::string_view word = text.word();
  if (is(word, keyword)) return;
  const std::string due = quotedWord(keyword);
  if (word.empty()) text.fail("the file ends where " + due + " is due; it seems to be cut off");
  text.fail(quotedWord(word) + " stands where " + due + " is due");
}

// What follows the word "facet".
void readFacet(TextScanner& text, TriangleMesh& mesh) {
  expect(text, "normal");
  // The normal does not count, and some programs print things like -nan(ind) for it.
  for (int k = 0; k < 3; ++k) text.word();
  expect(text, "outer");
  expect(text, "loop");
  for (int k = 0; k < 3; ++k) {
    expect(text, "vertex");
    const float x = text.single("the x coordinate");
    const float y = text.single("the y coordinate");
    const float z = text.single("the z coordinate");
    mesh.positions.emplace_back(x, y, z);
  }
  expect(text, "endloop");
  expect(text, "endfacet");
  const auto end = static_cast<VertexId>(mesh.positions.size());
  mesh.triangles.push_back({end - 3, end - 2, end - 1});
}

// Any number of "solid NAME … endsolid NAME".
TriangleMesh readAscii(const SourceFile& file) {
  TextScanner text(file, {});
  TriangleMesh mesh;
  do {
    expect(text, "solid");
    text.skipLine();
    for (std::string_view word = text.word(); !is(word, "endsolid"); word = text.word()) {
      if (word.empty() && !mesh.triangles.empty()) {
        file.passOver("the file ends without \"endsolid\", after " + std::to_string(mesh.triangles.size()) +
                      " triangles; it may be cut off");
        return mesh;
      }
      if (word.empty()) text.fail("the file ends before \"endsolid\"; it seems to be cut off");
      if (!is(word, "facet")) text.fail(quotedWord(word) + " stands where \"facet\" or \"endsolid\" is due");
      readFacet(text, mesh);
    }
    text.skipLine();
    requireNameable(mesh.positions.size(), "corners", file);
  } while (!text.atEnd());
  return mesh;
}

// Some programs fill a file up to whole blocks.
bool isPadding(std::string_view bytes) {
  return bytes.find_first_not_of(std::string_view("\0 \r\n\t", 5)) == std::string_view::npos;
}

// No byte that text does not have, at least as far as the number of facets of a binary file reaches.
bool looksLikeText(std::string_view bytes) {
  return std::ranges::none_of(bytes.substr(0, 512), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v';
  });
}

// Some programs leave notes of their own behind the triangles.
void passOverRest(const SourceFile& file, std::size_t facets, std::size_t rest) {
  std::string note = std::to_string(rest) + " bytes after the " + std::to_string(facets) +
                     " triangles that the file announces were passed over";
  if (rest % kFacetBytes == 0)
    note += "; " + std::to_string(rest / kFacetBytes) +
            " more triangles would take as many: the number that it announces may be wrong";
  file.passOver(note);
}

}  // namespace

// The size tells a binary file, whatever its header says: many of them begin with "solid".
TriangleMesh readStl(const SourceFile& file) {
  const std::string_view bytes = file.bytes();
  const std::size_t facets = announcedFacets(bytes);
  const std::size_t expected = kPreambleBytes + kFacetBytes * facets;
  if (bytes.size() == expected && facets > 0) return readBinary(file);
  refuseForeign(file);
  if (bytes.size() == expected) return readBinary(file);
  if (looksLikeText(bytes)) {
    TextScanner text(file, {});
    const std::string_view word = text.word();
    if (is(word, "solid")) return readAscii(file);
    text.fail("begins with " + quotedWord(word) + " and not with \"solid\"; this is no STL file");
  }
  if (bytes.size() < kPreambleBytes) {
    file.fail("has " + std::to_string(bytes.size()) + " bytes, fewer than the " +
              std::to_string(kPreambleBytes) + " of the header of a binary STL file; it seems to be cut off");
  }
  if (bytes.size() < expected) {
    file.failAtByte(kHeaderBytes, "announces " + std::to_string(facets) + " triangles, which take " +
                                      std::to_string(expected) + " bytes, but the file has only " +
                                      std::to_string(bytes.size()) + "; it is cut off or no STL file");
  }
  const std::string_view rest = bytes.substr(expected);
  if (!isPadding(rest)) {
    if (facets == 0)
      file.failAtByte(kHeaderBytes, "announces no triangles, but there is more; it is no STL file");
    passOverRest(file, facets, rest.size());
  }
  return readBinary(file);
}

}  // namespace thicken::io
