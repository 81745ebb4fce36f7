// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Makes what a run added to S as coarse as the tolerance allows.
#pragma once

#include <optional>
#include <vector>

#include "thicken/closest_point.h"
#include "thicken/options.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken {

/// What was thickened, and how.
struct SimplifyRequest {
  const TriangleMesh& surface;  ///< S, its triangles as the solid has them
  const ClosestPointTree& tree;
  double thickness = 0;  ///< mm
  Side side = Side::kNegative;
  Join join = Join::kMitre;
  std::optional<double> tolerance;  ///< mm: Options::tolerance, proved for whole triangles
  Simplify what = Simplify::kAuto;
};

/// Collapses edges of the shell and the walls of `solid`, whose first vertices and triangles are those of S
/// (on Side::kBoth: vertices only). They stay, as do their ids. Afterwards no triangles meet that did not
/// before, and the shell is no farther from its definition than the tolerance, or 1 % of the thickness, where
/// it was not before. A solid that is not closed and manifold is left as it is.
[[nodiscard]] SimplifyFacts simplify(TriangleMesh& solid, std::vector<Region>& region,
                                     const SimplifyRequest& request, const RunContext& context, int threads);

/// Bytes that this takes for a solid of so many triangles, with the solid. Measured, with a margin.
[[nodiscard]] inline std::size_t bytesToSimplify(std::size_t triangles) {
  return 400 * triangles;
}

}  // namespace thicken
