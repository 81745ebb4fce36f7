// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/sweep_walls.h"

#include <algorithm>
#include <utility>

#include "mesh/normals.h"
#include "parallel/parallel_for.h"
#include "sweep/direction.h"
#include "sweep/initial_depth.h"
#include "sweep/retreat.h"
#include "sweep/split.h"
#include "sweep/swept_mesh.h"

namespace thicken {

namespace {

// The sweep without shell triangles and without the copies that only those use.
SweptMesh wallsOf(const SweptMesh& whole) {
  SweptMesh walls = whole;
  walls.triangles.clear();
  walls.region.clear();
  for (Copy& c : walls.copies) c.dropped = true;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    if (whole.region[t] == Region::kShell) continue;
    walls.triangles.push_back(whole.triangles[t]);
    walls.region.push_back(whole.region[t]);
    for (const VertexId v : whole.triangles[t])
      if (walls.isCopy(v)) walls.copyOf(v).dropped = false;
  }
  walls.fixed.resize(walls.triangles.size());
  return walls;
}

// Returns whether every wall got a clear depth.
bool settleWalls(SweptMesh& walls, const ClosestPointTree& tree, std::size_t& rounds,
                 const RunContext& context, int threads) {
  setInitialDepths(walls, tree, context, threads);
  const CopyGraph graph = copyGraph(walls, threads);
  limitSlope(walls, graph, {});
  std::vector<double> goal;
  for (std::size_t i = 0; i < walls.copies.size(); ++i) {
    goal.push_back(walls.copies[i].depth);
    walls.place(i);
  }
  ConflictTester tester(walls, context, threads);
  const RetreatResult result = retreat(walls, graph, tester, tester.all(), context);
  if (!result.buried.empty() || !result.stuck.empty()) return false;
  rounds = result.rounds;
  advance(walls, graph, tester, goal, context);
  return true;
}

}  // namespace

std::optional<SweepResult> sweepWalls(const TriangleMesh& surface, const ClosestPointTree& tree,
                                      double thickness, const RunContext& context, int threads) {
  const auto normal = faceNormals(surface.positions, surface.triangles, threads);
  const auto around = vertexTriangles(surface.positions.size(), surface.triangles, threads);
  const Rim rim = rimOf(surface.positions.size(), surface.triangles, threads);
  SweptMesh whole = sweepMesh(surface, sweepDirections(surface, normal, around, rim, thickness, threads), rim,
                              thickness, Side::kNegative, threads);
  markBlockedRimCopies(whole, around, rim);
  SweptMesh walls = wallsOf(whole);
  for (const Copy& c : walls.copies)
    if (!c.dropped && c.safety < kLeastSafety) return std::nullopt;
  SweepResult result;
  if (!settleWalls(walls, tree, result.rounds, context, threads)) return std::nullopt;

  result.shellProved = false;
  result.mesh.triangles = std::move(whole.triangles);
  result.region = std::move(whole.region);
  result.depth.assign(surface.positions.size(), thickness);
  result.distance.assign(walls.positions.size(), 0);
  for (VertexId v = 0; v < walls.positions.size(); ++v)
    result.base.push_back(walls.isCopy(v) ? walls.copyOf(v).base : v);
  result.mesh.positions = std::move(walls.positions);
  parallelFor(walls.copies.size(), threads, context, 512, [&](std::size_t i) {
    if (walls.copies[i].dropped) return;
    const VertexId v = walls.vertexOf(i);
    result.distance[v] = tree.distance(result.mesh.positions[v]);
    result.depth[walls.copies[i].base] = result.distance[v];
  });
  return result;
}

}  // namespace thicken
