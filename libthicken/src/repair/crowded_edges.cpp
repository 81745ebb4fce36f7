// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/crowded_edges.h"

#include <algorithm>

#include "mesh/half_edges.h"
#include "mesh/union_find.h"

namespace thicken::repairing {
namespace {

struct Use {
  TriangleId triangle;
  bool forward;
  double patchArea;
  TriangleId patch;
  double area;
};

// Triangles joined across edges of exactly two.
UnionFind patchesOf(const Workpiece& piece, const HalfEdges& edges) {
  UnionFind patches(piece.mesh.triangles.size());
  edges.forEachEdge([&](VertexId, VertexId, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
    if (uses.size() + back.size() != 2) return;
    patches.join(uses[0].triangle(), back.empty() ? uses[1].triangle() : back[0].triangle());
  });
  return patches;
}

// Removes all but two. The second one is of the other sense where there is one, so that the two make
// one sheet as they are.
void keepTwo(Workpiece& piece, std::vector<Use>& uses) {
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    if (a.patchArea != b.patchArea) return a.patchArea > b.patchArea;
    if (a.patch != b.patch) return a.patch < b.patch;
    if (a.area != b.area) return a.area > b.area;
    return a.triangle < b.triangle;
  });
  const auto fits = [&](const Use& u) { return u.forward != uses[0].forward; };
  auto second = std::find_if(uses.begin() + 1, uses.end(), fits);
  if (second == uses.end()) second = uses.begin() + 1;
  for (auto u = uses.begin() + 1; u != uses.end(); ++u)
    if (u != second) piece.remove(u->triangle, RepairKind::kNonManifoldEdge);
}

}  // namespace

void thinCrowdedEdges(Workpiece& piece) {
  const HalfEdges edges(piece.mesh.positions.size(), piece.mesh.triangles, piece.present);
  UnionFind patches = patchesOf(piece, edges);
  std::vector<double> patchArea(piece.mesh.triangles.size(), 0);
  for (TriangleId t = 0; t < patchArea.size(); ++t)
    if (piece.present[t] != 0) patchArea[patches.root(t)] += piece.area(t);
  edges.forEachEdge([&](VertexId, VertexId, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
    if (uses.size() + back.size() <= 2) return;
    std::vector<Use> here;
    for (const auto& list : {uses, back})
      for (const HalfEdge& e : list) {
        const TriangleId t = e.triangle(), patch = patches.root(t);
        if (piece.present[t] != 0)
          here.push_back({t, list.data() == uses.data(), patchArea[patch], patch, piece.area(t)});
      }
    if (here.size() > 2) keepTwo(piece, here);
  });
}

}  // namespace thicken::repairing
