// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The boundary of a solid that a contour is part of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken::reconstruct {

/// The end of a wall.
struct WallEnd {
  VertexId vertex = 0;
  Vec3 up = Vec3::Zero();  ///< mm, from there to where the wall hangs on S, about
};

struct Reconstruction {
  TriangleMesh mesh;               ///< S's vertices and triangles first
  std::vector<Region> region;      ///< per triangle
  std::vector<double> depth;       ///< mm per vertex of S
  std::size_t rounds = 0;          ///< of local refinement
  double cell = 0;                 ///< width, mm
  double finest = 0;               ///< width of the finest ones, where some had to be finer, mm
  std::size_t cells = 0;           ///< that the contour was followed through, in every attempt
  std::size_t nodes = 0;           ///< that the field is known at
  std::size_t predicted = 0;       ///< bytes, with what is held for the surface
  double shellArea = 0;            ///< mm², that was to be contoured
  double leftArea = 0;             ///< mm² of it that was left to the sweep
  std::vector<std::uint8_t> left;  ///< per triangle: whether it is of the sweep's shell for that; empty: none
  std::vector<VertexId> base;      ///< per vertex, of those triangles: what it is a copy of; else any
  std::vector<WallEnd> ends;       ///< of walls
  std::vector<std::uint8_t> openable;  ///< per triangle: may be made again, neither S nor the sweep's walls
  std::vector<VertexId> origin;  ///< of a window, per vertex: of the boundary that was carried, or kNone
};

}  // namespace thicken::reconstruct
