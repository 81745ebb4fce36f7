// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::reconstruct {

/// Takes `triangles` and so many rings of triangles around them out of `keep`, as far as they are `openable`.
/// A seam right at the ragged border of a failed place would fail again.
void cutAround(const TriangleMesh& mesh, std::span<const TriangleId> triangles,
               std::span<const std::uint8_t> openable, int rings, std::vector<std::uint8_t>& keep);

}  // namespace thicken::reconstruct
