// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/finer_parts.h"

#include <algorithm>
#include <utility>

#include "mesh/topology.h"
#include "parallel_for.h"
#include "reconstruct/close_finer.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/depths.h"
#include "reconstruct/loose_parts.h"
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
  Holes holes;
  holes.carried = asSwept(made, surface, tree, context, threads);
  holes.keep.assign(made.region.size(), 1);
  holes.openable = made.openable;
  holes.left = made.left;
  holes.left.resize(made.region.size(), 0);
  cutAround(made.mesh, parts.triangles, holes.openable, kRings, holes.keep);
  if (!parts.isAllowed(parts.width, openArea(holes.carried, holes.keep))) return std::nullopt;
  std::size_t allowance = allowanceFor(made.region.size());
  ContourTask task;
  task.width = parts.width;
  task.mayKeepShell = parts.mayKeepShell;
  task.allowance = &allowance;
  const std::vector<Window> windows = windowsOf(surface, holes, options.thickness, parts.width, threads);
  std::vector<std::optional<Reconstruction>> inWindow(windows.size());
  bool any = false;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    inWindow[i] =
        completeWindow(surface, tree, windows[i], task, heldBytes(surface), options, context, threads, watch)
            .made;
    any |= inWindow[i].has_value();
  }
  if (!any) return std::nullopt;
  std::optional<Reconstruction> joined = withWindows(surface, holes, windows, inWindow);
  if (!joined) return std::nullopt;
  Reconstruction& finer = *joined;
  finer.origin.clear();
  dropMisplaced(finer, surface.positions.size(), threads);
  finer.depth = depthsOf(finer, surface, tree, options.thickness, context, threads);
  finer.rounds += made.rounds;
  finer.cells += made.cells;
  finer.nodes += made.nodes;
  finer.predicted = std::max(finer.predicted, made.predicted);
  finer.shellArea = made.shellArea;
  finer.cell = made.cell;
  finer.finest = std::min(finer.finest, made.finest);
  return joined;
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
