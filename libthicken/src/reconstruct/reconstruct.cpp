// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <functional>
#include <utility>

#include "measure/measure.h"
#include "reconstruct/cells.h"
#include "reconstruct/complete.h"
#include "reconstruct/depths.h"
#include "reconstruct/finer_parts.h"
#include "reconstruct/shell_plan.h"
#include "sweep/sweep.h"
#include "sweep/sweep_walls.h"

namespace thicken::reconstruct {

using job::Job;
using sweep::SweepResult;

namespace {

// The shell that is to be contoured, and the width of the cells for it, mm.
struct WholeShell {
  double area = 0, shadows = 0;  // mm²
  double width = 0;
};

// Whether cells of a width may be tried after wider ones have failed.
AllowsCells finerCells(const Job& job) {
  return [&](double width, double area) {
    return !job.options.cell && !job.options.resolution && fewCells(width, area) &&
           !workingSetFor(mostCrossings(area, width), heldBytes(job.surface), job.context).isLean;
  };
}

// The task of contouring all of the shell.
WholeShell wholeShell(const Job& job) {
  const double area = measure::areaOf(job.surface);
  return {area, shellShadows(job), cellWidth(job, area)};
}

// The solid with no shell but the contour's.
Reconstruction wholeContour(const Job& job, const std::function<const SweepResult&()>& swept,
                            const WholeShell& shell) {
  const std::size_t crossings = mostShellCrossings(shell.shadows, shell.width);
  const WorkingSet working = requireRoomForField(job, crossings, shell.width);
  const auto below = [&](const SweepResult& walls) {
    job.watch.lap("sweep");
    ContourTask task{std::vector<std::uint8_t>(walls.mesh.triangles.size()),
                     shell.area,
                     shell.width,
                     crossings,
                     working,
                     walls.shellProved};
    for (std::size_t t = 0; t < task.keep.size(); ++t) task.keep[t] = walls.region[t] != Region::kShell;
    return complete(job, walls, std::move(task));
  };
  // Most surfaces need no more of the sweep than its walls.
  if (const auto walls = sweep::sweepWalls(job))
    if (auto made = below(*walls)) return refined(job, *std::move(made), finerCells(job));
  const SweepResult& all = swept();
  return refined(job, *below(all), finerCells(job));
}

}  // namespace

Reconstruction reconstruct(const Job& job) {
  SweepResult swept;
  const auto sweepAll = [&]() -> const SweepResult& { return swept = sweep::sweep(job, sweep::Polish::kNo); };
  return wholeContour(job, sweepAll, wholeShell(job));
}

std::optional<Reconstruction> deepen(const Job& job, const SweepResult& swept) {
  ShellPlan plan = planShell(job, swept);
  if (plan.keepsAll()) return std::nullopt;
  const double r = job.thickness.least();
  if (job.options.tolerance) {
    // Finer cells are for the worst places alone, with a seam around them. A contour of the whole shell has
    // none, and keeps a tolerance more often.
    constexpr double kCoarsest = 1.0 / 3;  // of r
    const WholeShell shell = wholeShell(job);
    if (shell.width < kCoarsest * r && hasRoomForField(job, mostShellCrossings(shell.shadows, shell.width)))
      return wholeContour(
          job, [&]() -> const SweepResult& { return swept; }, shell);
  }
  const double own = plan.width;
  plan.width = widthWithRoom(job, mostCrossings(plan.area, own), own);
  if (!(plan.width < r / 2)) plan.width = own;  // which is refused
  const std::size_t crossings = mostCrossings(plan.area, plan.width);
  (void)requireRoomForField(job, crossings, plan.width);
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
  task.held = heldBytes(job.surface);
  Reconstruction made = madeInWindows(job, holes, task);
  made.cell = plan.width;
  made.shellArea = plan.area;
  made.predicted = std::max(made.predicted, heldBytes(job.surface) + wholeBytes(crossings));
  made.depth = depthsOf(job, made, swept);
  made.origin.clear();
  return refined(job, std::move(made), finerCells(job));
}

}  // namespace thicken::reconstruct
