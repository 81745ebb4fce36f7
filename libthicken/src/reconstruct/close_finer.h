// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What an attempt could not make is made in finer cells, in windows around it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/bounds.h"
#include "reconstruct/attempt.h"
#include "reconstruct/contour_task.h"

namespace thicken {

/// What an attempt could not make, once it was tried in finer cells.
struct Closing {
  std::optional<Reconstruction> made;  ///< where all of it could be made
  std::vector<TriangleId> stuck;       ///< of the assembly: triangles that meet where it could not
};

/// What `attempt` at `task` could not make, in finer cells: the rest of it is the carrier for that. Zones
/// where even the finest ones that are tried do not do are added to `givenUp`, and are not tried again.
/// Throws kCancelled.
[[nodiscard]] Closing closedFiner(const Job& job, const SweepResult& swept, const ContourTask& task,
                                  const Attempt& attempt, std::span<const TriangleId> meeting,
                                  std::vector<Bounds>& givenUp, Complete& complete);

}  // namespace thicken
