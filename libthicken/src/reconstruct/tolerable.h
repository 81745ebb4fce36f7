// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Errors of a contour go with the square of the width of its cells, but at creases of the shell with the width
// itself. So cells that do nearly everywhere are off there, and only there finer ones are taken.
#pragma once

#include "reconstruct/finer_parts.h"

namespace thicken {

/// `made` with what is not proved to be within the tolerance of `options` in finer and finer cells, until it is
/// or no finer ones are allowed. `made` itself where there is no tolerance.
[[nodiscard]] Reconstruction withinTolerance(Reconstruction made, const TriangleMesh& surface,
                                             const ClosestPointTree& tree, const Options& options,
                                             const AllowsCells& isAllowed, const RunContext& context,
                                             int threads, Stopwatch& watch);

}  // namespace thicken
