// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <functional>
#include <utility>

#include "measure/measure.h"
#include "measure/stopwatch.h"
#include "reconstruct/cells.h"
#include "reconstruct/complete.h"
#include "reconstruct/depths.h"
#include "reconstruct/finer_parts.h"
#include "reconstruct/shell_plan.h"
#include "sweep/sweep.h"
#include "sweep/sweep_walls.h"

namespace thicken {

namespace {

// The shell that is to be contoured, and the width of the cells for it, mm.
struct WholeShell {
  double area = 0, shadows = 0;  // mm²
  double width = 0;
};

// Whether cells of a width may be tried where wider ones did not do.
AllowsCells finerCells(const TriangleMesh& surface, const Options& options, const RunContext& context) {
  return [&](double width, double area) {
    return !options.cell && !options.resolution && fewCells(width, area) &&
           !workingSetFor(mostCrossings(area, width), heldBytes(surface), context).isLean;
  };
}

// The solid with no shell but the contour's.
Reconstruction wholeContour(const TriangleMesh& surface, const ClosestPointTree& tree,
                            const std::function<const SweepResult&()>& swept, const WholeShell& shell,
                            const Options& options, const RunContext& context, int threads,
                            Stopwatch& watch) {
  const std::size_t crossings = mostShellCrossings(shell.shadows, shell.width);
  const WorkingSet working = requireRoomForField(surface, crossings, options.thickness, shell.width, context);
  const auto below = [&](const SweepResult& walls) {
    watch.lap("sweep");
    ContourTask task{std::vector<std::uint8_t>(walls.mesh.triangles.size()),
                     shell.area,
                     shell.width,
                     crossings,
                     working,
                     walls.shellProved};
    for (std::size_t t = 0; t < task.keep.size(); ++t) task.keep[t] = walls.region[t] != Region::kShell;
    return complete(surface, tree, walls, std::move(task), options, context, threads, watch);
  };
  // Most surfaces need no more of the sweep than its walls.
  if (const auto walls = sweepWalls(surface, tree, options.thickness, context, threads))
    if (auto made = below(*walls))
      return refined(*std::move(made), surface, tree, options, finerCells(surface, options, context), context,
                     threads, watch);
  const SweepResult& all = swept();
  return refined(*below(all), surface, tree, options, finerCells(surface, options, context), context, threads,
                 watch);
}

}  // namespace

Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree, const Options& options,
                           const RunContext& context, int threads, Stopwatch& watch) {
  const double area = areaOf(surface);
  const WholeShell shell{area, shellShadows(surface, options.thickness, threads),
                         cellWidth(surface, area, options)};
  SweepResult swept;
  const auto sweepAll = [&]() -> const SweepResult& {
    return swept = sweep(surface, tree, options.thickness, Side::kNegative, context, threads, Polish::kNo);
  };
  return wholeContour(surface, tree, sweepAll, shell, options, context, threads, watch);
}

std::optional<Reconstruction> deepen(const TriangleMesh& surface, const ClosestPointTree& tree,
                                     const SweepResult& swept, const Options& options,
                                     const RunContext& context, int threads, Stopwatch& watch) {
  ShellPlan plan = planShell(surface, swept, tree, options, context, threads);
  if (plan.keepsAll()) return std::nullopt;
  const double r = options.thickness;
  if (options.tolerance) {
    // Finer cells are for the worst places alone, with a seam around them. A contour of the whole shell has
    // none, and keeps a tolerance more often.
    constexpr double kCoarsest = 1.0 / 3;  // of r
    const double area = areaOf(surface);
    const WholeShell shell{area, shellShadows(surface, r, threads), cellWidth(surface, area, options)};
    const std::size_t crossings = mostShellCrossings(shell.shadows, shell.width);
    if (shell.width < kCoarsest * r && hasRoomForField(surface, crossings, context))
      return wholeContour(
          surface, tree, [&]() -> const SweepResult& { return swept; }, shell, options, context, threads,
          watch);
  }
  const double own = plan.width;
  plan.width = widthWithRoom(surface, mostCrossings(plan.area, own), own, options, context);
  if (!(plan.width < r / 2)) plan.width = own;  // which is refused
  const std::size_t crossings = mostCrossings(plan.area, plan.width);
  (void)requireRoomForField(surface, crossings, r, plan.width, context);
  Holes holes{swept, plan.keep, {}, {}};
  for (TriangleId t = 0; t < plan.keep.size(); ++t) {
    holes.openable.push_back(swept.region[t] == Region::kShell);
    holes.left.push_back(plan.keep[t] == 0);
  }
  WindowTask task;
  task.complete = &complete;
  task.width = plan.width;
  task.mayKeepShell = true;
  task.anyArea = true;
  task.held = heldBytes(surface);
  Reconstruction made = madeInWindows(surface, holes, task, options, context, threads, watch);
  made.cell = plan.width;
  made.shellArea = plan.area;
  made.predicted = std::max(made.predicted, heldBytes(surface) + wholeBytes(crossings));
  made.depth = depthsOf(made, swept, surface, tree, r, context, threads);
  made.origin.clear();
  return refined(std::move(made), surface, tree, options, finerCells(surface, options, context), context,
                 threads, watch);
}

}  // namespace thicken
