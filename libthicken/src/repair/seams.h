// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Joins rims that run near each other, whatever their corners: corners become one, and corners of one rim
// divide the edges of the other.
#pragma once

#include "repair/ledger.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// Joins rims that are at most `distance` mm apart. No corner moves but onto another corner, and none
/// farther than that. No triangle or part of one turns over as seen along the axis that the triangle
/// faces (exact), none loses its area, and no edge gets more than two triangles. The corners of the two
/// rims keep their order along the seam. Rims whose sheets lie on the same side, one on the other, are not
/// joined. What was welded and divided goes to the ledger and the workpiece.
[[nodiscard]] SeamFacts joinSeams(Workpiece& piece, double distance, Ledger& ledger);

/// Rims within a quarter of the mean rim edge of each other. Changes nothing.
[[nodiscard]] NearRims nearRims(Workpiece& piece);

}  // namespace thicken::repairing
