// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The walls of the sweep without its shell: what a contour needs that makes the shell itself.
#pragma once

#include <optional>

#include "sweep/sweep.h"

namespace thicken::sweep {

/// The sweep to the negative side with only S and the walls proved: the shell is there, at full depth, but
/// nothing is known of it (`shellProved` is false; `distance` is 0 and `depth` the thickness where no wall
/// hangs). nullopt where copies on the rim have no direction, or walls no clear depth, of their own; sweep()
/// can do more about them.
[[nodiscard]] std::optional<SweepResult> sweepWalls(const job::Job& job);

}  // namespace thicken::sweep
