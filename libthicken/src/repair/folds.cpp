// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/folds.h"

#include <Eigen/Geometry>
#include <utility>

#include "repair/fans.h"
#include "repair/ledger.h"
#include "repair/workpiece.h"
#include "thicken/check.h"

namespace thicken::repairing {
namespace {

Vec3 areaVector(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& c = mesh.triangles[t];
  const Vec3& p = mesh.positions[c[0]];
  return (mesh.positions[c[1]] - p).cross(mesh.positions[c[2]] - p);
}

// The triangle whose normal agrees least with the mean of all around the vertex.
TriangleId farthestTurned(const TriangleMesh& mesh, std::span<const TriangleId> fan) {
  Vec3 mean = Vec3::Zero();
  for (const TriangleId t : fan) mean += areaVector(mesh, t);
  TriangleId worst = fan.front();
  double least = 2;
  for (const TriangleId t : fan) {
    const double agreement = areaVector(mesh, t).normalized().dot(mean.normalized());
    if (agreement >= least) continue;
    least = agreement;
    worst = t;
  }
  return worst;
}

}  // namespace

RepairResult openFolds(const RepairResult& before, std::span<const VertexId> vertices, int attempt,
                       const RunContext& context, int threads) {
  Workpiece piece(before.mesh);
  piece.origin = before.origin;
  const VertexTriangles around = vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  for (const VertexId v : vertices) {
    const std::span<const TriangleId> fan = around.of(v);
    if (fan.empty()) continue;
    if (attempt < kWholeFans) {
      piece.remove(farthestTurned(piece.mesh, fan), RepairKind::kFolded);
    } else {
      for (const TriangleId t : fan) piece.remove(t, RepairKind::kFolded);
    }
  }
  openPinchedVertices(piece, around);
  RepairResult result = packed(piece, before.facts.weldDistance, Ledger(before.facts));
  if (result.mesh.triangles.empty())
    throw Error(ErrorCode::kNoSolid, "nothing remains of the surface without its folds; smooth or remesh it");
  CheckResult proof = check(result.mesh, context, threads);
  if (!proof.valid())
    throw Error(ErrorCode::kInternal, "the repaired surface is not valid: " + proof.defects.front().sentence,
                std::move(proof.defects));
  result.facts.surface = proof.facts;
  return result;
}

}  // namespace thicken::repairing
