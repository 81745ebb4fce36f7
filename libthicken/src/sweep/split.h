// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two copies for a vertex that no single direction serves: where the triangles around v face so
// differently that no m has n·m > 0 for all of them, the fan is divided in two sectors with a
// direction each, and bridged along the dividing edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

/// Sets the safety of those copies on the rim to 0 that meet S however little they are moved: where
/// the fan of an end of the rim winds above itself, the wall of the upper part would cut the lower.
/// `mesh` must be fresh from sweepMesh.
void markBlockedRimCopies(SweptMesh& mesh, const mesh::VertexTriangles& around, const mesh::Rim& rim);

/// Splits the copies `ids` of `mesh` where some division of the fan passes
/// exact tests next to the vertex, and takes the one with the safest directions. Returns the copies
/// that no division serves.
[[nodiscard]] std::vector<std::uint32_t> splitCopies(SweptMesh& mesh, std::span<const Vec3> faceNormal,
                                                     const mesh::VertexTriangles& around,
                                                     std::span<const std::uint32_t> ids);

}  // namespace thicken::sweep
