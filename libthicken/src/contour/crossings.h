// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where grid edges cross the part of ∂H that is to be made: the difference of the labels of an edge's
// ends less the exact crossings of the carrier, placed by secants, with Hermite data (paper §4.2).
#pragma once

#include <span>
#include <vector>

#include "field/membership.h"
#include "field/node_field.h"
#include "field/surface_crossings.h"

namespace thicken {

struct Crossing {
  std::uint64_t edge = 0;   ///< UniformGrid::key(node, axis)
  int jump = 0;             ///< −1: leaves the solid in the axis' direction; +1: enters it
  double from = 0, to = 0;  ///< the part of the edge that it lies in, coordinates along the axis
  /// Numbers of the nodes at the ends of that part; KeyIndex::kAbsent where it ends on the carrier.
  std::uint32_t fromNode = KeyIndex::kAbsent, toNode = KeyIndex::kAbsent;
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, out of the solid; zero on the wall, where c(p) does not tell it
  Standing beyond = Standing::kFar;  ///< what the outer side is: tells shell (Definition 5b) from wall (5a)
  bool placed = false;
};

/// The order of crossings: by edge, then along it.
[[nodiscard]] inline bool inOrder(const Crossing& a, const Crossing& b) {
  return a.edge != b.edge ? a.edge < b.edge : a.from < b.from;
}

/// Appends the crossings of the edge between the nodes `low` and `high` (numbers in `field`), in order.
void crossEdge(const UniformGrid& grid, const NodeField& field, std::uint64_t edge, std::uint32_t low,
               std::uint32_t high, std::span<const SurfaceCrossing> carrier, std::vector<Crossing>& out);

/// Places the crossings that are not placed yet and gives them their normals.
void placeCrossings(std::vector<Crossing>& crossings, const UniformGrid& grid, const NodeField& field,
                    const Membership& membership, const RunContext& context, int threads);

}  // namespace thicken
