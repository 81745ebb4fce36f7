// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Distance between two triangles that do not meet: from a corner of one to the other, or between two edges.
// The result is the distance of two points of the triangles. So rounding can only make it too large, and only
// by the square of a relative error: nearly parallel edges have ends that are nearly as near.
#pragma once

#include "bvh/triangle_distance.h"

namespace thicken::bvh {

/// Squared distance of the segments from `a` along `u` and from `b` along `v`.
inline double squaredGap(const Vec3& a, const Vec3& u, const Vec3& b, const Vec3& v) {
  const auto along = [](const Vec3& p, const Vec3& from, const Vec3& way) {
    const double length2 = way.squaredNorm();
    return length2 > 0 ? std::clamp((p - from).dot(way) / length2, 0.0, 1.0) : 0.0;
  };
  const Vec3 n = u.cross(v);
  const double n2 = n.squaredNorm();
  double s = n2 > 0 ? std::clamp((b - a).cross(v).dot(n) / n2, 0.0, 1.0) : 0.0;
  const Vec3 q = b + along(a + s * u, b, v) * v;
  s = along(q, a, u);
  return (a + s * u - q).squaredNorm();
}

/// Squared distance of two triangles, or anything above `within` where that is not less.
inline double squaredGap(const PreparedTriangle& s, const PreparedTriangle& t, double within) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    least = std::min(least, closestOnTriangle(s.corner[k], t, within).squaredDistance);
    least = std::min(least, closestOnTriangle(t.corner[k], s, within).squaredDistance);
  }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      least = std::min(least, squaredGap(s.corner[i], s.corner[(i + 1) % 3] - s.corner[i], t.corner[k],
                                         t.corner[(k + 1) % 3] - t.corner[k]));
  return least;
}

}  // namespace thicken::bvh
