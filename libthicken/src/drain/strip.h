// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Triangulates a flat polygon by ear clipping, the best shaped ears first.
#pragma once

#include <vector>

#include "thicken/mesh.h"

namespace thicken::drain {

/// Triangles over the vertices of `loop`, which runs counter-clockwise in the first two coordinates of
/// `flat` (one entry a vertex of the loop). Every triangle has a positive area there. Empty when the
/// polygon is not simple.
[[nodiscard]] std::vector<Triangle> triangulate(const std::vector<VertexId>& loop,
                                                const std::vector<Vec3>& flat);

}  // namespace thicken::drain
