// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parts of a solid that was made are contoured once more, in finer cells; all else is the carrier for them.
#pragma once

#include <functional>

#include "reconstruct/in_windows.h"
#include "reconstruct/reconstruction.h"
#include "thicken/closest_point.h"
#include "thicken/options.h"

namespace thicken {

/// Whether cells of `width` mm may be taken for `area` mm².
using AllowsCells = std::function<bool(double width, double area)>;

/// A boundary whose holes are closed where they can be; elsewhere it stays as it is. `finest` is 0 where none
/// can; `depth` and `shellArea` are not set.
[[nodiscard]] Reconstruction madeInWindows(const TriangleMesh& surface, const Holes& holes,
                                           const WindowTask& task, const Options& options,
                                           const RunContext& context, int threads, Stopwatch& watch);

/// `made` with what it left to the sweep in finer and finer cells, and then what is not proved to be within
/// the tolerance of `options`, where there is one, until it is or no finer cells are allowed.
[[nodiscard]] Reconstruction refined(Reconstruction made, const TriangleMesh& surface,
                                     const ClosestPointTree& tree, const Options& options,
                                     const AllowsCells& isAllowed, const RunContext& context, int threads,
                                     Stopwatch& watch);

}  // namespace thicken
