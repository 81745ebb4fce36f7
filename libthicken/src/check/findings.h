// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Finds defects of single triangles and of the way they are joined, as ids. check() and audit() make
// sentences of them.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "mesh/half_edges.h"
#include "thicken/mesh.h"
#include "thicken/run_context.h"

namespace thicken::checking {

using Edge = std::array<VertexId, 2>;

/// Triangles that are not proper ones, each kind ascending.
struct BadTriangles {
  std::vector<TriangleId> withoutArea;  ///< a corner twice, or corners on one line
  std::vector<std::pair<TriangleId, TriangleId>>
      duplicates;  ///< a later triangle with the corners of the first
  std::vector<std::uint8_t>
      joined;  ///< per triangle: three different corners, no duplicate: takes part in topology
  std::vector<std::uint8_t> proper;  ///< per triangle: joined, and with an area
};

/// `finite` false: coordinates are ignored, and a triangle is without area only if it names a vertex twice.
[[nodiscard]] BadTriangles badTriangles(const TriangleMesh& mesh, bool finite, const RunContext& context,
                                        int threads);

/// Defects of edges and vertices. Edges and vertices come in ascending order.
struct BadJoints {
  std::vector<Edge> rim;                      ///< used once; in the direction of its triangle
  std::vector<Edge> nonManifoldEdges;         ///< used more than twice
  std::vector<Edge> sameSense;                ///< used twice in this direction
  std::vector<VertexId> nonManifoldVertices;  ///< more than one fan of triangles, which touch only there
};
[[nodiscard]] BadJoints badJoints(const TriangleMesh& mesh, const mesh::HalfEdges& edges,
                                  const RunContext& context, int threads);

}  // namespace thicken::checking
