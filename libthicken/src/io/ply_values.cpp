// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/ply_values.h"

#include <cmath>
#include <limits>
#include <optional>

#include "io/byte_order.h"
#include "io/number_text.h"

namespace thicken::io {
namespace {

std::optional<std::int64_t> wholeOf(double value) {
  constexpr double kMost = 0x1p53;  // every whole number up to it is a double
  if (!(std::abs(value) <= kMost) || value != std::trunc(value)) return {};
  return static_cast<std::int64_t>(value);
}

}  // namespace

std::string_view PlyText::next() {
  const std::string_view word = firstInElement_ || !byLines_ ? text_.word() : text_.wordInLine();
  if (word.empty()) {
    text_.fail(text_.bytesLeft() == 0
                   ? "the file ends before all that its header announces; it seems to be cut off"
                   : "the line has fewer values than the header announces");
  }
  firstInElement_ = false;
  return word;
}

bool PlyText::hasALineForEach(const SourceFile& file, const PlyHeader& header) {
  std::size_t elements = 0;
  for (const PlyElement& element : header.elements)
    if (!element.properties.empty()) elements += element.count;
  TextScanner lines(file, {}, header.dataOffset, header.dataLine);
  std::size_t count = 0;
  for (; !lines.atEnd(); lines.skipLine()) ++count;
  return count == elements;
}

void PlyText::endElement() {
  if (!byLines_) return;
  const std::string_view word = text_.wordInLine();
  if (!word.empty()) {
    text_.fail("the line has more values than the header announces, " + quotedWord(word) +
               " and what follows");
  }
}

double PlyText::number(PlyType) {
  const std::string_view word = next();
  const auto value = toDouble(word);
  if (!value) text_.failNoNumber(word, "a coordinate");
  return *value;
}

std::int64_t PlyText::integer(PlyType type) {
  const std::string_view word = next();
  std::optional<std::int64_t> value = toInteger(word);
  if (!value && isReal(type)) {
    if (const auto real = toDouble(word)) value = wholeOf(*real);
  }
  if (!value) text_.fail(quotedWord(word) + " stands where a whole number is due");
  return *value;
}

void PlyText::pass(PlyType, std::size_t values) {
  for (std::size_t i = 0; i < values; ++i) next();
}

template <class T>
T PlyBytes::next() {
  if (bytesLeft() < sizeof(T))
    fail("the file ends before all that its header announces; it seems to be cut off");
  const T value = load<T>(file_.bytes().data() + at_, order_);
  at_ += sizeof(T);
  return value;
}

double PlyBytes::number(PlyType type) {
  if (type == PlyType::kFloat) return next<float>();
  if (type == PlyType::kDouble) return next<double>();
  return static_cast<double>(integer(type));
}

std::int64_t PlyBytes::integer(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
      return next<std::int8_t>();
    case PlyType::kUint8:
      return next<std::uint8_t>();
    case PlyType::kInt16:
      return next<std::int16_t>();
    case PlyType::kUint16:
      return next<std::uint16_t>();
    case PlyType::kInt32:
      return next<std::int32_t>();
    case PlyType::kUint32:
      return next<std::uint32_t>();
    case PlyType::kInt64:
      return next<std::int64_t>();
    case PlyType::kUint64: {
      const auto value = next<std::uint64_t>();
      constexpr std::uint64_t kMost = std::numeric_limits<std::int64_t>::max();
      if (value > kMost) fail(std::to_string(value) + " is too large a number");
      return static_cast<std::int64_t>(value);
    }
    case PlyType::kFloat:
    case PlyType::kDouble:
      break;
  }
  const double real = number(type);
  const auto value = wholeOf(real);
  if (!value) fail("the number " + std::to_string(real) + " stands where a whole number is due");
  return *value;
}

void PlyBytes::pass(PlyType type, std::size_t values) {
  if (bytesLeft() / sizeOf(type) < values) {
    fail("the file ends before all that its header announces; it seems to be cut off");
  }
  at_ += values * sizeOf(type);
}

// Some programs fill a file up to whole blocks.
bool PlyBytes::atEnd() const {
  return file_.bytes().find_first_not_of(std::string_view("\0 \r\n\t", 5), at_) == std::string_view::npos;
}

}  // namespace thicken::io
