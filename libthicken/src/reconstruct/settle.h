// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Moves the contour's vertices to their targets as far as exact tests of all pairs of triangles allow.
#pragma once

#include "exact/box_tree.h"
#include "reconstruct/assembly.h"

namespace thicken {

/// Places the contour's vertices at `target` (floats), back towards where they started where triangles
/// meet, and evens out what still meets. Returns the triangles that meet in the end, ascending.
[[nodiscard]] std::vector<TriangleId> settle(Assembly& assembly, std::span<const Vec3> target,
                                             const RunContext& context, int threads);

}  // namespace thicken
