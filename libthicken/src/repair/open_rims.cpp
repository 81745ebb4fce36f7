// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/open_rims.h"

#include <algorithm>

#include "exact/predicates.h"
#include "exact/triangle_pair.h"

namespace thicken::repairing {

using mesh::Bounds;
using mesh::boundsOf;
using mesh::Rim;

namespace {

bool meetsAny(std::span<const Vec3> at, const Triangle& triangle, std::span<const Triangle> others,
              const exact::BoxTree& tree) {
  Bounds box;
  for (const VertexId v : triangle) box.add(at[v]);
  const std::vector<TriangleId> near = tree.near(box.low, box.high);
  return std::any_of(near.begin(), near.end(),
                     [&](TriangleId t) { return exact::meet(at, triangle, others[t]); });
}

}  // namespace

Rim openRimsOf(const Workpiece& piece, int threads) {
  std::vector<Triangle> present;
  std::vector<TriangleId> id;
  for (TriangleId t = 0; t < piece.mesh.triangles.size(); ++t) {
    if (piece.present[t] == 0) continue;
    present.push_back(piece.mesh.triangles[t]);
    id.push_back(t);
  }
  Rim rim = mesh::rimOf(piece.mesh.positions.size(), present, threads);
  for (mesh::RimEdge& edge : rim.edges) edge.triangle = id[edge.triangle];
  return rim;
}

Additions::Additions(Workpiece& piece, int threads)
    : piece_(piece),
      surface_(piece.mesh.triangles),
      tree_(piece.mesh.positions, piece.mesh.triangles, threads, piece.present) {}

bool Additions::isFree(const Triangle& triangle) const {
  const auto& at = piece_.mesh.positions;
  return !exact::collinear(at[triangle[0]], at[triangle[1]], at[triangle[2]]) &&
         !meetsAny(at, triangle, surface_, tree_);
}

bool Additions::fits(const std::vector<Triangle>& patch) const {
  const auto& at = piece_.mesh.positions;
  for (const Triangle& t : patch) {
    if (!isFree(t)) return false;
    const Bounds box = boundsOf(piece_.mesh, t);
    for (const Patch& other : added_)
      if (other.box.overlaps(box) && meetsAny(at, t, other.triangles, other.tree)) return false;
  }
  const exact::BoxTree own(at, patch, 1);
  return own.meetingPairs(at, patch, {}, RunContext(), 1, 1).empty();
}

void Additions::add(const std::vector<Triangle>& patch, RepairKind why) {
  Bounds box;
  for (const Triangle& t : patch) {
    box.add(boundsOf(piece_.mesh, t));
    piece_.addNew(t, why);
  }
  added_.push_back({patch, box, exact::BoxTree(piece_.mesh.positions, patch, 1)});
}

}  // namespace thicken::repairing
