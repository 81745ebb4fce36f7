// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The strip between the carrier's rim and the contour, and its regions. A strip is wall where the end of a
// wall was drawn back and the contour goes on as wall; elsewhere it is shell.
#pragma once

#include "mesh/half_edges.h"
#include "reconstruct/assembly.h"

namespace thicken::reconstruct {

/// The edges of the triangles that share two vertices or more with the strip, its own among them.
[[nodiscard]] mesh::HalfEdges edgesAtStrip(const Assembly& assembly, int threads);

/// Gives each triangle of the strip the region of the contour's triangle across its edge. One without an edge
/// at the contour is wall if the strip beside it is.
void labelStrip(Assembly& assembly, int threads);

}  // namespace thicken::reconstruct
