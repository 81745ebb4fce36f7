// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Decides whether a mesh is a valid input: finite, not empty, edge- and vertex-manifold,
// consistently oriented, without degenerate or duplicate triangles, free of self-intersection.
// Exact: every geometric decision is made with exact predicates on the coordinates as given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thicken/error.h"
#include "thicken/mesh.h"
#include "thicken/repair.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken {

struct CheckResult {
  SurfaceFacts facts;                 ///< as far as they make sense for what was found
  std::optional<NearRims> nearRims;   ///< where nearRims() was asked, too
  std::vector<Defect> defects;        ///< all kinds that were found, at most one entry a kind; empty: valid
  std::size_t enoughMemory = 0;       ///< bytes; left 0 by check(): what reading and checking took
  std::vector<std::string> warnings;  ///< left empty by check(): for what reading the file passed over
  [[nodiscard]] bool valid() const noexcept { return defects.empty(); }
};

/// Finds every kind of defect of `mesh` at once. Corners with equal coordinates have to be one
/// vertex already (weld()). Throws only kCancelled, kMemoryLimit and kArithmetic. Cost: O(n log n).
[[nodiscard]] CheckResult check(const TriangleMesh& mesh, RunContext context = {}, int threads = 0);

/// Makes corners with equal coordinates one vertex (−0 equals 0) and drops unused positions; the
/// order of first use and of the triangles is kept. Triangles that lose a corner by it stay, as
/// degenerate triangles that check() names. The same for any number of `threads` (0: all).
[[nodiscard]] TriangleMesh weld(const TriangleMesh& mesh, int threads = 1);

}  // namespace thicken
