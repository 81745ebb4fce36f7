// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sweep of varying depth: S, its copy at v − h(v)·r·m(v), and walls below the rim. Always a
// valid solid with S kept; as thick as asked where the offset is not cut off.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "job/job.h"
#include "thicken/result.h"

namespace thicken {

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

/// Whether copies are moved to their exact distance, which the sweep itself does not need.
enum class Polish : std::uint8_t { kNo, kYes };

/// Sweeps S to its negative side or to both. Throws kNoSolid with the place where not even the least depth is
/// clear.
[[nodiscard]] SweepResult sweep(const Job& job, Polish polishing = Polish::kYes);

/// As sweep(). Nothing where the shell of more than the share `mostShort` of S's area would be short of the
/// thickness, by an estimate that is made before anything is drawn back.
[[nodiscard]] std::optional<SweepResult> sweepUnlessShort(const Job& job, double mostShort);

}  // namespace thicken
