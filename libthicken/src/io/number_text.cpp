// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "platform/from_chars.h"

namespace thicken::io {
namespace {

// std::from_chars takes no plus sign.
std::string_view withoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

// Of a number beyond the range of its type: whether it is too large, and not too small.
bool isLarge(std::string_view word) {
  const std::size_t mark = std::min(word.find_first_of("eE"), word.size());
  std::int64_t exponent = 0;
  if (mark < word.size()) {
    const std::string_view text = withoutPlus(word.substr(mark + 1));
    const auto result = std::from_chars(text.data(), text.data() + text.size(), exponent);
    if (result.ec == std::errc::result_out_of_range) return text[0] != '-';
  }
  const std::string_view digits = word.substr(0, mark);
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  return exponent > first - point;
}

template <class T>
std::optional<T> parsed(std::string_view text) {
  const std::string_view word = withoutPlus(text);
  const char* const end = word.data() + word.size();
  T value = 0;
  const auto result = platform::from_chars(word.data(), end, value);
  if (result.ptr != end || word.empty()) return {};
  if (result.ec == std::errc()) return value;
  if (result.ec != std::errc::result_out_of_range) return {};
  // std::from_chars does not tell at which end.
  const T magnitude = isLarge(word) ? std::numeric_limits<T>::infinity() : T(0);
  return word[0] == '-' ? -magnitude : magnitude;
}

template <class T>
void append(std::string& text, T value) {
  std::array<char, 32> digits;  // the longest double takes 24
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

}  // namespace

std::optional<double> toDouble(std::string_view word) {
  return parsed<double>(word);
}

std::optional<float> toFloat(std::string_view word) {
  return parsed<float>(word);
}

std::optional<std::int64_t> toInteger(std::string_view text) {
  const std::string_view word = withoutPlus(text);
  const char* const end = word.data() + word.size();
  std::int64_t value = 0;
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return {};
  return value;
}

void appendNumber(std::string& text, double value) {
  append(text, value);
}

void appendNumber(std::string& text, std::uint32_t value) {
  append(text, value);
}

}  // namespace thicken::io
