// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where an attempt failed, windows are made again in finer cells.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/bounds.h"
#include "reconstruct/attempt.h"
#include "reconstruct/contour_task.h"

namespace thicken::reconstruct {

/// What came of the finer cells.
struct Closing {
  std::optional<Reconstruction> made;  ///< if every window could be closed
  std::vector<TriangleId> stuck;       ///< of the assembly: triangles that meet where it could not
};

/// Cuts holes around the triangles that `meeting` lists after `attempt` at `task`, and closes them in finer
/// cells. The rest of the attempt is the carrier. Zones where the finest cells fail are added to `givenUp`,
/// and are not tried again. Throws kCancelled.
[[nodiscard]] Closing closedFiner(const job::Job& job, const sweep::SweepResult& swept,
                                  const ContourTask& task, const Attempt& attempt,
                                  std::span<const TriangleId> meeting, std::vector<mesh::Bounds>& givenUp,
                                  Complete& complete);

}  // namespace thicken::reconstruct
