// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sweep as a mesh: S, one copy of each vertex at its own depth, the copied triangles (shell)
// and two triangles below each rim edge (wall). On both sides there are two copies of every
// vertex, and S itself only keeps the two apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "job/job.h"
#include "mesh/topology.h"
#include "sweep/direction.h"
#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken::sweep {

/// A copy of a vertex of S: at depth h it stands at base + h·offset, rounded to float.
struct Copy {
  VertexId base = 0;
  Vec3 offset = Vec3::Zero();  ///< mm, the whole way
  double length = 0;           ///< |offset|
  double safety = 0;           ///< of its direction (SweepDirection)
  double depth = 1;            ///< h ∈ (0, 1]
  bool exact = false;          ///< in the planes of the triangles around it: not to be polished
  bool dropped = false;        ///< no triangle uses it any more
};

struct SweptMesh {
  std::size_t surfaceVertices = 0;   ///< the copies' vertices follow S's
  std::size_t surfaceTriangles = 0;  ///< S's triangles come first
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  std::vector<Region> region;       ///< per triangle
  std::vector<std::uint8_t> fixed;  ///< per triangle: 1 for S
  std::vector<TriangleId>
      above;                 ///< per triangle: of the shell, the one of S that it is parallel to; else kNone
  std::vector<Copy> copies;  ///< copy i is vertex surfaceVertices + i
  std::size_t shells = 1;    ///< 2 on both sides
  job::Thickness thickness{0};

  [[nodiscard]] bool isCopy(VertexId v) const { return v >= surfaceVertices; }
  [[nodiscard]] Copy& copyOf(VertexId v) { return copies[v - surfaceVertices]; }
  [[nodiscard]] const Copy& copyOf(VertexId v) const { return copies[v - surfaceVertices]; }
  [[nodiscard]] VertexId vertexOf(std::size_t copy) const {
    return static_cast<VertexId>(surfaceVertices + copy);
  }
  /// Adds a triangle; `parallelTo`: above's.
  void add(const Triangle& t, Region where, TriangleId parallelTo) {
    triangles.push_back(t);
    region.push_back(where);
    fixed.push_back(0);
    above.push_back(parallelTo);
  }
  /// Removes the triangles that `removed` marks.
  void remove(std::span<const std::uint8_t> removed);
  /// Moves a copy's vertex to where its depth puts it.
  void place(std::size_t copy);
};

/// The sweep of S to depth 1 on the negative side, or on both; `direction` for each of its shells.
[[nodiscard]] SweptMesh sweepMesh(const job::Job& job, std::span<const std::vector<SweepDirection>> direction,
                                  const mesh::Rim& rim);

}  // namespace thicken::sweep
