// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 2: triangles that are none.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Removes triangles with a corner that is no number, without area, and all but the first of those
/// with the same corners.
void dropBadTriangles(Workpiece& piece, const RunContext& context, int threads);

}  // namespace thicken::repairing
