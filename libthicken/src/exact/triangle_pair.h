// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whether two triangles of a mesh meet where they must not.
#pragma once

#include <span>
#include <utility>

#include "thicken/mesh.h"

namespace thicken::exact {

using TrianglePair = std::pair<TriangleId, TriangleId>;  ///< first < second

/// Whether triangles `a` and `b` (neither of them degenerate) have a point in common other than
/// shared vertices and a shared edge; vertices are shared by index. Touching counts. Triangles with
/// the same three vertices meet. Exact.
[[nodiscard]] bool meet(std::span<const Vec3> positions, const Triangle& a, const Triangle& b);

}  // namespace thicken::exact
