// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How thick a solid is to be: r of Definition 2. The same everywhere, or a value for each vertex of S, linear
// over its triangles; r of a point is then that of its closest point on S, r(c(p)).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "thicken/closest_point.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"

namespace thicken::job {

class Thickness {
 public:
  /// The same everywhere, mm.
  explicit Thickness(double r) : least_(r), most_(r) {}
  /// `r` for each vertex of `surface`, mm. `surface` must outlive this.
  Thickness(const TriangleMesh& surface, std::vector<double> r);

  [[nodiscard]] bool isConstant() const { return field_ == nullptr; }
  [[nodiscard]] double least() const { return least_; }
  [[nodiscard]] double most() const { return most_; }
  /// At a vertex of S.
  [[nodiscard]] double at(VertexId v) const { return field_ ? field_->r[v] : most_; }
  /// At the closest point of S.
  [[nodiscard]] double at(const ClosestPoint& c) const { return field_ ? at(c.triangle, c.point) : most_; }
  /// At a point of a triangle of S; at a point above or below it.
  [[nodiscard]] double at(TriangleId t, const Vec3& p) const;
  /// The way along a triangle of S that r grows fastest, by so much per mm.
  [[nodiscard]] Vec3 slope(TriangleId t) const { return field_ ? field_->slope[t] : Vec3(Vec3::Zero()); }
  /// The same of r(c(p)) as p moves, where c is the closest point.
  [[nodiscard]] Vec3 slope(const ClosestPoint& c) const;
  /// Of a part of S, whose vertices are those of S that `vertex` names.
  [[nodiscard]] Thickness of(const TriangleMesh& part, std::span<const VertexId> vertex) const;

 private:
  struct Field {
    const TriangleMesh& surface;
    std::vector<double> r;    // per vertex, mm
    std::vector<Vec3> slope;  // per triangle
  };
  std::shared_ptr<const Field> field_;
  double least_, most_;
};

/// The steepest that a thickness may be, in mm per mm along S: 45 degrees. The solid with balls of radius r
/// around the points of S for a measure of its thickness, which is the other definition that is in use, has
/// no shell of its own where r grows faster: the balls of the thick place hold those of the thin one. On a
/// curved S the shell begins to fold over itself there.
inline constexpr double kSteepest = 1;

/// What `options` ask for on `surface`, with the `factors` of its vertices (empty: 1 everywhere), nowhere
/// steeper than kSteepest: thick places become thinner for that. The profile of the rim, which comes on top
/// of it, may be steeper: a wall is next to it. Tells `facts` and `rim` what came of it.
[[nodiscard]] Thickness thicknessOf(const TriangleMesh& surface, const Options& options,
                                    std::span<const double> factors, std::optional<ThicknessFacts>& facts,
                                    std::optional<RimFacts>& rim);

}  // namespace thicken::job
