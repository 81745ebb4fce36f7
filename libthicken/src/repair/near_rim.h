// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What rims that run near each other have in common, whether they are joined or bridged.
#pragma once

#include <algorithm>

#include "thicken/mesh.h"

namespace thicken::repairing {

/// A rim is near itself at every bend. It counts as two rims beside each other if the way along it is this
/// many times as long as the way across.
inline constexpr double kFoldedBack = 4;

/// Where on the segment from a to b it is closest to p, from 0 to 1.
[[nodiscard]] inline double shareOfSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double length2 = u.squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(u) / length2, 0.0, 1.0) : 0;
}

/// The distance of p from the segment, mm.
[[nodiscard]] inline double toSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (a + shareOfSegment(p, a, b) * (b - a) - p).norm();
}

}  // namespace thicken::repairing
