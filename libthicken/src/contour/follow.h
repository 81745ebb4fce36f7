// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Follows the part of ∂H that is to be made from cell to cell: from the cells of the carrier's rim, where
// it begins, and from places that are known to lie on it. Around every face of the grid that it meets all
// edges are examined, so that what is found is whole.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contour/crossings.h"

namespace thicken {

/// Points near the contour, for parts of it that hang together with no rim.
struct Seeds {
  std::vector<Vec3> points;
  /// Such a point moved onto the contour, by its place in `points`; called on any thread.
  std::function<Vec3(std::size_t)> toContour;
};

/// Says where a part of an edge is crossed, while the samples of its nodes are known; called on any thread.
using Placing = std::function<Crossing(const EdgePart&)>;

/// All crossings of what hangs together with `rimCells` or with `seeds`, sorted by edge, then along it. Seeds
/// in cells that the contour is already known to pass are not looked at, and of those in a quarter of a cell
/// only the first. A field that may drop its
/// nodes does so where it is full, and those that are wanted once more are evaluated once more; in the end it
/// has none.
[[nodiscard]] std::vector<Crossing> followContour(const UniformGrid& grid,
                                                  std::span<const GridIndex> rimCells, const Seeds& seeds,
                                                  const CarrierCrossings& carrier,
                                                  const Membership& membership, NodeField& field,
                                                  const Placing& placing, const RunContext& context,
                                                  int threads);

}  // namespace thicken
