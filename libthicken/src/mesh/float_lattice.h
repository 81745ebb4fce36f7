// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rounding to the values that a float can hold. The rounded value goes through a float in memory:
// g++ 12.2 at -O2 drops (double)(float)x in vectorised code.
#pragma once

#include "thicken/mesh.h"

namespace thicken::mesh {

/// `p` with every coordinate rounded to the nearest float (held in doubles). −0 becomes 0.
[[nodiscard]] Vec3 roundToFloat(const Vec3& p);

/// Whether every coordinate of `p` is a float value.
[[nodiscard]] bool isFloat(const Vec3& p);

}  // namespace thicken::mesh
