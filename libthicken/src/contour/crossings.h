// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where grid edges cross the part of ∂H that is to be made: the difference of the labels of an edge's
// ends less the exact crossings of the carrier, placed by secants, with Hermite data (paper §4.2).
#pragma once

#include <vector>

#include "field/labels.h"
#include "field/membership.h"
#include "field/surface_crossings.h"

namespace thicken {

struct Crossing {
  std::uint64_t edge = 0;   ///< UniformGrid::key(node, axis)
  int jump = 0;             ///< −1: leaves the solid in the axis' direction; +1: enters it
  double from = 0, to = 0;  ///< the part of the edge that it lies in, coordinates along the axis
  Vec3 at = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, out of the solid; zero on the wall, where c(p) does not tell it
  Standing beyond = Standing::kFar;  ///< what the outer side is: tells shell (Definition 5b) from wall (5a)
};

/// All crossings, sorted by edge, then along it.
[[nodiscard]] std::vector<Crossing> findCrossings(const UniformGrid& grid, const Labels& labels,
                                                  const std::vector<SurfaceCrossing>& carrier,
                                                  const RunContext& context, int threads);

/// Places the crossings and gives them their normals.
void placeCrossings(std::vector<Crossing>& crossings, const UniformGrid& grid, const Membership& membership,
                    const RunContext& context, int threads);

}  // namespace thicken
