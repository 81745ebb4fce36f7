// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Makes what a run added to S as coarse as the tolerance allows.
#pragma once

#include <vector>

#include "job/job.h"
#include "thicken/result.h"

namespace thicken::simplify {

/// Collapses edges of the shell and the walls of `solid`, whose first vertices and triangles are those of S
/// (on Side::kBoth: vertices only). They stay, as do their ids. Afterwards no triangles meet that did not
/// before, and the shell is no farther from its definition than the tolerance, or 1 % of the thickness, where
/// it was not before. A solid that is not closed and manifold is left as it is.
/// `what` stands for Options::simplify.
[[nodiscard]] SimplifyFacts simplify(const job::Job& job, TriangleMesh& solid, std::vector<Region>& region,
                                     Simplify what);

/// Bytes that this takes for a solid of so many triangles, with the solid. Measured, with a margin.
[[nodiscard]] inline std::size_t bytesToSimplify(std::size_t triangles) {
  return 400 * triangles;
}

}  // namespace thicken::simplify
