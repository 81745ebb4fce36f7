// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Most triangles whose boxes overlap are neighbours. One look at the vertex that they share proves most of
// these clear of each other: if all triangles around it turn the same side to some axis and go round it once,
// they lie side by side as seen along that axis.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::exact {

/// Per vertex 1 if it is proved, exactly, that no two of the triangles around it meet (exact::meet). 0 says
/// nothing. It is the answer at rims, at non-manifold edges and vertices, around creases, and if all
/// triangles are `fixed` (empty: none are).
[[nodiscard]] std::vector<std::uint8_t> clearFans(std::span<const Vec3> positions,
                                                  std::span<const Triangle> triangles,
                                                  std::span<const std::uint8_t> fixed, int threads);

/// The same for the `triangles` around one vertex.
[[nodiscard]] bool isClearFan(std::span<const Vec3> positions, VertexId centre,
                              std::span<const Triangle> triangles);

}  // namespace thicken::exact
