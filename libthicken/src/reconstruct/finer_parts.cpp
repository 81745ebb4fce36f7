// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/finer_parts.h"

#include <algorithm>
#include <utility>

#include "mesh/topology.h"
#include "parallel_for.h"
#include "reconstruct/complete.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/shell_plan.h"

namespace thicken {

namespace {

// A solid of this method in place of the sweep. Only what it left to the sweep knows which vertices it is a
// copy of: walls elsewhere and the contour stay as they are.
SweepResult asSwept(const Reconstruction& made, const TriangleMesh& surface, const ClosestPointTree& tree,
                    const RunContext& context, int threads) {
  SweepResult swept;
  swept.mesh = made.mesh;
  swept.region = made.region;
  swept.base.assign(made.mesh.positions.size(), kNone);
  for (VertexId v = 0; v < surface.positions.size(); ++v) swept.base[v] = v;
  for (std::size_t t = 0; t < made.left.size(); ++t)
    if (made.left[t])
      for (const VertexId v : made.mesh.triangles[t]) swept.base[v] = made.base[v];
  swept.up.assign(swept.base.size(), Vec3::Zero());
  for (const WallEnd& end : made.ends) swept.up[end.vertex] = end.up;
  swept.distance.resize(swept.base.size());
  parallelFor(swept.base.size(), threads, context, 1024, [&](std::size_t v) {
    if (v >= surface.positions.size() && swept.base[v] != kNone)
      swept.distance[v] = tree.distance(swept.mesh.positions[v]);
  });
  return swept;
}

std::vector<TriangleId> leftOf(const Reconstruction& made) {
  std::vector<TriangleId> ids;
  for (TriangleId t = 0; t < made.left.size(); ++t)
    if (made.left[t]) ids.push_back(t);
  return ids;
}

}  // namespace

std::optional<Reconstruction> contouredAgain(const Reconstruction& made, const FinerParts& parts,
                                             const TriangleMesh& surface, const ClosestPointTree& tree,
                                             const Options& options, const RunContext& context, int threads,
                                             Stopwatch& watch) {
  constexpr int kRings = 2;
  const SweepResult swept = asSwept(made, surface, tree, context, threads);
  ContourTask task;
  task.keep.assign(made.region.size(), 1);
  task.openable = made.openable;
  cutAround(made.mesh, parts.triangles, task.openable, kRings, task.keep);
  task.area = openArea(swept, task.keep);
  task.width = parts.width;
  if (!parts.isAllowed(task.width, task.area)) return std::nullopt;
  task.crossings = mostCrossings(task.area, task.width);
  task.working = workingSetFor(task.crossings, heldBytes(surface), context);
  task.mayKeepShell = parts.mayKeepShell;
  task.left = made.left;
  task.left.resize(made.region.size(), 0);
  auto finer = completeIfPossible(surface, tree, swept, std::move(task), options, context, threads, watch);
  if (!finer) return std::nullopt;
  finer->rounds += made.rounds;
  finer->cells += made.cells;
  finer->nodes += made.nodes;
  finer->predicted = std::max(finer->predicted, made.predicted);
  finer->shellArea = made.shellArea;
  finer->cell = made.cell;
  finer->finest = std::min(finer->finest, made.finest);
  return finer;
}

Reconstruction withFinerParts(Reconstruction made, const TriangleMesh& surface, const ClosestPointTree& tree,
                              const Options& options, const AllowsCells& isAllowed, const RunContext& context,
                              int threads, Stopwatch& watch) {
  constexpr double kFiner = 0.6, kLittle = 1e-3;  // of the width; of the shell
  constexpr int kMostTimes = 3;
  double width = made.cell;
  for (int i = 0; i < kMostTimes && made.leftArea > kLittle * made.shellArea; ++i) {
    width *= kFiner;
    auto finer = contouredAgain(made, {leftOf(made), width, true, isAllowed}, surface, tree, options, context,
                                threads, watch);
    if (!finer) break;
    if (finer->leftArea < made.leftArea) made = *std::move(finer);
  }
  return made;
}

}  // namespace thicken
