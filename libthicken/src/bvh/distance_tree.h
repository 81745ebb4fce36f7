// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Four-wide bounding-volume hierarchy for nearest-triangle queries. Most queries are at the same distance
// from many triangles. There, boxes along the axes rule out few slanting triangles. So boxes are turned into
// the mean plane of their triangles. Boxes are floats about the centre of the mesh, grown by the rounding of
// a query: no comparison of floats drops the closest triangle. Triangles are measured in doubles.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bvh/triangle_distance.h"
#include "thicken/mesh.h"

namespace thicken::bvh {

class DistanceTree {
 public:
  struct Hit {
    TriangleClosest closest;
    TriangleId triangle;
  };

  /// The same for any number of `threads`.
  DistanceTree(std::span<const Vec3> positions, std::span<const Triangle> triangles, int threads = 1);

  /// Improves `hit` by every triangle that is nearer than hit.closest.squaredDistance, or as near
  /// with a lower id. Returns whether there was one.
  bool nearest(const Vec3& p, Hit& hit) const;

  /// The same for some points that lie close together. Subtrees that none of them can reach are ruled out
  /// once for all: quicker than one by one if each hit starts near its point, by a triangle or a bound.
  void nearest(std::span<const Vec3> points, std::span<Hit> hits) const;

  /// The number of a triangle in the order of the leaves.
  [[nodiscard]] std::uint32_t placeOf(TriangleId t) const { return placeOf_[t]; }

  /// Lowers `squaredDistance` to that of the nearest triangle to `t` which is nearer, and of which `skip`
  /// is not true. Returns whether there was one. `t` must not meet any of the triangles.
  bool nearest(const PreparedTriangle& t, const std::function<bool(const PreparedTriangle&)>& skip,
               double& squaredDistance) const;

  /// Calls visit(t) for every triangle that is within a distance of `t`; for some others, too.
  void near(const PreparedTriangle& t, double within, const std::function<void(TriangleId)>& visit) const;

  /// The triangle itself, as a starting bound for nearest().
  [[nodiscard]] TriangleClosest measure(const Vec3& p, TriangleId t) const;

 private:
  static constexpr int kWidth = 4;
  static constexpr std::uint32_t kLeafSize = kWidth;
  struct alignas(64) Node {
    float middle[3][kWidth];     ///< of the box, from the centre of the mesh
    float axis[3][3][kWidth];    ///< of the box: normal and two tangents, orthonormal
    float half[3][kWidth];       ///< extent along each axis
    std::int32_t child[kWidth];  ///< ≥ 0: node; < 0: −1 − leaf; kEmpty
  };
  /// Four triangles as half-spaces. A point's distance to the plane, or beyond an edge, is a lower bound of
  /// its distance to the triangle.
  struct alignas(64) Leaf {
    float plane[4][4][kWidth];  ///< unit normal and height, then for each edge the way out and its height
    std::uint32_t first;        ///< of order_
    std::uint32_t count;
    Leaf() {}  // uninitialised, so that the thread that fills a leaf is the first to touch it
  };
  static constexpr std::int32_t kEmpty = INT32_MAX;

  /// The most nodes that wait in a query: three children for each level that Builder makes, and the boxes of
  /// a Part.
  static constexpr int kMostWaiting = 208;

  using Four = Eigen::Array<float, kWidth, 1>;
  struct Builder;

  /// The corners of a triangle, from the centre of the mesh.
  using Corners = std::array<std::array<float, 3>, 3>;
  struct Entry {
    float d2;
    std::int32_t child;
  };
  [[nodiscard]] static int put(const Node& n, const Four& squaredDistance, float reach, Entry* to, int m = 0);
  bool descend(const Vec3& p, Entry* stack, int waiting, Hit& hit) const;
  void prefetch(std::int32_t child) const;
  bool measureLeaf(std::int32_t child, const Vec3& p, float x, float y, float z, float& reach,
                   Hit& hit) const;
  struct Part;
  void search(const Part& part, const Vec3& p, Hit& hit) const;

  [[nodiscard]] static Four squaredDistances(const Node& n, float x, float y, float z);
  [[nodiscard]] static Four squaredDistances(const Node& n, const Corners& t);
  [[nodiscard]] Four squaredDistances(const Leaf& leaf, const Corners& t) const;
  [[nodiscard]] Four squaredDistances(const Leaf& leaf, float x, float y, float z) const;

  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;
  std::vector<TriangleId> order_;           ///< triangles, leaf by leaf
  std::vector<PreparedTriangle> prepared_;  ///< in the order of order_
  std::vector<std::uint32_t> placeOf_;      ///< triangle → its place in order_
  Vec3 centre_ = Vec3::Zero();
  float slack_ = 0;  ///< rounding of a query and of what is stored in floats, mm
};

}  // namespace thicken::bvh
