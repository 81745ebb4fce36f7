// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The picture of what a run made.
#pragma once

#include <span>
#include <vector>

#include "thicken/picture.h"
#include "thicken/result.h"

namespace thicken::program {

/// Solids in the colours of their regions, from above; of at least twice the height also from the other side
/// and below.
[[nodiscard]] Picture drawSolids(std::span<const TriangleMesh> solids,
                                 std::span<const std::vector<Region>> regions, int width, int height);

}  // namespace thicken::program
