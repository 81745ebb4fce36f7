// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Triangulation of a closed 3D polygon with the least area (Barequet & Sharir 1995), by dynamic
// programming over its chords.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/edge_key.h"
#include "thicken/mesh.h"

namespace thicken::mesh {

/// Triangles over the vertices of `loop`, in its sense, without a chord that is in `forbidden` (by edgeKey())
/// and of triangles that `allowed` accepts. Empty when there is none, or when the loop is too long for the
/// cubic cost (kLongestLoop).
[[nodiscard]] std::vector<Triangle> minimalAreaTriangulation(
    std::span<const Vec3> positions, std::span<const VertexId> loop, const EdgeSet& forbidden,
    const std::function<bool(const Triangle&)>& allowed);

inline constexpr std::size_t kLongestLoop = 600;

}  // namespace thicken::mesh
