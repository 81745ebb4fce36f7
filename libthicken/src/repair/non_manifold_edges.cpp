// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/non_manifold_edges.h"

#include "repair/fans.h"
#include "repair/retreat.h"
#include "repair/sheets.h"

namespace thicken::repairing {

bool endSheetsAtEdges(Workpiece& piece) {
  const Sheets sheets = sheetsOf(piece);
  if (sheets.edges.empty()) return false;
  const std::size_t slots = 3 * piece.mesh.triangles.size();
  GivenUp given{std::vector<std::uint8_t>(slots, 0), std::vector<std::uint8_t>(slots, 0)};
  for (const NonManifoldEdge& edge : sheets.edges)
    for (const std::uint32_t slot : edge.slots)
      given.edge[slot] = slot != edge.through[0] && slot != edge.through[1];
  const mesh::VertexTriangles around =
      mesh::vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  giveUpNonManifold(piece, around, sheets.areaAt, given);
  retreat(piece, given, RepairKind::kNonManifoldEdge);
  return true;
}

}  // namespace thicken::repairing
