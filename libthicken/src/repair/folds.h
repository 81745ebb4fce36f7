// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a sweep found no room below, although the surface is valid: folds so sharp, or sheets so close,
// that the coordinates cannot hold a wall between them.
#pragma once

#include <span>

#include "thicken/repair.h"

namespace thicken::repairing {

/// Removes of the triangles around each of `vertices` the one that is turned farthest from the others,
/// from the attempt kWholeFans on all of them; and what touches in a point only afterwards. Goes on
/// with the account of `before`, a repair of the same surface. Throws kNoSolid when nothing remains.
[[nodiscard]] RepairResult openFolds(const RepairResult& before, std::span<const VertexId> vertices,
                                     int attempt, const RunContext& context, int threads);

inline constexpr int kWholeFans = 4;
inline constexpr int kMostAttempts = 12;

}  // namespace thicken::repairing
