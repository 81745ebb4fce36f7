// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 8: removed triangles that meet nothing any more come back.
#pragma once

#include <span>

#include "mesh/topology.h"
#include "repair/cover.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// Puts triangles back, the largest first, until any further one would make the surface invalid.
/// `candidate[t] != 0` marks those that may come back; `graph` has to know all triangles that each
/// of them meets. Requires a surface without defects, which it stays.
void putBack(Workpiece& piece, const mesh::VertexTriangles& around, const MeetingGraph& graph,
             std::span<const std::uint8_t> candidate);

}  // namespace thicken::repairing
