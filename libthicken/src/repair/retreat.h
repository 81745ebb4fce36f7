// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Takes a sheet back from corners and edges that another sheet keeps. Vertices of equal coordinates are one
// to every reader of a file, so that a sheet has to end beside such a corner and not at it.
#pragma once

#include <cstdint>
#include <vector>

#include "repair/workpiece.h"

namespace thicken::repairing {

/// What a sheet gives up, by 3 · triangle + corner.
struct GivenUp {
  std::vector<std::uint8_t> corner;  ///< the corner
  std::vector<std::uint8_t> edge;    ///< the edge from the corner to the next one, with all that is along it
};

/// Cuts triangles a quarter of the way along the edges from corners that they give up, and removes what lies
/// beyond, for the reason `why`. All triangles around a corner that are joined there have to give it up
/// together. Triangles that nothing would be left of, or that would turn over by the rounding of the new
/// corners (exact), go as a whole. New corners are float values where all corners of the surface are.
void retreat(Workpiece& piece, const GivenUp& given, RepairKind why);

}  // namespace thicken::repairing
