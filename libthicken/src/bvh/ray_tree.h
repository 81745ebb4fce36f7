// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where a ray meets the triangles of a mesh: a binary bounding-volume hierarchy, split at the middle
// triangle of the longest side.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::bvh {

class RayTree {
 public:
  /// Neither is copied: both must outlive the tree, and stay as they are.
  RayTree(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  struct Hit {
    double along = std::numeric_limits<double>::infinity();  ///< mm, for a direction of length 1
    TriangleId triangle = 0xffffffffu;
    std::uint32_t opened = 0;  ///< boxes that were looked into: the work that it took
  };

  /// The first meeting of the ray from `origin` along `direction` with a triangle that has no corner in
  /// common with the triangle `from`. Edges belong to the triangles on both sides, with a margin for
  /// rounding: no ray slips between two. Of equally near triangles the one with the lowest id is taken.
  [[nodiscard]] Hit first(const Vec3& origin, const Vec3& direction, const Triangle& from) const;

 private:
  struct Node {
    Vec3 low, high;
    std::uint32_t begin = 0, count = 0;  ///< entries of order_; count 0: an inner node
    std::uint32_t right = 0;             ///< the left child follows its parent
  };
  void build(std::uint32_t begin, std::uint32_t end, std::span<const Vec3> middles);
  void meet(const Vec3& origin, const Vec3& direction, TriangleId triangle, Hit& hit) const;

  std::span<const Vec3> positions_;
  std::span<const Triangle> triangles_;
  std::vector<TriangleId> order_;
  std::vector<Node> nodes_;
};

}  // namespace thicken::bvh
