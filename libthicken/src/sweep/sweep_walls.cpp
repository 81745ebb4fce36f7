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

namespace thicken::sweep {

using job::Job;

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
bool settleWalls(SweptMesh& walls, const Job& job, std::size_t& rounds) {
  setInitialDepths(walls, job);
  const CopyGraph graph = copyGraph(walls, job.threads);
  limitSlope(walls, graph, {});
  std::vector<double> goal;
  for (std::size_t i = 0; i < walls.copies.size(); ++i) {
    goal.push_back(walls.copies[i].depth);
    walls.place(i);
  }
  ConflictTester tester(walls, job.context, job.threads);
  const RetreatResult result = retreat(walls, graph, tester, tester.all(), job.context);
  if (!result.buried.empty() || !result.stuck.empty()) return false;
  rounds = result.rounds;
  advance(walls, graph, tester, goal, job.context);
  return true;
}

}  // namespace

std::optional<SweepResult> sweepWalls(const Job& job) {
  const TriangleMesh& surface = job.surface;
  const auto normal = mesh::faceNormals(surface.positions, surface.triangles, job.threads);
  const auto around = mesh::vertexTriangles(surface.positions.size(), surface.triangles, job.threads);
  const mesh::Rim rim = mesh::rimOf(surface.positions.size(), surface.triangles, job.threads);
  const std::vector<std::vector<SweepDirection>> direction{
      sweepDirections(job, normal, offsetPlanes(job, normal, -1), around, rim)};
  SweptMesh whole = sweepMesh(job, direction, rim);
  markBlockedRimCopies(whole, around, rim);
  SweptMesh walls = wallsOf(whole);
  for (const Copy& c : walls.copies)
    if (!c.dropped && c.safety < kLeastSafety) return std::nullopt;
  SweepResult result;
  if (!settleWalls(walls, job, result.rounds)) return std::nullopt;

  result.shellProved = false;
  result.mesh.triangles = std::move(whole.triangles);
  result.region = std::move(whole.region);
  for (VertexId v = 0; v < surface.positions.size(); ++v) result.depth.push_back(job.thickness.at(v));
  result.distance.assign(walls.positions.size(), 0);
  for (VertexId v = 0; v < walls.positions.size(); ++v)
    result.base.push_back(walls.isCopy(v) ? walls.copyOf(v).base : v);
  result.mesh.positions = std::move(walls.positions);
  parallel::parallelFor(walls.copies.size(), job.threads, job.context, 512, [&](std::size_t i) {
    if (walls.copies[i].dropped) return;
    const VertexId v = walls.vertexOf(i);
    result.distance[v] = job.tree.distance(result.mesh.positions[v]);
    result.depth[walls.copies[i].base] = result.distance[v];
  });
  return result;
}

}  // namespace thicken::sweep
