// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The borders of what a repair removed, without teeth.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Removes triangles of which two edges border on triangles that were removed, the smallest first, as long as
/// they have no more than `most` mm² together, in a bounded number of rounds. A valid surface stays valid:
/// what goes has one neighbour at most.
void smoothBorders(Workpiece& piece, double most);

}  // namespace thicken::repairing
