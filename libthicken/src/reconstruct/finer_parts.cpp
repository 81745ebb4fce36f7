// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/finer_parts.h"

#include <algorithm>
#include <utility>

#include "mesh/topology.h"
#include "parallel_for.h"
#include "reconstruct/complete.h"
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
  swept.distance.resize(swept.base.size());
  parallelFor(swept.base.size(), threads, context, 1024, [&](std::size_t v) {
    if (v >= surface.positions.size() && swept.base[v] != kNone)
      swept.distance[v] = tree.distance(swept.mesh.positions[v]);
  });
  return swept;
}

}  // namespace

std::vector<std::uint8_t> keptAroundLeft(const TriangleMesh& mesh, std::span<const Region> region,
                                         std::span<const std::uint8_t> left) {
  constexpr int kRings = 2;
  std::vector<std::uint8_t> keep(region.size(), 1), near(mesh.positions.size(), 0);
  const auto giveOver = [&](std::size_t t) {
    keep[t] = 0;
    for (const VertexId v : mesh.triangles[t]) near[v] = 1;
  };
  for (std::size_t t = 0; t < left.size(); ++t)
    if (left[t]) giveOver(t);
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<std::size_t> next;
    for (std::size_t t = 0; t < keep.size(); ++t)
      if (keep[t] && region[t] == Region::kShell &&
          std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                      [&](VertexId v) { return near[v]; }))
        next.push_back(t);
    for (const std::size_t t : next) giveOver(t);
  }
  return keep;
}

Reconstruction withFinerParts(Reconstruction made, const TriangleMesh& surface, const ClosestPointTree& tree,
                              const Options& options,
                              const std::function<bool(double width, double area)>& isAllowed,
                              const RunContext& context, int threads, Stopwatch& watch) {
  constexpr double kFiner = 0.6, kLittle = 1e-3;  // of the width; of the shell
  constexpr int kMostTimes = 3;
  double width = made.cell;
  for (int i = 0; i < kMostTimes && made.leftArea > kLittle * made.shellArea; ++i) {
    width *= kFiner;
    const SweepResult swept = asSwept(made, surface, tree, context, threads);
    ContourTask task;
    task.keep = keptAroundLeft(made.mesh, made.region, made.left);
    task.area = openArea(swept, task.keep);
    task.width = width;
    if (!isAllowed(width, task.area)) break;
    task.crossings = mostCrossings(task.area, width);
    task.working = requireRoomForField(surface, task.crossings, options.thickness, width, context);
    task.mayKeepShell = true;
    task.left = made.left;
    Reconstruction finer = *complete(surface, tree, swept, std::move(task), options, context, threads, watch);
    finer.rounds += made.rounds;
    finer.cells += made.cells;
    finer.nodes += made.nodes;
    finer.predicted = std::max(finer.predicted, made.predicted);
    finer.shellArea = made.shellArea;
    finer.cell = made.cell;
    finer.finest = std::min(finer.finest, made.finest);
    if (finer.leftArea < made.leftArea) made = std::move(finer);
  }
  return made;
}

}  // namespace thicken
