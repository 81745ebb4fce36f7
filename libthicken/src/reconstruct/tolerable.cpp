// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/tolerable.h"

#include <utility>

#include "measure/error_bound.h"
#include "measure/stopwatch.h"

namespace thicken {

Reconstruction withinTolerance(Reconstruction made, const TriangleMesh& surface, const ClosestPointTree& tree,
                               const Options& options, const AllowsCells& isAllowed,
                               const RunContext& context, int threads, Stopwatch& watch) {
  constexpr double kFiner = 0.5;
  constexpr int kMostTimes = 5, kMostFailures = 2;
  if (!options.tolerance) return made;
  double width = made.cell;
  for (int i = 0, failures = 0; i < kMostTimes && failures < kMostFailures; ++i) {
    const std::vector<TriangleId> beyond = shellBeyond(made.mesh, made.region, tree, options.thickness,
                                                       Side::kNegative, *options.tolerance, context, threads);
    watch.lap("tolerance");
    if (beyond.empty()) break;
    // What cannot be joined in cells of one width may be in finer ones.
    if (auto finer = contouredAgain(made, {beyond, width *= kFiner, false, isAllowed}, surface, tree, options,
                                    context, threads, watch))
      made = *std::move(finer);
    else
      ++failures;
  }
  return made;
}

}  // namespace thicken
