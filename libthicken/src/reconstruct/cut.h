// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where a window of a boundary ends.
#pragma once

#include <array>
#include <vector>

#include "mesh/bounds.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

struct Cut {
  using Edge = std::array<VertexId, 2>;
  std::vector<Edge> edges;  ///< ascending; of the window's triangles, in their direction: the boundary goes
                            ///< on beyond them
  mesh::Bounds zone;        ///< the contour that is made in the window must not leave it
};

/// Thrown where a contour would leave the zone of its window; a larger one may do.
class LeavesWindow : public Error {
 public:
  LeavesWindow() : Error(ErrorCode::kNoSolid, "the contour leaves its window") {}
};

}  // namespace thicken::reconstruct
