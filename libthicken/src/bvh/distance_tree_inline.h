// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Lower bounds for what a query of DistanceTree looks at, four at a time.
#pragma once

#ifdef __SSE__
#include <immintrin.h>
#endif

#include <bit>

#include "bvh/distance_tree.h"
#include "platform/prefetch.h"

namespace thicken::bvh {

// What is farther than this by its lower bound, squared, is farther than `squaredDistance`.
//
// With f = 2^-24, the rounding of a float, a query at distance d from the box of all triangles and E, the
// extent of that box: the query and its differences are off by less than 2 f (d + E); the products along an
// axis and their sum by 4 √3 f (d + E); the axes are unit and orthogonal to 2 f, which is as much of the sum
// of squares again. Together less than 12 f (d + E) = 7.2e-7 (d + E). Boxes are enlarged by the slack, 2.5e-6
// E, which has the second part and the same for the stored corners; of the first part 2e-5 of the square has
// 1e-5 d.
inline float reachOf(double squaredDistance) {
  return static_cast<float>(squaredDistance * (1 + 2e-5));
}

// Bit k: whether the k-th number is not above `most`; what is no number, by overflow, rules nothing out.
template <class Four>
inline unsigned notAbove(const Four& numbers, float most) {
#ifdef __SSE__
  return static_cast<unsigned>(
      _mm_movemask_ps(_mm_cmpngt_ps(_mm_loadu_ps(numbers.data()), _mm_set1_ps(most))));
#else
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= static_cast<unsigned>(!(numbers[k] > most)) << k;
  return bits;
#endif
}

// Lower bounds of the squared distances to the four boxes of a node.
inline DistanceTree::Four DistanceTree::squaredDistances(const Node& n, float x, float y, float z) {
  const auto four = [](const float* p) { return Eigen::Map<const Four, Eigen::Aligned16>(p); };
  const Four dx = x - four(n.middle[0]), dy = y - four(n.middle[1]), dz = z - four(n.middle[2]);
  Four sum = Four::Zero();
  for (int a = 0; a < 3; ++a) {
    const Four along = four(n.axis[a][0]) * dx + four(n.axis[a][1]) * dy + four(n.axis[a][2]) * dz;
    sum += (along.abs() - four(n.half[a])).max(0.0f).square();
  }
  return sum;
}

// Lower bounds of the squared distances to the triangles of a leaf.
inline DistanceTree::Four DistanceTree::squaredDistances(const Leaf& leaf, float x, float y, float z) const {
  const auto height = [&](int plane) -> Four {
    const auto four = [&](int i) { return Eigen::Map<const Four, Eigen::Aligned16>(leaf.plane[plane][i]); };
    return four(0) * x + four(1) * y + four(2) * z - four(3);
  };
  const Four above = (height(0).abs() - slack_).max(0.0f);
  const Four beyond = (height(1).max(height(2)).max(height(3)) - slack_).max(0.0f);
  return above.square() + beyond.square();
}

// Adds the children within reach to the `m` that are there, farthest first; returns how many there are.
inline int DistanceTree::put(const Node& n, const Four& squaredDistance, float reach, Entry* to, int m) {
  for (unsigned near = notAbove(squaredDistance, reach); near != 0; near &= near - 1) {
    const int k = std::countr_zero(near);
    if (n.child[k] == kEmpty) continue;
    int at = m++;
    for (; at > 0 && to[at - 1].d2 < squaredDistance[k]; --at) to[at] = to[at - 1];
    to[at] = {squaredDistance[k], n.child[k]};
  }
  return m;
}

inline void DistanceTree::prefetch(std::int32_t child) const {
  const char* at = child < 0 ? reinterpret_cast<const char*>(&leaves_[static_cast<std::size_t>(-1 - child)])
                             : reinterpret_cast<const char*>(&nodes_[static_cast<std::size_t>(child)]);
  for (int line = 0; line < 4; ++line) platform::prefetch(at + 64 * line);
}

// Improves `hit` by the triangles of a leaf, and `reach` with it; returns whether any was nearer.
inline bool DistanceTree::measureLeaf(std::int32_t child, const Vec3& p, float x, float y, float z,
                                      float& reach, Hit& hit) const {
  const Leaf& leaf = leaves_[static_cast<std::size_t>(-1 - child)];
  const Four least = squaredDistances(leaf, x, y, z);
  bool found = false;
  for (unsigned near = notAbove(least, reach) & ((1u << leaf.count) - 1); near != 0; near &= near - 1) {
    const int k = std::countr_zero(near);
    if (least[k] > reach) continue;  // of what was measured just before
    const std::uint32_t i = leaf.first + static_cast<std::uint32_t>(k);
    if (order_[i] == hit.triangle) continue;
    const TriangleClosest c = closestOnTriangle(p, prepared_[i], hit.closest.squaredDistance);
    if (c.squaredDistance < hit.closest.squaredDistance ||
        (c.squaredDistance == hit.closest.squaredDistance && order_[i] < hit.triangle)) {
      hit = {c, order_[i]};
      reach = reachOf(c.squaredDistance);
      found = true;
    }
  }
  return found;
}

}  // namespace thicken::bvh
