// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The last step: short rims are closed by patches of triangles.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Closes every rim of a valid surface that is shorter than `longest` mm; the surface stays valid. A patch
/// begins as the triangulation of least area. It is refined to the size of the triangles around it and
/// faired, unless it meets the surface then. New corners are float values if all corners are. Rims of more
/// than kLongestLoop corners, and rims that no patch fits into, stay open. Counts into `facts`.
void fillHoles(Workpiece& piece, double longest, AddedFacts& facts, const RunContext& context, int threads);

}  // namespace thicken::repairing
