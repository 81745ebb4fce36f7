// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parts of removed triangles that may come back: a triangle goes as a whole where it meets another, although
// most of it may be in nobody's way.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Whether a triangle that is gone for this reason left a hole.
[[nodiscard]] bool leavesAHole(RepairKind why);

/// Fills notches in the borders of holes: of a removed triangle between two neighbours that are present, both
/// halves at the corner that these share come back, up to a new corner near the third edge, if they meet
/// nothing (exact). A valid surface stays valid. New corners are float values where all corners of the
/// surface are. Returns the area that came back, mm².
double fillNotches(Workpiece& piece, int threads);

}  // namespace thicken::repairing
