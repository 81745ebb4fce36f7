// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Cuts holes around the triangles of an attempt that meet others. The rest is clear of itself. It is the
// carrier for another contour in finer cells.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reconstruct/attempt.h"
#include "reconstruct/contour_task.h"
#include "reconstruct/window.h"

namespace thicken::reconstruct {

/// Flags per triangle of an assembly that was made at `task`: whether another contour may replace it.
[[nodiscard]] std::vector<std::uint8_t> openableOf(const Assembly& assembly, const ContourTask& task);

/// The holes around the triangles that `meeting` lists after `attempt` at `task` of `swept`. Nothing if
/// triangles of the carrier meet each other however far their walls are drawn back.
[[nodiscard]] std::optional<Holes> holesOf(const job::Job& job, const sweep::SweepResult& swept,
                                           const Attempt& attempt, const ContourTask& task,
                                           std::span<const TriangleId> meeting);

}  // namespace thicken::reconstruct
