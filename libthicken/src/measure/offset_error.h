// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How far a point of the shell is from where its definition has it. A round join is r from the nearest point
// of S (Definition 2). A mitred one is r from the planes of all triangles that the nearest point lies on, and
// at most kMitreLimit · r from that point: what is thicker than r outside of a convex edge or corner is no
// error of it.
#pragma once

#include <cmath>
#include <span>

#include "mesh/topology.h"
#include "thicken/closest_point.h"
#include "thicken/mesh.h"
#include "thicken/options.h"

namespace thicken {

/// Farthest that a mitred shell may be from S, in r.
inline constexpr double kMitreLimit = 2;

/// The join that a run makes. The proof of a tolerance is one of the distance to S, so that one asks for
/// round joins.
[[nodiscard]] inline Join joinOf(const Options& options) {
  const bool isRound = options.tolerance || options.method == Method::kReconstruct;
  return options.join.value_or(isRound ? Join::kRound : Join::kMitre);
}

class OffsetError {
 public:
  /// `surface`, `normal` (of its triangles) and `around` must outlive this. `r` in mm.
  OffsetError(const TriangleMesh& surface, std::span<const Vec3> normal, const VertexTriangles& around,
              double r, Join join)
      : surface_(surface), normal_(normal), around_(around), r_(r), join_(join) {}

  struct Error {
    double mm = 0;             ///< below 0: too near to S
    Vec3 away = Vec3::Zero();  ///< unit: the way that it grows
  };
  /// Of a point `p` whose closest point on S is `c`; exact but for rounding.
  [[nodiscard]] Error at(const Vec3& p, const ClosestPoint& c) const {
    const Vec3 from = p - c.point;
    const Error round{c.distance - r_, c.distance > 0 ? Vec3(from / c.distance) : Vec3(Vec3::Zero())};
    if (join_ == Join::kRound || round.mm <= 0 || c.feature == Feature::kFace ||
        c.distance > kMitreLimit * r_)
      return round;
    Error worst{-r_, round.away};
    forPlanes(c, [&](const Vec3& n) {
      const double far = from.dot(n);
      if (std::abs(far) - r_ > worst.mm) worst = {std::abs(far) - r_, far < 0 ? Vec3(-n) : n};
    });
    if (worst.mm < 0) worst.mm = 0;
    return worst;
  }

 private:
  template <class Visit>
  void forPlanes(const ClosestPoint& c, Visit visit) const {
    const Triangle& t = surface_.triangles[c.triangle];
    const VertexId a = t[c.corner], b = t[(c.corner + 1) % 3];
    for (const TriangleId s : around_.of(a)) {
      const Triangle& other = surface_.triangles[s];
      if (c.feature == Feature::kVertex || other[0] == b || other[1] == b || other[2] == b) visit(normal_[s]);
    }
  }

  const TriangleMesh& surface_;
  std::span<const Vec3> normal_;
  const VertexTriangles& around_;
  double r_;
  Join join_;
};

}  // namespace thicken
