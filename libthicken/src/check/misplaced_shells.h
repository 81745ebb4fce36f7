// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Shells of a solid without triangles of S that bound nothing which the solid is to have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken::checking {

/// Per shell of a mesh without intersections: whether it has no triangle of S and is inside out, or is the
/// outer side of material that has nothing of S in it. All material hangs together with S. Exact, by where
/// the lowest vertex of the shell lies.
[[nodiscard]] std::vector<std::uint8_t> misplacedShells(const TriangleMesh& mesh,
                                                        std::span<const Region> region,
                                                        const mesh::Components& shells, int threads);

}  // namespace thicken::checking
