// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How far a point of the shell is from where its definition has it. A round join is r from the nearest point
// of S (Definition 2). A mitred one is r from the planes of all triangles that the nearest point lies on, and
// at most kMitreLimit · r from that point: what is thicker than r outside of a convex edge or corner is no
// error of it.
#pragma once

#include <cmath>
#include <span>

#include "job/job.h"
#include "mesh/topology.h"
#include "thicken/closest_point.h"
#include "thicken/mesh.h"
#include "thicken/options.h"

namespace thicken::measure {

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
  /// `job`, `normal` (of the triangles of its surface) and `around` must outlive this.
  OffsetError(const job::Job& job, std::span<const Vec3> normal, const mesh::VertexTriangles& around,
              Join join)
      : job_(job), normal_(normal), around_(around), join_(join) {}

  struct Error {
    double mm = 0;                 ///< below 0: too near to S
    Vec3 away = Vec3::Zero();      ///< unit: straight to the shell it is that far
    Vec3 gradient = Vec3::Zero();  ///< of mm
  };
  /// Of a point `p` whose closest point on S is `c`; exact but for rounding.
  [[nodiscard]] Error at(const Vec3& p, const ClosestPoint& c) const {
    const double r = job_.thickness.at(c);
    const Vec3 from = p - c.point;
    const Vec3 unit = c.distance > 0 ? Vec3(from / c.distance) : Vec3(Vec3::Zero());
    const Error round{c.distance - r, unit, unit - job_.thickness.slope(c)};
    if (join_ == Join::kRound || round.mm <= 0 || c.feature == Feature::kFace || c.distance > kMitreLimit * r)
      return round;
    // The plane of a copied triangle leans as the thickness grows: r is that of the point right above.
    Error worst{-r, round.away, round.gradient};
    forPlanes(c, [&](TriangleId t) {
      const Vec3& n = normal_[t];
      const Vec3 slope = job_.thickness.slope(t);
      const double far = from.dot(n), own = r + slope.dot(from);
      if (std::abs(far) - own <= worst.mm) return;
      const Vec3 away = far < 0 ? Vec3(-n) : n;
      worst = {std::abs(far) - own, away, away - slope};
    });
    if (worst.mm < 0) worst.mm = 0;
    return worst;
  }

 private:
  template <class Visit>
  void forPlanes(const ClosestPoint& c, Visit visit) const {
    const Triangle& t = job_.surface.triangles[c.triangle];
    const VertexId a = t[c.corner], b = t[(c.corner + 1) % 3];
    for (const TriangleId s : around_.of(a)) {
      const Triangle& other = job_.surface.triangles[s];
      if (c.feature == Feature::kVertex || other[0] == b || other[1] == b || other[2] == b) visit(s);
    }
  }

  const job::Job& job_;
  std::span<const Vec3> normal_;
  const mesh::VertexTriangles& around_;
  Join join_;
};

}  // namespace thicken::measure
