// SPDX-License-Identifier: LGPL-2.1-or-later
//
// std::from_chars of numbers with a point, for C++ libraries that do not have it yet as well, such as Clang's
// before 20.
#pragma once

#include <charconv>

namespace thicken::platform {

#if defined(__cpp_lib_to_chars)

using std::from_chars;

#else

std::from_chars_result from_chars(const char* begin, const char* end, double& value);
std::from_chars_result from_chars(const char* begin, const char* end, float& value);

#endif

}  // namespace thicken::platform
