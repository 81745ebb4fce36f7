// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 7: a vertex at which parts of the surface touch keeps one of them. Vertices of equal
// coordinates are one to every reader of a file, so that the others have to withdraw from it.
#pragma once

#include <vector>

#include "mesh/topology.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// The triangles at a vertex that are present, in groups: those that share an edge at it.
[[nodiscard]] std::vector<std::vector<TriangleId>> fansAt(const Workpiece& piece,
                                                          const VertexTriangles& around, VertexId v);

/// At each vertex of several fans of triangles all but the one with the largest area are removed,
/// until no such vertex is left.
void openPinchedVertices(Workpiece& piece, const VertexTriangles& around);

}  // namespace thicken::repairing
