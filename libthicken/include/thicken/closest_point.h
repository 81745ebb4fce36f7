// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Closest points on a triangle surface, with the feature they lie on, and what follows from them:
// the signed distance of Definition 1 and the membership of Definition 2.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "thicken/mesh.h"

namespace thicken {

/// The kind of element of S that a closest point lies on.
enum class Feature : std::uint8_t { kFace, kEdge, kVertex };

struct ClosestPoint {
  Vec3 point = Vec3::Zero();  ///< c(p), mm
  double distance = 0;        ///< ‖p − c‖, mm
  TriangleId triangle = 0;    ///< a triangle that holds c
  Feature feature = Feature::kFace;
  std::uint8_t corner = 0;  ///< kVertex: corner of `triangle`; kEdge: the edge from this corner to the next
  bool onRim = false;       ///< c ∈ ∂S
  Vec3 pseudonormal = Vec3::Zero();  ///< unit; angle-weighted at edges and vertices (Bærentzen & Aanæs)
};

/// A bounding-volume hierarchy over a valid surface. Const queries may run on any number of
/// threads; the answer to a query does not depend on earlier ones. Cost: O(n log n) to make, O(log n) for a
/// query near the surface. Far from it, where many triangles are nearly as close, a query takes longer.
/// Lengths are in the unit of the surface.
class ClosestPointTree {
 public:
  /// `surface` must be welded, edge-manifold and without degenerate triangles. It is copied. The tree is the
  /// same for any number of `threads` (0: all).
  explicit ClosestPointTree(const TriangleMesh& surface, int threads = 1);
  ~ClosestPointTree();
  ClosestPointTree(ClosestPointTree&&) noexcept;
  ClosestPointTree& operator=(ClosestPointTree&&) noexcept;

  /// The closest point of S to `p`; nullopt when S is farther than `within`. Of equally near
  /// triangles the one with the lowest id is taken.
  [[nodiscard]] std::optional<ClosestPoint> closest(
      const Vec3& p, double within = std::numeric_limits<double>::infinity()) const;

  struct Query {
    Vec3 point = Vec3::Zero();
    double within = std::numeric_limits<double>::infinity();
    std::optional<TriangleId> hint = {};  ///< a triangle that may be near; the answer does not depend on it
  };
  /// closest() for some points that lie close together, quicker than one by one. Where S is farther than
  /// asked for, only the answer's `distance` is set, and is infinite.
  void closest(std::span<const Query> queries, std::span<ClosestPoint> answers) const;

  [[nodiscard]] std::size_t triangleCount() const;
  /// The place of a triangle in the tree's own order, in which triangles that are close together follow on
  /// each other. For queries in that order.
  [[nodiscard]] std::size_t placeOf(TriangleId t) const;

  /// ‖p − c(p)‖ without the feature; starts from the triangle `hint` of a neighbouring query.
  [[nodiscard]] double distance(const Vec3& p, std::optional<TriangleId> hint = {}) const;

  /// Distance from `p` to one triangle of S.
  [[nodiscard]] double distanceTo(TriangleId t, const Vec3& p) const;

  /// Triangles of S that a query passes over.
  enum class Except {
    kNothing,
    kBehind,  ///< those that have all of the query behind them, and no vertex on the rim
    kBefore,  ///< those that have all of the query before them
  };
  /// The least distance of any point of `triangle`, which must not meet S, to those triangles of S that are
  /// left; `within` where it is not less.
  [[nodiscard]] double distance(const std::array<Vec3, 3>& triangle, double within,
                                Except except = Except::kNothing) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Definition 1: negative behind S, positive before it, 0 where (p − c)·n = 0.
[[nodiscard]] double signedDistance(const Vec3& p, const ClosestPoint& c);

/// Definition 2: whether `p` lies in H(S) of thickness `r` on the negative side: c is not on the
/// rim, p not farther than r and behind S. Points of S itself count as inside.
[[nodiscard]] bool insideThickened(const Vec3& p, const ClosestPoint& c, double r);

}  // namespace thicken
