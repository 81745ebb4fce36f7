// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The exact audit of a result: decides every clause of the library's guarantee on the coordinates
// as they will be stored.
#pragma once

#include <span>
#include <vector>

#include "exact/pair_search.h"
#include "thicken/error.h"
#include "thicken/mesh.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken::checking {

struct AuditResult {
  AuditFacts facts;
  std::vector<Defect> defects;  ///< what failed, and where
};

/// Audits `solid`. `surface` (already welded and checked) must be found among its triangles: as it
/// is for kNegative, with every triangle reversed for kPositive; for kBoth its rim edges must be
/// edges of the solid. Vertices of equal coordinates are welded before anything is decided, as any
/// reader of an STL would. "Outward" is decided for nested components: a component within an even
/// number of others has positive volume, within an odd number negative. `order`: the leaves' order of a
/// BoxTree over the same triangles, or empty; it saves time and decides nothing. `most`: triangles that are
/// searched for meetings at a time (PairSearch).
[[nodiscard]] AuditResult audit(const TriangleMesh& solid, const TriangleMesh& surface, Side side,
                                const RunContext& context, int threads,
                                std::span<const TriangleId> order = {},
                                std::size_t most = exact::PairSearch::kAll);

}  // namespace thicken::checking
