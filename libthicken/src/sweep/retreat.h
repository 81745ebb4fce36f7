// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Draws the copies of a sweep back until, by exact tests of all pairs of triangles at the stored
// coordinates, none meet; and lets them advance again as far as the tests allow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sweep/conflicts.h"
#include "sweep/slope_limit.h"
#include "sweep/swept_mesh.h"
#include "thicken/run_context.h"

namespace thicken::sweep {

struct RetreatResult {
  std::size_t rounds = 0;
  /// Copies whose triangles still meet others at the least depth that their coordinates can tell
  /// from S, ascending; empty when nothing meets any more.
  std::vector<std::uint32_t> stuck;
  /// Vertices of S between which triangles without a copy, the fillings of holes, still meet others when
  /// nothing can be drawn back any more, ascending.
  std::vector<VertexId> buried;
};

/// Lowers depths round by round: draws back the copies of the triangles that meet, keeps the slope,
/// tests what moved. `conflicts`: all that there are. Terminates, since a round lowers depths by a fixed
/// factor and depths have a least value.
[[nodiscard]] RetreatResult retreat(SweptMesh& mesh, const CopyGraph& graph, ConflictTester& tester,
                                    Conflicts conflicts, const RunContext& context);

/// Raises depths towards `goal` (one per copy), a step at a time, and takes back what meets. The
/// sweep must be free of conflicts and stays so.
void advance(SweptMesh& mesh, const CopyGraph& graph, ConflictTester& tester, std::span<const double> goal,
             const RunContext& context);

}  // namespace thicken::sweep
