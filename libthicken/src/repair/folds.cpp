// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/folds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

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

void removeFan(Workpiece& piece, const VertexTriangles& around, VertexId v) {
  for (const TriangleId t : around.of(v)) piece.remove(t, RepairKind::kFolded);
}

void removeBeyondFan(Workpiece& piece, const VertexTriangles& around, VertexId v) {
  for (const TriangleId t : around.of(v))
    for (const VertexId w : piece.mesh.triangles[t]) removeFan(piece, around, w);
}

}  // namespace

int FoldOpener::timesNamed(const TriangleMesh& mesh, const VertexTriangles& around, VertexId v) const {
  int most = 0;
  for (const TriangleId t : around.of(v))
    for (const VertexId w : mesh.triangles[t]) {
      const Vec3& p = mesh.positions[w];
      const auto found = named_.find({p[0], p[1], p[2]});
      if (found != named_.end()) most = std::max(most, found->second);
    }
  return most;
}

RepairResult FoldOpener::open(const RepairResult& before, std::span<const VertexId> vertices,
                              const RunContext& context, int threads) {
  Workpiece piece(before.mesh);
  piece.origin = before.origin;
  const VertexTriangles around = vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  std::vector<int> times;
  for (const VertexId v : vertices) times.push_back(timesNamed(piece.mesh, around, v));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexId v = vertices[i];
    if (around.of(v).empty()) continue;
    if (times[i] == 0)
      piece.remove(farthestTurned(piece.mesh, around.of(v)), RepairKind::kFolded);
    else if (times[i] == 1)
      removeFan(piece, around, v);
    else
      removeBeyondFan(piece, around, v);
    const Vec3& p = piece.mesh.positions[v];
    named_[{p[0], p[1], p[2]}] = times[i] + 1;
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
