// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two passes of a scanner over one place: sheets that lie on each other and intersect all over.
#pragma once

#include <span>

#include "exact/box_tree.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// Where two connected parts of one orientation lie within a mean edge of each other, and a quarter or more
/// of the triangles there meet the other part, the part with the smaller area loses all that lies on the
/// other. `pairs`: the triangles that meet. Returns whether anything was removed.
bool removeOverlaps(Workpiece& piece, std::span<const exact::TrianglePair> pairs, int threads);

}  // namespace thicken::repairing
