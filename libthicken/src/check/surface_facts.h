// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Counts and sizes of a mesh.
#pragma once

#include "check/findings.h"
#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken::checking {

/// Whether every coordinate of a vertex is a number that a float can hold.
[[nodiscard]] bool isFinite(const Vec3& p);

/// Sizes are left at 0 unless `finite`.
[[nodiscard]] SurfaceFacts factsOf(const TriangleMesh& mesh, const BadJoints& joints, bool finite,
                                   int threads);

/// Adds area, diagonal and mean edge; `mesh` has triangles.
void addSizes(const TriangleMesh& mesh, SurfaceFacts& facts);

}  // namespace thicken::checking
