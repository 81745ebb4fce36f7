// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Values of the vertices of a mesh stay with the places of the vertices while the mesh is welded, mended or
// divided.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// The way along a triangle that values of its vertices, linear over it, grow fastest, by so much per mm; 0
/// without an area.
[[nodiscard]] Vec3 slopeOver(const TriangleMesh& mesh, const Triangle& t, std::span<const double> values);

/// For each vertex of `to` the value of the vertex of `from` in the same place; of a new one, as where a
/// repair divided a triangle or filled a hole, that of the closest point of `from`, linear over its triangle.
/// Throws kInvalidArgument, with `what` the values are, where vertices in one place have different ones.
[[nodiscard]] std::vector<double> valuesAt(const TriangleMesh& from, std::span<const double> values,
                                           const TriangleMesh& to, std::string_view what);

}  // namespace thicken::mesh
