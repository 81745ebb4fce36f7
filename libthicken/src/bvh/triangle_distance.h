// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Closest point on one triangle, robust for needles: the face only where the projection lies within
// all three edges, else the nearest of the edges that it lies beyond.
//
// What rounding does to a distance, with e = 2^-53, coordinates below M and edges below L: differences,
// products and sums, less than 16 e M; the tilt of the normal, less than kMostTilt L; a projection that is
// taken to be within an edge that it is beyond, or the reverse, less than that, since the nearest point moves
// no farther.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/predicates.h"
#include "thicken/closest_point.h"
#include "thicken/mesh.h"

namespace thicken::bvh {

struct TriangleClosest {
  Vec3 point;
  double squaredDistance;
  Feature feature;
  std::uint8_t corner;  ///< of the vertex, or the first corner of the edge
};

/// A triangle with what does not depend on the query.
struct PreparedTriangle {
  std::array<Vec3, 3> corner;
  Vec3 normal;               ///< unit, tilted by rounding by less than kMostTilt; zero without an area
  std::array<Vec3, 3> side;  ///< normal × edge: points into the triangle
  Triangle ids;

  // The rounding of two edges and of their product moves the normal by less than 6 · 2^-53 of the product of
  // their lengths: a tilt of that over the sine of their angle. Below this sine the exact product is taken.
  static constexpr double kFlatSine = 1e-2;
  static constexpr double kMostTilt = 6 * 0x1p-53 / kFlatSine;

  PreparedTriangle() {}  // uninitialised: not a default one, which would be filled with zeros
  PreparedTriangle(const std::array<Vec3, 3>& c, const Triangle& t) : corner(c), ids(t) {
    const Vec3 u = c[1] - c[0], v = c[2] - c[0];
    Vec3 n = u.cross(v);
    if (n.squaredNorm() <= kFlatSine * kFlatSine * u.squaredNorm() * v.squaredNorm())
      n = exact::normal(c[0], c[1], c[2]);
    normal = n.stableNormalized();
    for (int k = 0; k < 3; ++k) side[k] = normal.cross(c[(k + 1) % 3] - c[k]);
  }
};

/// Closest point to `p` on the segment from `a` to `b`; `end` is 0 or 1 at an end, else 2.
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

/// Closest point to `p` on a triangle; when that is farther than the square root of `within` the
/// answer may be of infinite distance. Edges are evaluated from their lower to their higher vertex id,
/// so that neighbours agree to the last bit on a shared edge.
inline TriangleClosest closestOnTriangle(const Vec3& p, const PreparedTriangle& t, double within) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  TriangleClosest best{Vec3::Zero(), kInfinite, Feature::kEdge, 0};
  // The plane is no farther than the triangle; the factor covers the rounding of the height.
  constexpr double kShrink = 1 - 1e-9;
  const double height = t.normal.dot(p - t.corner[0]);
  if (height * height * kShrink > within) return best;
  bool beyond[3];
  for (int k = 0; k < 3; ++k) beyond[k] = t.side[k].dot(p - t.corner[k]) <= 0;
  if (!beyond[0] && !beyond[1] && !beyond[2]) {
    const Vec3 c = p - height * t.normal;
    return {c, (p - c).squaredNorm(), Feature::kFace, 0};
  }
  for (int k = 0; k < 3; ++k) {
    if (!beyond[k]) continue;
    int from = k, to = (k + 1) % 3;
    if (t.ids[from] > t.ids[to]) std::swap(from, to);
    int end = 0;
    const Vec3 c = closestOnSegment(p, t.corner[from], t.corner[to], end);
    const double d2 = (p - c).squaredNorm();
    if (d2 >= best.squaredDistance) continue;
    best.point = c;
    best.squaredDistance = d2;
    best.feature = end == 2 ? Feature::kEdge : Feature::kVertex;
    best.corner = static_cast<std::uint8_t>(end == 2 ? k : (end == 0 ? from : to));
  }
  return best;
}

}  // namespace thicken::bvh
