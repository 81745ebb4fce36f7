// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which way round the shells of a solid are, and which of them lie in one another.
#pragma once

#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "mesh/half_edges.h"
#include "mesh/topology.h"
#include "thicken/mesh.h"

namespace thicken::checking {

/// The lexicographically smallest vertex of each component.
[[nodiscard]] std::vector<VertexId> lowestVertices(const TriangleMesh& mesh, const mesh::Components& shells);

/// Whether the shell that `lowest` is the lowest vertex of has its positive side outside (positive
/// volume). Exact. The shell must be closed, manifold, of one sense and free of intersections.
[[nodiscard]] bool facesOutward(const TriangleMesh& mesh, const mesh::HalfEdges& edges, VertexId lowest);

/// The triangles that the two functions below may need for these vertices. A tree over the others is not
/// needed.
[[nodiscard]] std::vector<std::uint8_t> trianglesBelow(const TriangleMesh& mesh,
                                                       std::span<const VertexId> vertices, int threads);

/// Whether `v` lies inside an odd number of shells other than its own. Exact for shells that are
/// closed and neither intersect one another nor themselves.
[[nodiscard]] bool insideOddNumber(const TriangleMesh& mesh, const exact::BoxTree& tree,
                                   const mesh::Components& shells, VertexId v, std::uint32_t ownShell);

/// The shells other than its own that `v` lies inside, ascending, under the same conditions.
[[nodiscard]] std::vector<std::uint32_t> shellsAround(const TriangleMesh& mesh, const exact::BoxTree& tree,
                                                      const mesh::Components& shells, VertexId v,
                                                      std::uint32_t ownShell);

}  // namespace thicken::checking
