// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Attempts until nothing meets: walls that are in the way are drawn back, and where that does not help the
// sweep's own shell is kept.
#pragma once

#include <optional>

#include "reconstruct/contour_task.h"

namespace thicken::reconstruct {

/// The solid of a carrier that is `task.keep` of `swept`; nullopt where it would need more of the sweep's
/// shell and must not have it. Throws kNoSolid where not even the whole sweep is clear of itself, kCancelled.
[[nodiscard]] std::optional<Reconstruction> complete(const job::Job& job, const sweep::SweepResult& swept,
                                                     ContourTask task);

}  // namespace thicken::reconstruct
