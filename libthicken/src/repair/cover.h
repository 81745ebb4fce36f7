// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 6: which triangles to remove so that no two of those that remain meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "thicken/mesh.h"

namespace thicken::repairing {

/// The graph of triangles that meet.
class MeetingGraph {
 public:
  MeetingGraph(std::size_t triangles, std::span<const exact::TrianglePair> pairs);
  [[nodiscard]] std::span<const TriangleId> of(TriangleId t) const {
    return std::span(other_).subspan(offset_[t], offset_[t + 1] - offset_[t]);
  }

 private:
  std::vector<std::uint32_t> offset_;
  std::vector<TriangleId> other_;
};

/// A small vertex cover of the graph among the triangles that are `present`: again and again the
/// triangle with the most open pairs for its `weight` is taken, and at the end those that are not
/// needed are given back, the heaviest first. Ascending.
[[nodiscard]] std::vector<TriangleId> smallCover(const MeetingGraph& graph,
                                                 std::span<const std::uint8_t> present,
                                                 std::span<const double> weight);

}  // namespace thicken::repairing
