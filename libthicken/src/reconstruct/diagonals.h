// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which diagonal divides each quad of the contour: of those that do not fold it, the one that comes closer to
// the tangent plane of the quad's crossing. A chord of a round offset is below that plane by its length's
// square.
#pragma once

#include "reconstruct/assembly.h"
#include "thicken/run_context.h"

namespace thicken::reconstruct {

/// Turns pairs of triangles so that they are good where the contour's vertices stand at `target`, which is in
/// the assembly's order.
void chooseDiagonals(Assembly& assembly, const contour::DualSurface& dual,
                     std::span<const contour::Crossing> crossings, std::span<const Vec3> target,
                     const RunContext& context, int threads);

}  // namespace thicken::reconstruct
