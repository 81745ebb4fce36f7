// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The topology of the contour: one vertex for every component of the surface in a cell, a quad for
// every crossing, and strips that join the quads' border to the carrier's rim. It is a manifold with
// the carrier's rim as its border for any labels: in every face of the grid the signed crossings and
// the rim's passages cancel, and are matched there once for both cells beside the face.
#pragma once

#include <vector>

#include "contour/crossings.h"
#include "contour/face_list.h"
#include "contour/rim_walk.h"

namespace thicken::contour {

struct DualSurface {
  std::size_t vertexCount = 0;  ///< of cells' components, then of doubled dual edges
  std::vector<Vec3> start;      ///< first position: mean of the crossings (§4.2)
  /// Corners of the face of each crossing, counter-clockwise seen from outside; 4 to 8 of them.
  FaceList faces;
  std::vector<std::uint8_t> shared;  ///< per crossing: its grid edge has others as well
  /// Whether the face of a crossing is two triangles; others are fans around a vertex in their middle.
  [[nodiscard]] bool isQuad(std::uint32_t crossing) const {
    return faces[crossing].size() == 4 && !shared[crossing];
  }
  /// For every loop of the rim, in its order: the vertex of each visit, and what lies on the dual
  /// edge to the next visit's (kNone: nothing).
  struct Stop {
    VertexId vertex;
    VertexId onExit;
  };
  std::vector<std::vector<Stop>> stops;
  /// Crossings around each vertex, as flat arrays.
  std::vector<std::uint32_t> crossingOffset;
  std::vector<std::uint32_t> crossingsOf;
};

[[nodiscard]] DualSurface dualSurface(const std::vector<Crossing>& crossings, const std::vector<RimWay>& ways,
                                      std::span<const Vec3> positions, int threads);

}  // namespace thicken::contour
