// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The strip between the carrier's rim and the contour, what lies beside it, and of which region it is: wall
// where the end of a wall was drawn back, so that the contour goes on as wall, else shell.
#pragma once

#include "mesh/half_edges.h"
#include "reconstruct/assembly.h"

namespace thicken {

/// The edges of the triangles that share two vertices or more with the strip, its own among them.
[[nodiscard]] HalfEdges edgesAtStrip(const Assembly& assembly, int threads);

/// A triangle of the strip is what the contour across its edge is; one that has no edge with the contour is
/// wall where the strip beside it is.
void labelStrip(Assembly& assembly, int threads);

}  // namespace thicken
