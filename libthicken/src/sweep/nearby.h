// SPDX-License-Identifier: LGPL-2.1-or-later
//
// For each part of a sweep a triangle of S nearby. Queries begin there. It changes how long they take, never
// what they answer.
#pragma once

#include <span>
#include <vector>

#include "sweep/swept_mesh.h"

namespace thicken::sweep {

/// A triangle of S at the base of every copy.
[[nodiscard]] std::vector<TriangleId> trianglesAtCopies(const SweptMesh& mesh);

/// For each of the shell triangles `shell` the one of S that it is a copy of, or else one at its first
/// corner.
[[nodiscard]] std::vector<TriangleId> trianglesAbove(std::span<const TriangleId> shell, const SweptMesh& mesh,
                                                     int threads);

}  // namespace thicken::sweep
