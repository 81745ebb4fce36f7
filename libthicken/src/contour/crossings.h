// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where grid edges cross the open part of ∂H (paper §4.2). Their number is exact: the difference of the
// labels of an edge's ends, less the signed crossings of the carrier. Secants place them. Each has a normal.
#pragma once

#include <span>
#include <vector>

#include "field/membership.h"
#include "field/node_field.h"
#include "field/surface_crossings.h"

namespace thicken::contour {

/// A part of a grid edge that the contour crosses once.
struct EdgePart {
  std::uint64_t edge = 0;   ///< UniformGrid::key(node, axis)
  double from = 0, to = 0;  ///< coordinates along the axis
  /// Numbers of the nodes at the ends; KeyIndex::kAbsent where an end lies on the carrier.
  std::uint32_t fromNode = field::KeyIndex::kAbsent, toNode = field::KeyIndex::kAbsent;
  int jump = 0;  ///< −1: leaves the solid in the axis' direction; +1: enters it
};

struct Crossing {
  std::uint64_t edge = 0;  ///< of its part
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, out of the solid; zero on the wall, where c(p) does not tell it
  field::Standing beyond =
      field::Standing::kFar;  ///< what the outer side is: tells shell (Definition 5b) from wall (5a)
  std::int8_t jump = 0;       ///< of its part
};

/// Appends the parts of the edge between the nodes `low` and `high` (numbers in `field`) that are crossed,
/// along it.
void crossEdge(const field::UniformGrid& grid, const field::NodeField& field, std::uint64_t edge,
               std::uint32_t low, std::uint32_t high, std::span<const field::SurfaceCrossing> carrier,
               std::vector<EdgePart>& out);

/// Where a part is crossed, and the normal there. The samples of its nodes are known.
[[nodiscard]] Crossing placed(const EdgePart& part, const field::UniformGrid& grid,
                              const field::NodeField& field, const field::Membership& membership);

}  // namespace thicken::contour
