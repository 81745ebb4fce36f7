// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Closest point on one triangle, robust for needles: the face only where the projection lies within
// all three edges, else the nearest of the edges that it lies beyond.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "thicken/closest_point.h"
#include "thicken/mesh.h"

namespace thicken {

struct TriangleClosest {
  Vec3 point;
  double squaredDistance;
  Feature feature;
  std::uint8_t corner;  ///< of the vertex, or the first corner of the edge
};

/// Closest point to `p` on the segment from `a` to `b`. Rounds the same for either order of the
/// caller's ends as long as the caller orders them the same; `end` is 0 or 1 at an end, else 2.
inline Vec3 closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b, int& end) {
  const Vec3 ab = b - a;
  const double along = (p - a).dot(ab);
  const double length2 = ab.squaredNorm();
  if (along <= 0) {
    end = 0;
    return a;
  }
  if (along >= length2) {
    end = 1;
    return b;
  }
  end = 2;
  return a + (along / length2) * ab;
}

/// Closest point to `p` on triangle `ids` with the given corners. Edges are evaluated from their
/// lower to their higher vertex id, so that neighbours agree to the last bit on a shared edge.
inline TriangleClosest closestOnTriangle(const Vec3& p, const std::array<Vec3, 3>& corner,
                                         const Triangle& ids) {
  const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  // The normal of a needle is rounding only; its edges are as near as its face to the last digit.
  const double n2 = n.squaredNorm();
  const double u2 = (corner[1] - corner[0]).squaredNorm(), v2 = (corner[2] - corner[0]).squaredNorm();
  constexpr double kNeedle = 1e-20;
  const bool needle = n2 <= kNeedle * u2 * v2;
  bool beyond[3];
  for (int k = 0; k < 3; ++k) {
    const Vec3 edge = corner[(k + 1) % 3] - corner[k];
    beyond[k] = needle || n.cross(edge).dot(p - corner[k]) <= 0;
  }
  if (!beyond[0] && !beyond[1] && !beyond[2]) {
    const double height = (p - corner[0]).dot(n) / n2;
    const Vec3 c = p - height * n;
    return {c, (p - c).squaredNorm(), Feature::kFace, 0};
  }
  TriangleClosest best{Vec3::Zero(), std::numeric_limits<double>::infinity(), Feature::kEdge, 0};
  for (int k = 0; k < 3; ++k) {
    if (!beyond[k]) continue;
    int from = k, to = (k + 1) % 3;
    if (ids[from] > ids[to]) std::swap(from, to);
    int end = 0;
    const Vec3 c = closestOnSegment(p, corner[from], corner[to], end);
    const double d2 = (p - c).squaredNorm();
    if (d2 >= best.squaredDistance) continue;
    best.point = c;
    best.squaredDistance = d2;
    best.feature = end == 2 ? Feature::kEdge : Feature::kVertex;
    best.corner = static_cast<std::uint8_t>(end == 2 ? k : (end == 0 ? from : to));
  }
  return best;
}

}  // namespace thicken
