// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Follows the open part of ∂H from cell to cell. It starts in the cells of the carrier's rim, where that part
// begins, and at seeds, which lie on it. All edges of each grid face that it meets are examined: no part of a
// component is left out.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contour/crossings.h"

namespace thicken::contour {

/// Points near the contour, for components of it without a rim.
struct Seeds {
  std::vector<Vec3> points;
  /// Such a point moved onto the contour, by its place in `points`; called on any thread.
  std::function<Vec3(std::size_t)> toContour;
};

/// Says where a part of an edge is crossed, while the samples of its nodes are known; called on any thread.
using Placing = std::function<Crossing(const EdgePart&)>;

/// All crossings of the components that pass `rimCells` or `seeds`, sorted by edge, then along it. Seeds in
/// cells that were passed already are ignored. Of the seeds in a quarter of a cell the first is taken. A
/// field that may drop its nodes does so when it is full, and evaluates again what is asked for again. In the
/// end it has none.
[[nodiscard]] std::vector<Crossing> followContour(const field::UniformGrid& grid,
                                                  std::span<const field::GridIndex> rimCells,
                                                  const Seeds& seeds, const field::CarrierCrossings& carrier,
                                                  const field::Membership& membership,
                                                  field::NodeField& field, const Placing& placing,
                                                  const RunContext& context, int threads);

}  // namespace thicken::contour
