// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Joins rims that run near each other, whatever their corners: corners become one, and corners of one rim
// divide the edges of the other.
#pragma once

#include <vector>

#include "repair/ledger.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// What joining seams did.
struct Seams {
  std::size_t moved = 0;        ///< corners that became another one
  std::size_t inserted = 0;     ///< corners that divide an edge of another rim
  std::size_t joinedEdges = 0;  ///< rim edges that another rim shares now
  std::vector<Vec3> left;       ///< mm, corners within the distance of another rim that could not be joined
};

/// Joins rims that are at most `distance` mm apart. No corner moves but onto another corner, and none
/// farther than that. No triangle or part of one turns over as seen along the axis that the triangle
/// faces (exact), none loses its area, and no edge gets more than two triangles. The corners of the two
/// rims keep their order along the seam. Rims whose sheets lie on the same side, one on the other, are not
/// joined. What was welded and divided goes to the ledger and the workpiece.
[[nodiscard]] Seams joinSeams(Workpiece& piece, double distance, Ledger& ledger);

}  // namespace thicken::repairing
