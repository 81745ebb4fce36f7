// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Four-wide bounding-volume hierarchy for nearest-triangle queries. Boxes are floats about the
// centre of the mesh, rounded outwards and grown by the rounding of a query, so that a float
// comparison never drops the closest triangle; triangles themselves are measured in doubles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bvh/triangle_distance.h"
#include "thicken/mesh.h"

namespace thicken {

class DistanceTree {
 public:
  struct Hit {
    TriangleClosest closest;
    TriangleId triangle;
  };

  DistanceTree(std::span<const Vec3> positions, std::span<const Triangle> triangles);

  /// Improves `hit` by every triangle that is nearer than hit.closest.squaredDistance, or as near
  /// with a lower id. Returns whether there was one.
  bool nearest(const Vec3& p, Hit& hit) const;

  /// The triangle itself, as a starting bound for nearest().
  [[nodiscard]] TriangleClosest measure(const Vec3& p, TriangleId t) const;

 private:
  static constexpr int kWidth = 4;
  static constexpr std::uint32_t kLeafSize = 4;
  struct alignas(16) Node {
    float low[3][kWidth];
    float high[3][kWidth];
    std::int32_t child[kWidth];  ///< ≥ 0: node; < 0: −1 − first entry of a leaf in order_; kEmpty
    std::int32_t count[kWidth];  ///< triangles of a leaf
  };
  static constexpr std::int32_t kEmpty = INT32_MAX;

  struct Builder;

  std::vector<Node> nodes_;
  std::vector<TriangleId> order_;           ///< triangles, leaf by leaf
  std::vector<PreparedTriangle> prepared_;  ///< in the order of order_
  std::vector<std::uint32_t> placeOf_;      ///< triangle → its place in order_
  Vec3 centre_ = Vec3::Zero();
};

}  // namespace thicken
