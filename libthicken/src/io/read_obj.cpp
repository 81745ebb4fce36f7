// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Wavefront OBJ: the statements v and f. Own code because tinyobjloader (2.0.0rc10) rounds most
// doubles of 17 digits to a neighbour, takes "zero" for 0, and leaves out faces it cannot split.
#include <algorithm>
#include <array>

#include "io/foreign_file.h"
#include "io/formats.h"
#include "io/number_text.h"
#include "io/polygon_soup.h"
#include "io/text_scanner.h"

namespace thicken::io {
namespace {

// Statements that say nothing about the triangles.
constexpr std::array<std::string_view, 38> kPassed{
    "vt",     "vn",     "vp",   "vc",    "g",     "o",     "s",        "mg",       "usemtl",     "mtllib",
    "usemap", "maplib", "l",    "p",     "lod",   "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj",
    "cstype", "deg",    "bmat", "step",  "curv2", "curv",  "parm",     "trim",     "hole",       "scrv",
    "sp",     "end",    "con",  "ctech", "stech", "call",  "csh",      "res"};
// Statements that hold surfaces in a form other than polygons.
constexpr std::array<std::string_view, 5> kRefused{"surf", "bzp", "bsp", "cdc", "cdp"};

class ObjReader {
 public:
  explicit ObjReader(const SourceFile& file)
      : file_(file), text_(file, {.comment = '#', .joinsAtBackslash = true}) {}

  TriangleMesh read() {
    while (!text_.atEnd()) {
      readStatement(text_.word());
      text_.skipLine();
    }
    if (!vertexSeen_)
      file_.fail(
          "holds no vertex (\"v\"); this is no OBJ file of a mesh" +
          (unknown_ > 0 ? ": line " + std::to_string(unknownLine_) + " begins with " + firstUnknown_ : ""));
    if (unknown_ > 0)
      file_.passOver("line " + std::to_string(unknownLine_) + ": " + firstUnknown_ +
                     " is no statement of an OBJ file" +
                     (unknown_ > 1 ? ", nor are " + std::to_string(unknown_ - 1) + " more lines" : "") +
                     "; passed over");
    // Faces may name vertices that come later, so this is known only now.
    if (largestIndex_ > static_cast<std::int64_t>(soup_.positions.size())) {
      file_.failAtLine(largestIndexLine_, "there is no vertex " + std::to_string(largestIndex_) +
                                              "; the file has " + std::to_string(soup_.positions.size()));
    }
    return triangulated(std::move(soup_), file_);
  }

 private:
  void readStatement(std::string_view keyword) {
    if (keyword == "v") {
      readVertex();
    } else if (keyword == "f" || keyword == "fo") {  // fo: the same in files of before 1992
      readFace();
    } else if (std::ranges::find(kRefused, keyword) != kRefused.end()) {
      text_.fail("holds freeform surfaces (" + quotedWord(keyword) +
                 "), which cannot be read; export it as polygons");
    } else if (std::ranges::find(kPassed, keyword) == kPassed.end()) {
      passOver(keyword);
    }
  }

  void passOver(std::string_view keyword) {
    if (++unknown_ > 1) return;
    firstUnknown_ = quotedWord(keyword);
    unknownLine_ = text_.line();
  }

  // What follows the coordinates, a weight or a colour, is passed.
  void readVertex() {
    const double x = text_.numberInLine("the x coordinate");
    const double y = text_.numberInLine("the y coordinate");
    const double z = text_.numberInLine("the z coordinate");
    soup_.positions.emplace_back(x, y, z);
    vertexSeen_ = true;
  }

  void readFace() {
    std::uint32_t corners = 0;
    for (std::string_view word = text_.wordInLine(); !word.empty(); word = text_.wordInLine()) {
      soup_.corners.push_back(readCorner(word));
      ++corners;
    }
    if (corners < 3)
      text_.fail("a face has " + std::to_string(corners) + " corners; it takes three at least");
    soup_.sizes.push_back(corners);
  }

  // "7", "7/1", "7//3", "7/1/3", "-1": vertex, texture and normal index, of which the first counts.
  VertexId readCorner(std::string_view word) {
    const std::string_view number = word.substr(0, word.find('/'));
    const auto index = toInteger(number);
    const bool tailFits = word.find_first_not_of("0123456789-/", number.size()) == std::string_view::npos;
    if (!index || !tailFits) text_.fail(quotedWord(word) + " is no corner of a face");
    if (*index == 0) text_.fail("a face names vertex 0; vertices are counted from 1");
    const auto known = static_cast<std::int64_t>(soup_.positions.size());
    if (*index < -known) {
      text_.fail("a face names vertex " + quotedWord(number) + ", counted back from here, but only " +
                 std::to_string(known) + " vertices come before");
    }
    const std::int64_t absolute = *index > 0 ? *index : known + *index + 1;
    if (absolute > largestIndex_) {
      largestIndex_ = absolute;
      largestIndexLine_ = text_.line();
    }
    return static_cast<VertexId>(absolute - 1);
  }

  const SourceFile& file_;
  TextScanner text_;
  PolygonSoup soup_;
  bool vertexSeen_ = false;
  std::size_t unknown_ = 0, unknownLine_ = 0;  // statements, and the line of the first
  std::string firstUnknown_;
  std::int64_t largestIndex_ = 0;  // counted from 1
  std::size_t largestIndexLine_ = 0;
};

}  // namespace

TriangleMesh readObj(const SourceFile& file) {
  refuseForeign(file);
  return ObjReader(file).read();
}

}  // namespace thicken::io
