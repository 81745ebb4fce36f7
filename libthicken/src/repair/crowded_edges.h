// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 4: at an edge of three or more triangles two are kept. Vertices of equal coordinates are one
// to every reader of a file, so that nothing but removal opens such an edge for good.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// The patches that such edges divide the surface into decide: triangles of large ones stay before
/// those of small ones, so that a fin goes rather than what it stands on, and along an edge of
/// several triangles the same sheet is cut everywhere.
void thinCrowdedEdges(Workpiece& piece);

}  // namespace thicken::repairing
