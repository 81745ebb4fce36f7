// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 7: a vertex at which parts of the surface touch keeps one of them. Vertices of equal
// coordinates are one to every reader of a file, so that the others have to withdraw from it.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"
#include "repair/retreat.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// The triangles at a vertex that are present, in groups: those that share an edge at it. Edges that
/// `lost` marks (GivenUp::edge; empty: none) are shared with nobody.
[[nodiscard]] std::vector<std::vector<TriangleId>> fansAt(const Workpiece& piece,
                                                          const mesh::VertexTriangles& around, VertexId v,
                                                          std::span<const std::uint8_t> lost = {});

/// At each vertex of several fans all but one give it up: the one of the sheet with the largest area
/// stays (`areaAt`, per triangle), and of these the one with the largest area itself.
void giveUpNonManifold(const Workpiece& piece, const mesh::VertexTriangles& around,
                       std::span<const double> areaAt, GivenUp& given);

/// Cuts parts back that touch others in a point only. Returns whether there were any.
bool cutNonManifoldVertices(Workpiece& piece);

/// At each vertex of several fans of triangles all but the one with the largest area are removed,
/// until no such vertex is left.
void openNonManifoldVertices(Workpiece& piece, const mesh::VertexTriangles& around);

}  // namespace thicken::repairing
