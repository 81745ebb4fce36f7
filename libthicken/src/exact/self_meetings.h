// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The search for all pairs of triangles that meet: one descent of a tree of boxes against itself.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_order.h"
#include "exact/float_box.h"
#include "exact/four_boxes.h"
#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "thicken/run_context.h"

namespace thicken::exact {

inline constexpr TriangleId kNobody = 0xffffffffu;

struct Leaf : FourBoxes {
  static_assert(kLeafSize == kFour);
  TriangleId id[kLeafSize];  ///< or kNobody
};

/// Why pairs of two triangles that share a bit are left out.
using Mask = std::uint8_t;
inline constexpr Mask kFixed = 1, kUnmoved = 2;

struct Geometry {
  std::span<const Vec3> positions;
  std::span<const Triangle> triangles;

  [[nodiscard]] FloatBox box(TriangleId t) const {
    const Triangle& c = triangles[t];
    return boxOf(positions[c[0]], positions[c[1]], positions[c[2]]);
  }
  [[nodiscard]] bool degenerate(TriangleId t) const {
    const Triangle& c = triangles[t];
    return collinear(positions[c[0]], positions[c[1]], positions[c[2]]);
  }
  [[nodiscard]] bool pairMeets(TriangleId a, TriangleId b) const {
    return meet(positions, triangles[a], triangles[b]) && !degenerate(a) && !degenerate(b);
  }
};

inline TrianglePair ordered(TriangleId a, TriangleId b) {
  return a < b ? TrianglePair{a, b} : TrianglePair{b, a};
}

/// Sorted, each once.
[[nodiscard]] std::vector<TrianglePair> sortedUnion(const std::vector<std::vector<TrianglePair>>& parts);

/// `box`: of each node of the tree over `leaves` (Subtree); `clear`: of each vertex (clearFans());
/// `maskOfSlot`: of each place in the leaves, or empty. For `limit` see BoxTree::meetingPairs().
[[nodiscard]] std::vector<TrianglePair> selfMeetings(std::span<const FloatBox> box,
                                                     std::span<const Leaf> leaves, const Geometry& geometry,
                                                     std::span<const std::uint8_t> clear,
                                                     std::span<const Mask> maskOfSlot, std::size_t limit,
                                                     const RunContext& context, int threads);

}  // namespace thicken::exact
