// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The shortest way between two vertices along edges.
#pragma once

#include "trim/plane_cut.h"

namespace thicken::trimming {

/// The vertex nearest to the middle of the shortest way from `from` to `to` along edges. The way passes no
/// vertex of a path or of the rim. kNone if there is no such way, or only one of a single edge, or if it is
/// longer than `longest`, mm.
[[nodiscard]] VertexId middleOfEdgeWay(const DividedSurface& surface, const PathMarks& marks, VertexId from,
                                       VertexId to, double longest);

}  // namespace thicken::trimming
