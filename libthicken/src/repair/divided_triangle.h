// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A triangle whose edges are divided at further corners, cut into triangles that face the same way.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::repairing {

/// Which way a triangle faces: the axis that its normal is nearest to, and the sign along it. Exact.
struct Facing {
  int axis = 0;
  int sign = 0;  ///< 0: the triangle has no area
};
[[nodiscard]] Facing facingOf(std::span<const Vec3> positions, const Triangle& corners);

/// Twice the area of a triangle for the square of its longest edge: 0 for slivers.
[[nodiscard]] double shapeOf(std::span<const Vec3> positions, const Triangle& corners);

/// The parts of the triangle of these `corners`, whose edge k, from corner k to k + 1, is divided at
/// `divisions[k]` in this order. Empty where they would not all face as `facing` says, or would have a
/// corner twice. Seen along the axis the parts lie side by side. Exact.
[[nodiscard]] std::vector<Triangle> partsOf(std::span<const Vec3> positions, const Triangle& corners,
                                            const std::array<std::span<const VertexId>, 3>& divisions,
                                            Facing facing);

}  // namespace thicken::repairing
