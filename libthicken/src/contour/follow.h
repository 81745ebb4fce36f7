// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Follows the part of ∂H that is to be made from cell to cell: from the cells of the carrier's rim, where
// it begins, and from places that are known to lie on it. Around every face of the grid that it meets all
// edges are examined, so that what is found is whole.
#pragma once

#include <span>
#include <vector>

#include "contour/crossings.h"

namespace thicken {

/// All crossings of what hangs together with `seeds` (cells), sorted by edge, then along it; not placed.
[[nodiscard]] std::vector<Crossing> followContour(const UniformGrid& grid, std::span<const GridIndex> seeds,
                                                  const CrossedEdges& carrier, const Membership& membership,
                                                  NodeField& field, const RunContext& context, int threads);

}  // namespace thicken
