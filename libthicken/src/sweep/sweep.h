// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sweep of varying depth: S, its copy at v − h(v)·r·m(v), and walls below the rim. Always a
// valid solid with S kept; as thick as asked where the offset is not cut off.
#pragma once

#include <cstdint>
#include <optional>

#include "sweep/sweep_result.h"

namespace thicken::sweep {

/// Whether copies are moved to their exact distance, which the sweep itself does not need.
enum class Polish : std::uint8_t { kNo, kYes };

/// Sweeps S to its negative side or to both. Throws kNoSolid with the place where not even the least depth is
/// clear.
[[nodiscard]] SweepResult sweep(const job::Job& job, Polish polishing = Polish::kYes);

/// As sweep(). Nothing where the shell of more than the share `mostShort` of S's area would be short of the
/// thickness, by an estimate that is made before anything is drawn back.
[[nodiscard]] std::optional<SweepResult> sweepUnlessShort(const job::Job& job, double mostShort);

}  // namespace thicken::sweep
