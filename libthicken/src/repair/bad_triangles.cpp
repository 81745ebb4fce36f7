// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/bad_triangles.h"

#include <algorithm>

#include "check/findings.h"
#include "check/surface_facts.h"
#include "exact/predicates.h"
#include "parallel/parallel_for.h"

namespace thicken::repairing {

void dropBadTriangles(Workpiece& piece, const RunContext& context, int threads) {
  const auto& p = piece.mesh.positions;
  const checking::BadTriangles bad = checking::badTriangles(piece.mesh, false, context, threads);
  for (const TriangleId t : bad.withoutArea) piece.remove(t, RepairKind::kDegenerate);
  for (const auto& pair : bad.duplicates) piece.remove(pair.second, RepairKind::kDuplicate);
  parallel::parallelFor(piece.mesh.triangles.size(), threads, context, 4096, [&](std::size_t t) {
    const Triangle& c = piece.mesh.triangles[t];
    const auto id = static_cast<TriangleId>(t);
    if (std::any_of(c.begin(), c.end(), [&](VertexId v) { return !checking::isFinite(p[v]); }))
      piece.remove(id, RepairKind::kNotFinite);
    else if (piece.present[t] != 0 && exact::collinear(p[c[0]], p[c[1]], p[c[2]]))
      piece.remove(id, RepairKind::kDegenerate);
  });
}

}  // namespace thicken::repairing
