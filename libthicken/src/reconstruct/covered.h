// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which triangles of S the carrier already has shell for.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sweep/sweep.h"

namespace thicken::reconstruct {

/// Per triangle of `surface`: 1 if its copy is among the triangles of `swept` that `keep` marks. A triangle
/// without a copy has 1 if all shell around it is kept.
[[nodiscard]] std::vector<std::uint8_t> coveredTriangles(const TriangleMesh& surface,
                                                         const sweep::SweepResult& swept,
                                                         std::span<const std::uint8_t> keep);

}  // namespace thicken::reconstruct
