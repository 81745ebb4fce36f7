// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What an attempt could not make is cut out of it; all else, whose triangles are clear of each other, is the
// carrier for another contour in finer cells.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reconstruct/attempt.h"
#include "reconstruct/contour_task.h"
#include "reconstruct/window.h"

namespace thicken {

/// Flags per triangle of an assembly that was made at `task`: whether another contour may replace it.
[[nodiscard]] std::vector<std::uint8_t> openableOf(const Assembly& assembly, const ContourTask& task);

/// The holes around the triangles that `meeting` lists after `attempt` at `task`, which was made with
/// `swept`. Nothing where triangles of its carrier meet each other wherever their walls end.
[[nodiscard]] std::optional<Holes> holesOf(const Job& job, const SweepResult& swept, const Attempt& attempt,
                                           const ContourTask& task, std::span<const TriangleId> meeting);

}  // namespace thicken
