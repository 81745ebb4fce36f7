// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The paper's method: the field of Definitions 1 and 2 on sparse cells, the contour of the part of ∂H
// that is to be made, joined to the unsplit rim, shaped, tested exactly and refined where tests fail.
#pragma once

#include <optional>

#include "reconstruct/reconstruction.h"
#include "sweep/sweep.h"
#include "thicken/closest_point.h"
#include "thicken/options.h"
#include "thicken/run_context.h"

namespace thicken {

class Stopwatch;

/// Reconstructs on the negative side of `surface` (valid, welded; `tree` is its tree). Throws kNoSolid
/// with the place, kMemoryLimit, kCancelled. Stages are added to `watch`.
[[nodiscard]] Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree,
                                         const Options& options, const RunContext& context, int threads,
                                         Stopwatch& watch);

/// Replaces the shell of `swept` (of `surface` to its negative side) by the contour of the field where it is
/// not at the thickness: all of it, or its worst places where that would take too many cells. Nothing where
/// there is no such place. Throws as reconstruct() does.
[[nodiscard]] std::optional<Reconstruction> deepen(const TriangleMesh& surface, const ClosestPointTree& tree,
                                                   const SweepResult& swept, const Options& options,
                                                   const RunContext& context, int threads, Stopwatch& watch);

}  // namespace thicken
