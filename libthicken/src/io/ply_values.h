// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The values after a PLY header, one after the other, from text or from bytes: two classes of the
// same shape for the reader of elements.
#pragma once

#include <bit>
#include <string>
#include <string_view>

#include "io/ply_header.h"
#include "io/source_file.h"
#include "io/text_scanner.h"

namespace thicken::io {

/// Values as words. Every element has a line of its own, and a line with too many or too few values is an
/// error; but where there are not as many lines as elements, lines mean nothing and are passed over.
class PlyText {
 public:
  PlyText(const SourceFile& file, const PlyHeader& header)
      : text_(file, {}, header.dataOffset, header.dataLine), byLines_(hasALineForEach(file, header)) {
    if (!byLines_)
      file.passOver("the elements have no lines of their own; their values were read one by one");
  }

  void beginElement() { firstInElement_ = true; }
  void endElement();
  /// As the file spells it, in double, whatever the header calls it: "property float x" is common
  /// above coordinates of nine and more digits.
  double number(PlyType type);
  /// Nothing is returned that is no whole number.
  std::int64_t integer(PlyType type);
  void pass(PlyType type, std::size_t values);

  /// Bytes that a value takes at least: a digit and what separates it from the next.
  [[nodiscard]] static std::size_t leastBytes(PlyType) { return 2; }
  [[nodiscard]] std::size_t bytesLeft() const {
    return text_.bytesLeft() + 1;
  }  // the last needs no separator
  [[nodiscard]] bool atEnd() { return text_.atEnd(); }
  [[noreturn]] void fail(const std::string& reason) const { text_.fail(reason); }

 private:
  [[nodiscard]] static bool hasALineForEach(const SourceFile& file, const PlyHeader& header);
  std::string_view next();

  TextScanner text_;
  bool byLines_;
  bool firstInElement_ = true;
};

/// Values as bytes, packed.
class PlyBytes {
 public:
  PlyBytes(const SourceFile& file, const PlyHeader& header, std::endian order)
      : file_(file), at_(header.dataOffset), order_(order) {}

  void beginElement() {}
  void endElement() {}
  double number(PlyType type);
  std::int64_t integer(PlyType type);
  void pass(PlyType type, std::size_t values);

  [[nodiscard]] static std::size_t leastBytes(PlyType type) { return sizeOf(type); }
  [[nodiscard]] std::size_t bytesLeft() const { return file_.bytes().size() - at_; }
  [[nodiscard]] bool atEnd() const;
  [[noreturn]] void fail(const std::string& reason) const { file_.failAtByte(at_, reason); }

 private:
  template <class T>
  T next();

  const SourceFile& file_;
  std::size_t at_;
  std::endian order_;
};

}  // namespace thicken::io
