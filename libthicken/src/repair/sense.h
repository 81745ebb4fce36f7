// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 5: one sense for all triangles that are joined by edges.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Turns over the smaller part, by area, of each connected part whose triangles disagree. A
/// one-sided part is cut across: the seam is the shortest of several, each made shorter as long as
/// turning a single triangle over does so, and the triangles on the side of it with the smaller area
/// are removed. Requires that no edge has more than two triangles.
void makeSenseConsistent(Workpiece& piece);

}  // namespace thicken::repairing
