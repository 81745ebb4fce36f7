// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/number_text.h"

#include <array>
#include <charconv>

namespace thicken::io {
namespace {

// std::from_chars takes no plus sign.
std::string_view withoutPlus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

template <class T>
std::optional<T> parsed(std::string_view text) {
  const std::string_view word = withoutPlus(text);
  const char* const end = word.data() + word.size();
  T value = 0;
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ptr != end || word.empty()) return {};
  if (result.ec == std::errc()) return value;
  if (result.ec != std::errc::result_out_of_range) return {};
  // Out of range leaves the value alone, whichever end it was; a wider type tells the ends apart.
  long double wide = 0;
  if (std::from_chars(word.data(), end, wide).ec != std::errc()) return {};
  return static_cast<T>(wide);
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
