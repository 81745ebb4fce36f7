// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Normals of faces and angle-weighted pseudonormals of vertices (Bærentzen & Aanæs 2005).
#pragma once

#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// Unit normal of every triangle.
[[nodiscard]] std::vector<Vec3> faceNormals(std::span<const Vec3> positions,
                                            std::span<const Triangle> triangles, int threads = 1);

/// Unit angle-weighted normal of every vertex; zero where no triangle uses it or where the
/// normals cancel.
[[nodiscard]] std::vector<Vec3> vertexNormals(std::span<const Vec3> positions,
                                              std::span<const Triangle> triangles,
                                              std::span<const Vec3> faceNormal, int threads = 1);

/// Angle of triangle `t` at corner `k`, radians.
[[nodiscard]] double cornerAngle(std::span<const Vec3> positions, const Triangle& t, int k);

}  // namespace thicken::mesh
