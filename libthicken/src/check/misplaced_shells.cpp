// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/misplaced_shells.h"

#include <algorithm>

#include "check/nesting.h"
#include "exact/box_tree.h"
#include "mesh/bounds.h"
#include "mesh/half_edges.h"

namespace thicken::checking {

using mesh::Bounds;
using mesh::Components;

namespace {

class Judge {
 public:
  Judge(const TriangleMesh& mesh, std::span<const Region> region, const Components& shells, int threads)
      : mesh_(mesh),
        region_(region),
        shells_(shells),
        edges_(mesh.positions.size(), mesh.triangles, {}, threads),
        lowest_(lowestVertices(mesh, shells)),
        tree_(mesh.positions, mesh.triangles, threads, trianglesBelow(mesh, lowest_, threads)),
        bounds_(shells.count) {
    for (TriangleId t = 0; t < region.size(); ++t)
      for (const VertexId v : mesh.triangles[t]) bounds_[shells.ofTriangle[t]].add(mesh.positions[v]);
  }

  [[nodiscard]] bool isMisplaced(std::uint32_t shell) const {
    const bool isOuter = facesOutward(mesh_, edges_, lowest_[shell]);
    return isOuter == insideOddNumber(mesh_, tree_, shells_, lowest_[shell], shell) ||
           (isOuter && !mayHoldSurface(bounds_[shell]));
  }

 private:
  [[nodiscard]] bool mayHoldSurface(const Bounds& bounds) const {
    for (TriangleId t = 0; t < region_.size(); ++t)
      if (region_[t] == Region::kOriginal && bounds.contains(mesh_.positions[mesh_.triangles[t][0]]))
        return true;
    return false;
  }

  const TriangleMesh& mesh_;
  std::span<const Region> region_;
  const Components& shells_;
  mesh::HalfEdges edges_;
  std::vector<VertexId> lowest_;
  exact::BoxTree tree_;
  std::vector<Bounds> bounds_;
};

}  // namespace

std::vector<std::uint8_t> misplacedShells(const TriangleMesh& mesh, std::span<const Region> region,
                                          const Components& shells, int threads) {
  std::vector<std::uint8_t> isMisplaced(shells.count, 1);
  for (TriangleId t = 0; t < region.size(); ++t)
    if (region[t] == Region::kOriginal) isMisplaced[shells.ofTriangle[t]] = 0;
  if (std::ranges::find(isMisplaced, 1) == isMisplaced.end()) return isMisplaced;
  const Judge judge(mesh, region, shells, threads);
  for (std::uint32_t shell = 0; shell < shells.count; ++shell)
    if (isMisplaced[shell]) isMisplaced[shell] = judge.isMisplaced(shell);
  return isMisplaced;
}

}  // namespace thicken::checking
