// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <functional>
#include <utility>

#include "measure/measure.h"
#include "measure/stopwatch.h"
#include "reconstruct/best_width.h"
#include "reconstruct/complete.h"
#include "reconstruct/shell_plan.h"
#include "sweep/sweep.h"
#include "sweep/sweep_walls.h"

namespace thicken {

namespace {

// The solid with no shell but the contour's.
Reconstruction wholeContour(const TriangleMesh& surface, const ClosestPointTree& tree,
                            const std::function<const SweepResult&()>& swept, double area, double width,
                            const Options& options, const RunContext& context, int threads,
                            Stopwatch& watch) {
  const auto below = [&](const SweepResult& walls, double cell) {
    const std::size_t crossings = mostShellCrossings(surface, options.thickness, cell, threads);
    const WorkingSet working = requireRoomForField(surface, crossings, options.thickness, cell, context);
    watch.lap("sweep");
    ContourTask task{std::vector<std::uint8_t>(walls.mesh.triangles.size()),
                     area,
                     cell,
                     crossings,
                     working,
                     walls.shellProved};
    for (std::size_t t = 0; t < task.keep.size(); ++t) task.keep[t] = walls.region[t] != Region::kShell;
    return complete(surface, tree, walls, std::move(task), options, context, threads, watch);
  };
  // Most surfaces need no more of the sweep than its walls.
  if (const auto walls = sweepWalls(surface, tree, options.thickness, context, threads))
    if (auto made = below(*walls, width)) return *std::move(made);
  const SweepResult& all = swept();
  const auto isAllowed = [&](double cell) {
    constexpr double kMostCells = 1e5;
    if (options.cell || options.resolution || area > kMostCells * cell * cell) return false;
    const std::size_t crossings = mostShellCrossings(surface, options.thickness, cell, threads);
    const std::size_t limit = context.memoryLimit();
    return limit == 0 || heldBytes(surface) + wholeBytes(crossings) <= limit;
  };
  return bestOfWidths(width, isAllowed, [&](double cell) { return *below(all, cell); });
}

}  // namespace

Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree, const Options& options,
                           const RunContext& context, int threads, Stopwatch& watch) {
  const double area = areaOf(surface), width = cellWidth(surface, area, options);
  SweepResult swept;
  const auto sweepAll = [&]() -> const SweepResult& {
    return swept = sweep(surface, tree, options.thickness, Side::kNegative, context, threads, Polish::kNo);
  };
  return wholeContour(surface, tree, sweepAll, area, width, options, context, threads, watch);
}

std::optional<Reconstruction> deepen(const TriangleMesh& surface, const ClosestPointTree& tree,
                                     const SweepResult& swept, const Options& options,
                                     const RunContext& context, int threads, Stopwatch& watch) {
  // Finer cells are for the worst places alone, with a seam around them. A contour of the whole shell has
  // none.
  constexpr double kCoarsest = 1.0 / 3;  // of r
  ShellPlan plan = planShell(surface, swept, tree, options, context, threads);
  if (plan.keepsAll()) return std::nullopt;
  const double r = options.thickness, area = areaOf(surface);
  double width = cellWidth(surface, area, options);
  width = widthWithRoom(surface, mostShellCrossings(surface, r, width, threads), width, options, context);
  if (width >= kCoarsest * r ||
      !hasRoomForField(surface, mostShellCrossings(surface, r, width, threads), context)) {
    const double own = plan.width;
    plan.width = widthWithRoom(surface, mostCrossings(plan.area, own), own, options, context);
    if (!(plan.width < r / 2)) plan.width = own;  // which is refused
    const std::size_t crossings = mostCrossings(plan.area, plan.width);
    const WorkingSet working = requireRoomForField(surface, crossings, r, plan.width, context);
    return complete(surface, tree, swept,
                    {std::move(plan.keep), plan.area, plan.width, crossings, working, true}, options, context,
                    threads, watch);
  }
  const auto asMade = [&]() -> const SweepResult& { return swept; };
  return wholeContour(surface, tree, asMade, area, width, options, context, threads, watch);
}

}  // namespace thicken
