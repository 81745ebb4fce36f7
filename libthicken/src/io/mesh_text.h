// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the text formats have in common when they are written.
#pragma once

#include <string>
#include <string_view>

#include "io/number_text.h"

namespace thicken::io {

/// Appends "1 2 3", the three numbers of `v` with `between` them, each the shortest that is read
/// back unchanged.
template <class Vector>
void appendThree(std::string& text, const Vector& v, std::string_view between = " ") {
  appendNumber(text, v[0]);
  text += between;
  appendNumber(text, v[1]);
  text += between;
  appendNumber(text, v[2]);
}

}  // namespace thicken::io
