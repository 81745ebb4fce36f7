// SPDX-License-Identifier: LGPL-2.1-or-later
//
// OFF with the variants STOFF, COFF, NOFF and their combinations: what follows the coordinates on a
// vertex's line (normals, colours, texture coordinates) and the indices on a face's line is passed.
#include "io/foreign_file.h"
#include "io/formats.h"
#include "io/number_text.h"
#include "io/polygon_soup.h"
#include "io/text_scanner.h"

namespace thicken::io {
namespace {

// "0 0 0" and a line end; "0" and a line end, since faces without corners get a sentence of their own.
constexpr std::size_t kLeastVertexBytes = 6;
constexpr std::size_t kLeastFaceBytes = 2;

void readKeyword(TextScanner& text) {
  const std::string_view keyword = text.word();
  std::string_view rest = keyword;
  for (const std::string_view prefix : {"ST", "C", "N"}) {
    if (rest.starts_with(prefix)) rest.remove_prefix(prefix.size());
  }
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF") {
    text.fail("holds points of another dimension than three (" + quotedWord(keyword) + ")");
  }
  if (rest != "OFF")
    text.fail("begins with " + quotedWord(keyword) + " and not with \"OFF\"; this is no OFF file");
}

void readFace(TextScanner& text, PolygonSoup& soup) {
  // A corner takes two bytes at least: its index and a blank.
  const std::size_t corners = text.count("the number of corners", text.bytesLeft() / 2 + 1);
  if (corners < 3) text.fail("a face has " + std::to_string(corners) + " corners; it takes three at least");
  for (std::size_t k = 0; k < corners; ++k) {
    const std::string_view word = text.word();
    const auto index = toInteger(word);
    if (!index) text.failNoNumber(word, "the index of a corner");
    if (*index < 0 || static_cast<std::uint64_t>(*index) >= soup.positions.size()) {
      text.fail("there is no vertex " + quotedWord(word) + "; the file has " +
                std::to_string(soup.positions.size()) + ", counted from 0");
    }
    soup.corners.push_back(static_cast<VertexId>(*index));
  }
  soup.sizes.push_back(static_cast<std::uint32_t>(corners));
  text.skipLine();
}

}  // namespace

TriangleMesh readOff(const SourceFile& file) {
  refuseForeign(file);
  TextScanner text(file, {.comment = '#'});
  readKeyword(text);
  const std::size_t vertices = text.count("the number of vertices", file.bytes().size() / kLeastVertexBytes);
  const std::size_t faces = text.count("the number of faces", file.bytes().size() / kLeastFaceBytes);
  text.skipLine();  // the number of edges, which may be missing

  PolygonSoup soup;
  soup.positions.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const double x = text.number("the x coordinate");
    const double y = text.numberInLine("the y coordinate");
    const double z = text.numberInLine("the z coordinate");
    soup.positions.emplace_back(x, y, z);
    text.skipLine();
  }
  soup.corners.reserve(3 * faces);
  soup.sizes.reserve(faces);
  for (std::size_t i = 0; i < faces; ++i) readFace(text, soup);
  if (!text.atEnd()) {
    text.fail(quotedWord(text.word()) + " comes after the " + std::to_string(faces) +
              " faces that the file announces");
  }
  return triangulated(std::move(soup), file);
}

}  // namespace thicken::io
