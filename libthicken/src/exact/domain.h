// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The preconditions of the exact predicates: no product of three coordinates over- or underflows, and each
// operation rounds to nearest.
#pragma once

#include <cfloat>

#include "thicken/mesh.h"

#ifdef __FAST_MATH__
#error "-ffast-math lets the compiler reorder sums: nothing would be exact. Build without it."
#endif
static_assert(FLT_EVAL_METHOD == 0, "doubles have to be rounded to double after each operation");

namespace thicken::exact {

/// The least magnitude of a coordinate besides 0. A coordinate of at least 2^-250 is a multiple of 2^-302,
/// and so is every difference. A product of three of them, and every error term of it, is a multiple of
/// 2^-906: far above 2^-1022, below which doubles lose digits.
inline constexpr double kLeastCoordinate = 0x1p-250;
/// The largest magnitude: that of a float. Differences are below 2^129. The determinant of three, split by
/// 2^27 + 1 on the way, stays below 2^420: far below 2^1024.
inline constexpr double kLargestCoordinate = FLT_MAX;

/// Whether every coordinate of `p` is 0 or within the two bounds. The bits decide: where the processor takes
/// subnormal numbers for 0, comparisons do, too.
[[nodiscard]] bool inDomain(const Vec3& p);

/// Throws Error(kArithmetic) unless this thread rounds to nearest, keeps subnormal numbers and does not
/// contract a product and a sum into one operation. Other libraries of the process may have changed the first
/// two, and other compiler options the third. Loops on several threads have the modes of the thread that
/// begins them.
void requireExactArithmetic();

}  // namespace thicken::exact
