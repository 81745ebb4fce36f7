// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The last step: short rims are closed by patches of triangles.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Closes every rim of a valid surface, which it stays, that is shorter than `longest` mm: with the
/// triangulation of least area, refined to the size of the triangles around it and faired to go on from
/// them, or without what makes it meet the surface. New corners are float values where all corners are. Rims
/// of more than kLongestLoop corners, and rims that no patch fits into, stay open. Counts into `facts`.
void fillHoles(Workpiece& piece, double longest, AddedFacts& facts, const RunContext& context, int threads);

}  // namespace thicken::repairing
