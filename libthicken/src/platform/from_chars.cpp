// SPDX-License-Identifier: LGPL-2.1-or-later
#include "platform/from_chars.h"

#if !defined(__cpp_lib_to_chars)

#include <locale.h>
#include <stdlib.h>
#if defined(__APPLE__)
#include <xlocale.h>
#endif

#include <cerrno>
#include <cmath>
#include <string>

namespace thicken::platform {
namespace {

// What the C library reads and std::from_chars does not: space and a plus sign before the number, and
// hexadecimal ones.
bool isForeign(const std::string& text) {
  return text.find_first_of("xX \t\n\v\f\r") != std::string::npos || text.starts_with('+');
}

// `convert` is the C library's, which otherwise takes the decimal mark of the user's language.
template <class T>
std::from_chars_result converted(T (*convert)(const char*, char**, locale_t), const char* begin,
                                 const char* end, T& value) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string text(begin, end);
  if (isForeign(text)) return {begin, std::errc::invalid_argument};
  char* stop = nullptr;
  errno = 0;
  const T found = convert(text.c_str(), &stop, plain);
  const char* const reached = begin + (stop - text.c_str());
  if (reached == begin) return {begin, std::errc::invalid_argument};
  // Numbers that are small, but not too small, have ERANGE as well.
  if (errno == ERANGE && (found == 0 || std::isinf(found))) return {reached, std::errc::result_out_of_range};
  value = found;
  return {reached, std::errc()};
}

}  // namespace

std::from_chars_result from_chars(const char* begin, const char* end, double& value) {
  return converted(&strtod_l, begin, end, value);
}

std::from_chars_result from_chars(const char* begin, const char* end, float& value) {
  return converted(&strtof_l, begin, end, value);
}

}  // namespace thicken::platform

#endif
