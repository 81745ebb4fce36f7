// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/folds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "repair/fans.h"
#include "repair/ledger.h"
#include "repair/patch.h"
#include "repair/put_back.h"
#include "thicken/check.h"

namespace thicken::repairing {

using mesh::VertexTriangles;

namespace {

constexpr int kMostTrials = 8;
// Each takes a trial. The largest triangles are most of the area.
constexpr std::size_t kMostReturns = 16;

Vec3 areaVector(const TriangleMesh& mesh, TriangleId t) {
  const Triangle& c = mesh.triangles[t];
  const Vec3& p = mesh.positions[c[0]];
  return (mesh.positions[c[1]] - p).cross(mesh.positions[c[2]] - p);
}

std::vector<TriangleId> fanOf(const Workpiece& piece, const VertexTriangles& around, VertexId v) {
  std::vector<TriangleId> fan;
  for (const TriangleId t : around.of(v))
    if (piece.present[t] != 0) fan.push_back(t);
  return fan;
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
  for (const TriangleId t : fanOf(piece, around, v)) piece.remove(t, RepairKind::kFolded);
}

void removeBeyondFan(Workpiece& piece, const VertexTriangles& around, VertexId v) {
  for (const TriangleId t : fanOf(piece, around, v))
    for (const VertexId w : piece.mesh.triangles[t]) removeFan(piece, around, w);
}

RepairResult provedResult(const Workpiece& piece, const RepairFacts& before, const RunContext& context,
                          int threads) {
  RepairResult result = packed(piece, before.weldDistance, Ledger(before));
  result.facts.seams = before.seams;
  result.facts.added = before.added;
  if (result.mesh.triangles.empty())
    throw Error(ErrorCode::kNoSolid, "nothing remains of the surface without its folds; smooth or remesh it");
  return proved(std::move(result), context, threads);
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

void FoldOpener::removeAt(Workpiece& piece, const VertexTriangles& around,
                          std::span<const VertexId> vertices) {
  std::vector<int> times;
  for (const VertexId v : vertices) times.push_back(timesNamed(piece.mesh, around, v));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexId v = vertices[i];
    const std::vector<TriangleId> fan = fanOf(piece, around, v);
    const Vec3& p = piece.mesh.positions[v];
    named_[{p[0], p[1], p[2]}] = times[i] + 1;
    if (fan.empty()) continue;
    if (times[i] == 0)
      piece.remove(farthestTurned(piece.mesh, fan), RepairKind::kFolded);
    else if (times[i] == 1)
      removeFan(piece, around, v);
    else
      removeBeyondFan(piece, around, v);
  }
  openNonManifoldVertices(piece, around);
}

// Tries what is near the places that were changed. What was opened before is not tried again: each trial
// would be as long as all before it.
std::vector<VertexId> FoldOpener::stuckNear(const Workpiece& piece, const VertexTriangles& around,
                                            std::span<const VertexId> seeds) const {
  const Patch patch = patchAround(piece, around, seeds);
  if (patch.mesh.triangles.empty()) return {};
  std::vector<VertexId> stuck;
  for (const VertexId v : trial_(patch.mesh))
    if (patch.whole[v] != 0) stuck.push_back(patch.vertex[v]);
  return stuck;
}

void FoldOpener::putBackLargest(Workpiece& piece, const VertexTriangles& around) const {
  std::vector<std::pair<double, TriangleId>> gone;
  for (TriangleId t = 0; t < piece.present.size(); ++t)
    if (piece.present[t] == 0) gone.emplace_back(-piece.area(t), t);
  std::sort(gone.begin(), gone.end());
  gone.resize(std::min(gone.size(), kMostReturns));
  const MeetingGraph none(piece.present.size(), {});
  std::vector<std::uint8_t> candidate(piece.present.size(), 0);
  for (const auto& [area, t] : gone) {
    candidate[t] = 1;
    putBack(piece, around, none, candidate);
    candidate[t] = 0;
    if (piece.present[t] != 0 && !stuckNear(piece, around, piece.mesh.triangles[t]).empty())
      piece.remove(t, piece.reason[t]);
  }
}

RepairResult FoldOpener::open(const RepairResult& before, std::span<const VertexId> vertices,
                              const RunContext& context, int threads) {
  Workpiece piece(before.mesh);
  piece.origin = before.origin;
  const VertexTriangles around = mesh::vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  std::vector<VertexId> stuck(vertices.begin(), vertices.end());
  const bool first = named_.empty();
  for (int trial = 0; !stuck.empty() && trial < kMostTrials; ++trial) {
    context.throwIfCancelled();
    removeAt(piece, around, stuck);
    stuck = stuckNear(piece, around, stuck);
  }
  if (!stuck.empty()) removeAt(piece, around, stuck);
  // Later ones would come back, and be named again, in turn.
  if (first) putBackLargest(piece, around);
  return provedResult(piece, before.facts, context, threads);
}

}  // namespace thicken::repairing
