// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/finer_parts.h"

#include <algorithm>
#include <utility>

#include "measure/error_bound.h"
#include "measure/stopwatch.h"
#include "parallel/parallel_for.h"
#include "reconstruct/cells.h"
#include "reconstruct/complete.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/depths.h"
#include "reconstruct/in_windows.h"
#include "reconstruct/loose_parts.h"
#include "reconstruct/shell_plan.h"

namespace thicken {

namespace {

// Parts of a solid's shell that are to be made again in cells of `width` mm.
struct Parts {
  std::vector<TriangleId> triangles;
  double width = 0;
  bool mayKeepShell = false;  // ContourTask
};

class Refiner {
 public:
  Refiner(const TriangleMesh& surface, const ClosestPointTree& tree, const Options& options,
          const AllowsCells& isAllowed, const RunContext& context, int threads, Stopwatch& watch)
      : surface_(surface),
        tree_(tree),
        options_(options),
        isAllowed_(isAllowed),
        context_(context),
        threads_(threads),
        watch_(watch) {}

  // Where sheets are too close for the cells, the sweep's shell may be kept, which may be far too thin.
  Reconstruction whereLeft(Reconstruction made) {
    constexpr double kFiner = 0.6, kLittle = 1e-3;  // of the width; of the shell
    // What is left has to become so much less for still finer cells, each of which cost three times as much.
    constexpr double kLess = 0.7;
    constexpr int kMostTimes = 3;
    double width = made.cell;
    for (int i = 0; i < kMostTimes && made.leftArea > kLittle * made.shellArea; ++i) {
      width *= kFiner;
      auto finer = again(made, {leftOf(made), width, true});
      if (!finer) break;
      const bool isWorthMore = finer->leftArea < kLess * made.leftArea;
      if (finer->leftArea < made.leftArea) made = *std::move(finer);
      if (!isWorthMore) break;
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
      std::vector<TriangleId> beyond = shellBeyond(made.mesh, made.region, tree_, options_.thickness,
                                                   Side::kNegative, *options_.tolerance, context_, threads_);
      watch_.lap("tolerance");
      if (beyond.empty()) break;
      // What cannot be joined in cells of one width may be in finer ones.
      if (auto finer = again(made, {std::move(beyond), width *= kFiner, false}))
        made = *std::move(finer);
      else
        ++failures;
    }
    return made;
  }

 private:
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
    for (VertexId v = 0; v < surface_.positions.size(); ++v) swept.base[v] = v;
    for (std::size_t t = 0; t < made.left.size(); ++t)
      if (made.left[t])
        for (const VertexId v : made.mesh.triangles[t]) swept.base[v] = made.base[v];
    swept.up.assign(swept.base.size(), Vec3::Zero());
    for (const WallEnd& end : made.ends) swept.up[end.vertex] = end.up;
    swept.distance.resize(swept.base.size());
    parallelFor(swept.base.size(), threads_, context_, 1024, [&](std::size_t v) {
      if (v >= surface_.positions.size() && swept.base[v] != kNone)
        swept.distance[v] = tree_.distance(swept.mesh.positions[v]);
    });
    return swept;
  }

  // `made` with `parts`, and a few triangles around them, contoured again; nothing where that takes more
  // cells than allowed, or can nowhere be joined.
  std::optional<Reconstruction> again(const Reconstruction& made, const Parts& parts) {
    constexpr int kRings = 2;
    constexpr std::size_t kAttempts =
        20;  // with any number garments took up to five times as long
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
    task.held = heldBytes(surface_);
    // There is something in its place already, which is not worth any number of attempts.
    if (parts.mayKeepShell) task.attempts = kAttempts;
    std::optional<Reconstruction> finer =
        madeInWindows(surface_, holes, task, options_, context_, threads_, watch_);
    if (finer->finest == 0) return std::nullopt;
    finer->origin.clear();
    finer->rounds += made.rounds;
    finer->cells += made.cells;
    finer->nodes += made.nodes;
    finer->predicted = std::max(finer->predicted, made.predicted);
    finer->shellArea = made.shellArea;
    finer->cell = made.cell;
    finer->finest = std::min(finer->finest, made.finest);
    finer->depth = depthsOf(*finer, surface_, tree_, options_.thickness, context_, threads_);
    return finer;
  }

  const TriangleMesh& surface_;
  const ClosestPointTree& tree_;
  const Options& options_;
  const AllowsCells& isAllowed_;
  const RunContext& context_;
  int threads_;
  Stopwatch& watch_;
};

}  // namespace

Reconstruction madeInWindows(const TriangleMesh& surface, const Holes& holes, const WindowTask& task,
                             const Options& options, const RunContext& context, int threads,
                             Stopwatch& watch) {
  InWindows in = completeInWindows(surface, holes, task, options, context, threads, watch);
  Reconstruction made = withWindows(surface, holes, in.windows, in.made);
  dropMisplaced(made, surface.positions.size(), threads);
  return made;
}

Reconstruction refined(Reconstruction made, const TriangleMesh& surface, const ClosestPointTree& tree,
                       const Options& options, const AllowsCells& isAllowed, const RunContext& context,
                       int threads, Stopwatch& watch) {
  Refiner refiner(surface, tree, options, isAllowed, context, threads, watch);
  made = refiner.whereLeft(std::move(made));
  return options.tolerance ? refiner.toTolerance(std::move(made)) : made;
}

}  // namespace thicken
