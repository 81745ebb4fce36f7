// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The order of triangles along the leaves of a BoxTree, and the shape of that tree.
#pragma once

#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::exact {

inline constexpr std::uint32_t kLeafSize = 4;

/// A subtree over the leaves [first, first + count). The shape of the tree follows from the number
/// of leaves alone: nodes are stored in preorder, and a node of n leaves has 2n − 1 nodes below and
/// with it, so that neither children nor parents have to be stored.
struct Subtree {
  std::uint32_t node = 0, first = 0, count = 0;

  [[nodiscard]] bool isLeaf() const { return count == 1; }
  [[nodiscard]] Subtree left() const { return {node + 1, first, count / 2}; }
  [[nodiscard]] Subtree right() const {
    const std::uint32_t half = count / 2;
    return {node + 2 * half, first + half, count - half};
  }
};

/// The triangles `ids` in leaf order, kLeafSize a leaf: each subtree is split at the median along the
/// longest side of the box of its centres. Deterministic for any number of threads.
[[nodiscard]] std::vector<TriangleId> leafOrder(std::span<const Vec3> positions,
                                                std::span<const Triangle> triangles,
                                                std::vector<TriangleId> ids, int threads);

}  // namespace thicken::exact
