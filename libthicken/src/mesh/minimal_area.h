// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Triangulation of a closed 3D polygon with the least area (Barequet & Sharir 1995), by dynamic
// programming over its chords.
#pragma once

#include "thicken/mesh.h"

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

namespace thicken {

/// Undirected edges as (smaller id << 32 | larger id); other uses put directed ones the same way.
using EdgeSet = std::unordered_set<std::uint64_t>;

/// Triangles over the vertices of `loop`, in its sense, without a chord that is in `forbidden` and
/// without a triangle of exactly no area. Empty when there is none, or when the loop is too long
/// for the cubic cost (kLongestLoop).
[[nodiscard]] std::vector<Triangle> minimalAreaTriangulation(std::span<const Vec3> positions,
                                                             std::span<const VertexId> loop, const EdgeSet& forbidden);

inline constexpr std::size_t kLongestLoop = 600;

}  // namespace thicken
