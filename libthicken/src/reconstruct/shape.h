// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where the contour's vertices should stand (§4.3 of the paper). Each round smooths the wall's normals and
// moves each vertex a quarter of the way to the minimiser of its quadratic error function. In the end
// vertices of the shell stand so far from S that the largest error of the faces between them is least.
#pragma once

#include "field/membership.h"
#include "reconstruct/assembly.h"

namespace thicken::reconstruct {

/// Target of every vertex of the contour, in the assembly's order. `crossings` get the wall's smoothed
/// normals. `rounds` may be 0: the means of the crossings.
[[nodiscard]] std::vector<Vec3> shapedPositions(const Assembly& assembly, const contour::DualSurface& dual,
                                                std::vector<contour::Crossing>& crossings,
                                                const field::Membership& membership, double cell, int rounds,
                                                const RunContext& context, int threads);

}  // namespace thicken::reconstruct
