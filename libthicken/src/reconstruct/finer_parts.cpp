// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/finer_parts.h"

#include <algorithm>
#include <utility>

#include "measure/error_bound.h"
#include "measure/measure.h"
#include "parallel/parallel_for.h"
#include "reconstruct/cells.h"
#include "reconstruct/complete.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/depths.h"
#include "reconstruct/in_windows.h"
#include "reconstruct/loose_parts.h"
#include "reconstruct/shell_plan.h"

namespace thicken::reconstruct {

using job::Job;
using mesh::kNone;
using sweep::SweepResult;

namespace {

// Parts of a solid's shell that are to be made again in cells of `width` mm.
struct Parts {
  std::vector<TriangleId> triangles;
  double width = 0;
  bool mayKeepShell = false;  // ContourTask
};

class Refiner {
 public:
  Refiner(const Job& job, const AllowsCells& isAllowed) : job_(job), isAllowed_(isAllowed) {}

  // Where sheets are too close for the cells, the sweep's shell may be kept, which may be far too thin.
  Reconstruction whereLeft(Reconstruction made) {
    constexpr double kFiner = 0.6, kLittle = 1e-3;  // of the width; of the shell
    // Little that is left has to become so much less for still finer cells, which cost three times as much.
    constexpr double kLess = 0.7;
    constexpr int kMostTimes = 3;
    double width = made.cell;
    for (int i = 0; i < kMostTimes && made.leftArea > kLittle * made.shellArea; ++i) {
      width *= kFiner;
      const bool isLittle = leavesLittle(made);
      auto finer = again(made, {leftOf(made), width, true});
      if (!finer) break;
      const bool isWorthMore = finer->leftArea < kLess * made.leftArea;
      if (finer->leftArea < made.leftArea) made = *std::move(finer);
      if (isLittle && !isWorthMore) break;
    }
    return made;
  }

  // Errors of a contour go with the square of the width of its cells, but at creases of the shell with the
  // width itself. So cells that do nearly everywhere are off there, and only there finer ones are taken.
  Reconstruction toTolerance(Reconstruction made) {
    constexpr double kFiner = 0.5;
    constexpr int kMostTimes = 5, kMostFailures = 2;
    double width = made.cell;
    for (int i = 0, failures = 0; i < kMostTimes && failures < kMostFailures; ++i) {
      std::vector<TriangleId> beyond =
          measure::shellBeyond(job_, made.mesh, made.region, *job_.options.tolerance);
      job_.watch.lap("tolerance");
      if (beyond.empty()) break;
      // A part that cannot be joined in cells of one width may be joined in finer ones.
      if (auto finer = again(made, {std::move(beyond), width *= kFiner, false}))
        made = *std::move(finer);
      else
        ++failures;
    }
    return made;
  }

 private:
  // Whether so little of the solid is left to the sweep that it is not worth any number of attempts. Garments
  // and skins that cross themselves leave 1 to 3 % whatever is tried; CAD parts with thick walls leave much
  // more at first, and little in finer cells.
  [[nodiscard]] bool leavesLittle(const Reconstruction& made) const {
    constexpr double kLittle = 0.05;
    return made.leftArea < kLittle * measure::areaOf(job_.surface);
  }

  static std::vector<TriangleId> leftOf(const Reconstruction& made) {
    std::vector<TriangleId> ids;
    for (TriangleId t = 0; t < made.left.size(); ++t)
      if (made.left[t]) ids.push_back(t);
    return ids;
  }

  // A solid of this method in place of the sweep. Only what it left to the sweep knows which vertices it is a
  // copy of: walls elsewhere and the contour stay as they are.
  [[nodiscard]] SweepResult asSwept(const Reconstruction& made) const {
    SweepResult swept;
    swept.mesh = made.mesh;
    swept.region = made.region;
    swept.base.assign(made.mesh.positions.size(), kNone);
    for (VertexId v = 0; v < job_.surface.positions.size(); ++v) swept.base[v] = v;
    for (std::size_t t = 0; t < made.left.size(); ++t)
      if (made.left[t])
        for (const VertexId v : made.mesh.triangles[t]) swept.base[v] = made.base[v];
    swept.up.assign(swept.base.size(), Vec3::Zero());
    for (const WallEnd& end : made.ends) swept.up[end.vertex] = end.up;
    swept.distance.resize(swept.base.size());
    parallel::parallelFor(swept.base.size(), job_.threads, job_.context, 1024, [&](std::size_t v) {
      if (v >= job_.surface.positions.size() && swept.base[v] != kNone)
        swept.distance[v] = job_.tree.distance(swept.mesh.positions[v]);
    });
    return swept;
  }

  // `made` with `parts`, and a few triangles around them, contoured again; nothing where that takes more
  // cells than allowed, or can nowhere be joined.
  std::optional<Reconstruction> again(const Reconstruction& made, const Parts& parts) {
    constexpr int kRings = 2;
    constexpr std::size_t kAttempts = 20;  // with any number garments took up to five times as long
    Holes holes;
    holes.carried = asSwept(made);
    holes.keep.assign(made.region.size(), 1);
    holes.openable = made.openable;
    holes.left = made.left;
    holes.left.resize(made.region.size(), 0);
    cutAround(made.mesh, parts.triangles, holes.openable, kRings, holes.keep);
    if (!isAllowed_(parts.width, openArea(holes.carried, holes.keep))) return std::nullopt;
    WindowTask task;
    task.complete = &complete;
    task.width = parts.width;
    task.mayKeepShell = parts.mayKeepShell;
    task.held = heldBytes(job_.surface);
    if (parts.mayKeepShell && leavesLittle(made)) task.attempts = kAttempts;
    std::optional<Reconstruction> finer = madeInWindows(job_, holes, task);
    if (finer->finest == 0) return std::nullopt;
    finer->origin.clear();
    finer->rounds += made.rounds;
    finer->cells += made.cells;
    finer->nodes += made.nodes;
    finer->predicted = std::max(finer->predicted, made.predicted);
    finer->shellArea = made.shellArea;
    finer->cell = made.cell;
    finer->finest = std::min(finer->finest, made.finest);
    finer->depth = depthsOf(job_, *finer);
    return finer;
  }

  const Job& job_;
  const AllowsCells& isAllowed_;
};

}  // namespace

Reconstruction madeInWindows(const Job& job, const Holes& holes, const WindowTask& task) {
  InWindows in = completeInWindows(job, holes, task);
  Reconstruction made = withWindows(job.surface, holes, in.windows, in.made);
  dropMisplaced(made, job.surface.positions.size(), job.threads);
  return made;
}

Reconstruction refined(const Job& job, Reconstruction made, const AllowsCells& isAllowed) {
  Refiner refiner(job, isAllowed);
  made = refiner.whereLeft(std::move(made));
  return job.options.tolerance ? refiner.toTolerance(std::move(made)) : made;
}

}  // namespace thicken::reconstruct
