// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/crumbs.h"

#include "mesh/topology.h"
#include "mesh/union_find.h"

namespace thicken::repairing {

using mesh::kNone;

std::vector<std::uint32_t> partsOfPiece(const Workpiece& piece) {
  const auto& triangles = piece.mesh.triangles;
  mesh::UnionFind parts(triangles.size());
  std::vector<TriangleId> first(piece.mesh.positions.size(), kNone);
  for (TriangleId t = 0; t < triangles.size(); ++t) {
    if (piece.present[t] == 0) continue;
    for (const VertexId v : triangles[t])
      if (first[v] == kNone)
        first[v] = t;
      else
        parts.join(first[v], t);
  }
  return parts.roots(1);
}

void dropCrumbs(Workpiece& piece, std::span<const std::uint32_t> before, double least) {
  const std::vector<std::uint32_t> now = partsOfPiece(piece);
  std::vector<double> area(now.size(), 0);
  std::vector<std::uint8_t> several(now.size(), 0);
  for (TriangleId t = 0; t < now.size(); ++t) {
    if (piece.present[t] == 0) continue;
    area[now[t]] += piece.area(t);
    if (piece.origin[t] != piece.origin[now[t]]) several[now[t]] = 1;
  }
  // A part is whole unless triangles are gone that belonged to it.
  std::vector<std::uint8_t> broken(before.size(), 0);
  for (TriangleId t = 0; t < before.size(); ++t)
    if (piece.present[t] == 0) broken[before[t]] = 1;
  std::vector<std::uint32_t> partOfOrigin(piece.mesh.triangles.size(), kNone);
  for (TriangleId t = 0; t < before.size(); ++t)
    if (partOfOrigin[piece.origin[t]] == kNone || broken[before[t]] != 0)
      partOfOrigin[piece.origin[t]] = before[t];
  for (TriangleId t = 0; t < now.size(); ++t) {
    const bool crumb = area[now[t]] < least || several[now[t]] == 0;
    if (piece.present[t] != 0 && crumb && broken[partOfOrigin[piece.origin[t]]] != 0)
      piece.remove(t, RepairKind::kCrumb);
  }
}

}  // namespace thicken::repairing
