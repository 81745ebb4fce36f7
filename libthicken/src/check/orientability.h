// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whether the triangles of a surface can be given one sense by turning some of them over.
#pragma once

#include <vector>

#include "mesh/half_edges.h"
#include "thicken/mesh.h"

namespace thicken::checking {

struct Orientability {
  std::vector<std::array<VertexId, 2>>
      oneSided;                    ///< edges at which a one-sided part closes on itself the wrong way round
  std::vector<TriangleId> toTurn;  ///< ascending: the smaller share of each part that can be given one sense
};

/// Follows edges that are used exactly twice.
[[nodiscard]] Orientability orientability(const TriangleMesh& mesh, const mesh::HalfEdges& edges);

}  // namespace thicken::checking
