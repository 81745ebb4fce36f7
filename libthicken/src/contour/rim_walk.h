// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The way of a rim through the cells of a grid (paper §4.1). Exact comparisons decide: it passes through a
// face of the grid if and only if the signed crossings around that face do not cancel.
#pragma once

#include <span>
#include <vector>

#include "field/uniform_grid.h"
#include "mesh/topology.h"

namespace thicken::contour {

/// Where a rim goes through a face of the grid.
struct RimPassage {
  std::uint64_t face = 0;  ///< UniformGrid::key(lowest node, normal axis)
  int sign = 0;            ///< +1 in the direction of the axis
  Vec3 at = Vec3::Zero();  ///< mm, rounded
};

/// A stay in one cell: the rim's vertices there, and the passage that ends it.
struct RimVisit {
  field::GridIndex cell{};
  std::vector<VertexId> vertices;
  RimPassage exit;
};

/// The cyclic way of one loop, in rim order, without excursions: if the rim enters and leaves a cell through
/// the same face, its vertices there belong to the cell that it came from. A loop within one cell is one
/// visit without a passage.
using RimWay = std::vector<RimVisit>;

/// The ways of all loops. Throws GridTouches where a comparison is a tie.
[[nodiscard]] std::vector<RimWay> rimWays(const field::UniformGrid& grid, std::span<const Vec3> positions,
                                          const mesh::Rim& rim);

}  // namespace thicken::contour
