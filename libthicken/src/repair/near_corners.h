// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 1: files that store corners one by one may store the same corner a rounding apart.
#pragma once

#include <vector>

#include "thicken/mesh.h"

namespace thicken::repairing {

struct NearCorners {
  std::vector<VertexId> onto;  ///< per vertex: the one that it becomes, itself for most
  std::size_t moved = 0;       ///< vertices that become another
  double farthest = 0;         ///< mm
};

/// Pairs up vertices on rims that are at most `distance` mm apart, where that is at most half of the
/// shortest edge at either of them, and no triangle has both. A vertex never moves onto one that
/// moves itself: nothing gets farther than `distance`. The vertex with the lower id stays.
[[nodiscard]] NearCorners nearCorners(const TriangleMesh& mesh, double distance);

}  // namespace thicken::repairing
