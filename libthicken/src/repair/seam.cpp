// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/seam.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "mesh/union_find.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::UnionFind;

namespace {

struct SeamEdge {
  VertexId a, b;
  std::array<std::uint32_t, 2> slots;  // the two half-edges, both from a to b
};

std::uint32_t next(std::uint32_t slot) {
  return slot % 3 == 2 ? slot - 2 : slot + 1;
}

// One side of a chain: the triangles that touch it there, and the edges of the chain that it lies at.
struct SideOfChain {
  std::vector<TriangleId> triangles;
  std::size_t edges = 0;
  double area = 0;
};

class SeamCut {
 public:
  explicit SeamCut(Workpiece& piece)
      : piece_(piece),
        edges_(piece.mesh.positions.size(), piece.mesh.triangles, piece.present),
        corners_(3 * piece.mesh.triangles.size()),
        chains_(piece.mesh.positions.size()) {
    edges_.forEachEdge(
        [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
          if (uses.size() == 1 && back.size() == 1) {
            corners_.join(uses[0].slot, next(back[0].slot));
            corners_.join(next(uses[0].slot), back[0].slot);
          } else if (uses.size() == 2) {
            seam_.push_back({a, b, {uses[0].slot, uses[1].slot}});
            chains_.join(a, b);
          }
        });
    // the fans on one side of the chain are linked by the triangles at its edges
    for (const SeamEdge& e : seam_)
      for (const std::uint32_t slot : e.slots) corners_.join(slot, next(slot));
  }

  void run() {
    std::map<VertexId, std::vector<SeamEdge>> chains;
    for (const SeamEdge& e : seam_) chains[chains_.root(e.a)].push_back(e);
    for (const auto& [root, chain] : chains) {
      if (!removeSmallerSide(chain)) removeOneAtEachEdge(chain);
    }
  }

 private:
  bool removeSmallerSide(const std::vector<SeamEdge>& chain) {
    std::map<std::uint32_t, SideOfChain> sides;
    for (const SeamEdge& e : chain) {
      const std::uint32_t first = corners_.root(e.slots[0]), second = corners_.root(e.slots[1]);
      ++sides[first].edges;
      if (second != first) ++sides[second].edges;
      for (const VertexId v : {e.a, e.b})
        for (const HalfEdge& h : edges_.from(v))
          sides[corners_.root(h.slot)].triangles.push_back(h.triangle());
    }
    const SideOfChain* best = nullptr;
    for (auto& [root, side] : sides) {
      auto& list = side.triangles;
      mesh::sortUnique(list);
      for (const TriangleId t : list) side.area += piece_.area(t);
      if (side.edges == chain.size() && (best == nullptr || side.area < best->area)) best = &side;
    }
    if (best == nullptr) return false;
    for (const TriangleId t : best->triangles) piece_.remove(t, RepairKind::kOneSided);
    return true;
  }

  // Where chains branch no side lies at all of their edges.
  void removeOneAtEachEdge(const std::vector<SeamEdge>& chain) {
    for (const SeamEdge& e : chain) {
      const TriangleId t = e.slots[0] / 3, u = e.slots[1] / 3;
      if (piece_.present[t] == 0 || piece_.present[u] == 0) continue;
      piece_.remove(piece_.area(t) <= piece_.area(u) ? t : u, RepairKind::kOneSided);
    }
  }

  Workpiece& piece_;
  mesh::HalfEdges edges_;
  UnionFind corners_;  // by 3 · triangle + corner
  UnionFind chains_;   // by vertex
  std::vector<SeamEdge> seam_;
};

}  // namespace

void cutAlongSeams(Workpiece& piece) {
  SeamCut(piece).run();
}

}  // namespace thicken::repairing
