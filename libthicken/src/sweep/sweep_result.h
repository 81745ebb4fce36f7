// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The boundary that a settled sweep leaves.
#pragma once

#include <vector>

#include "job/job.h"
#include "sweep/swept_mesh.h"
#include "thicken/result.h"

namespace thicken::sweep {

struct SweepResult {
  TriangleMesh mesh;                ///< S's vertices and triangles first (on kBoth: no triangles of S)
  std::vector<Region> region;       ///< per triangle
  std::vector<VertexId> base;       ///< per vertex: the vertex of S that it is a copy of; S's own: itself;
                                    ///< kNone: none, it stays where it is
  std::vector<double> distance;     ///< mm per vertex: to S; 0 for S's own
  std::vector<TriangleId> nearest;  ///< per copy of a vertex: a triangle of S at that distance; else any
  std::vector<double> depth;        ///< mm per vertex of S: distance from its copy to S
  std::vector<TriangleId> order;    ///< of the leaves of a BoxTree over the mesh; may be empty
  std::vector<Vec3> up;             ///< per vertex: from the end of a wall that stays to where it hangs on
                                    ///< S; may be empty
  std::size_t droppedCopies = 0;
  bool shellProved = true;  ///< whether all triangles are clear of each other, or only S and the walls
  std::size_t rounds = 0;
};

/// Without dropped copies and what only they used. `mesh` and `job`: of one sweep.
[[nodiscard]] SweepResult resultOf(const SweptMesh& mesh, const job::Job& job);

}  // namespace thicken::sweep
