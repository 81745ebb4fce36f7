// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What every stage between the check of a surface and the audit of its solid knows.
#pragma once

#include "job/stopwatch.h"
#include "job/thickness.h"
#include "thicken/closest_point.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/run_context.h"

namespace thicken::job {

struct Job {
  const TriangleMesh& surface;   ///< S: valid, welded, its negative side where the material is to be
  const ClosestPointTree& tree;  ///< of the surface
  Thickness thickness;
  const Options& options;  ///< whose thickness and side are those above
  const RunContext& context;
  int threads = 1;
  Stopwatch& watch;  ///< stages are added to it
};

/// The side of such a surface that is swept.
[[nodiscard]] inline Side sweptSide(const Job& job) {
  return job.options.side == Side::kBoth ? Side::kBoth : Side::kNegative;
}

}  // namespace thicken::job
