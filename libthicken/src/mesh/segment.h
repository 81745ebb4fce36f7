// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Points and segments.
#pragma once

#include <algorithm>

#include "thicken/mesh.h"

namespace thicken::mesh {

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

}  // namespace thicken::mesh
