// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Straight holes through the wall of a solid, such as those through which resin drains out of a hollow
// part. Like every result of this library, a solid with a hole has passed the exact audit.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/run_context.h"

namespace thicken {

struct DrainHole {
  Vec3 place = Vec3::Zero();  ///< mm; the hole goes through the material that begins nearest to it
  Vec3 axis = Vec3::Zero();   ///< the way into the material there; any length above 0
  double diameter = 0;        ///< mm, of the thickest round pin that passes
  int sides = 24;             ///< of the cross-section, a regular polygon; 3 to 360
};

struct DrilledSolid {
  TriangleMesh mesh;  ///< first the triangles that the hole left untouched, bit for bit and in their order
  std::size_t untouched = 0;  ///< how many these are
  Vec3 entry = Vec3::Zero();  ///< mm, where the axis enters the material
  Vec3 exit = Vec3::Zero();   ///< mm, where it leaves it
  Vec3 axis = Vec3::Zero();   ///< unit
  std::vector<Vec3> outline;  ///< mm, the corners of the cross-section in the plane through `entry`
  std::size_t candidate = 0;  ///< which of the holes that were offered it is
  double walledFrom = 0;      ///< mm along the axis from `entry`: from here …
  double walledTo = 0;        ///< … to here the hole has its wall all around
};

/// Drills the first of `candidates` that can be made; the others are left out. Corners of equal
/// coordinates are made one vertex first.
///
/// The part of the boundary that the hole goes through has to be visible along the axis: it may not
/// fold back within the hole. The cross-section may be turned, and shifted by up to 2 % of the
/// diameter, to keep clear of edges and vertices.
///
/// Throws Error: kInvalidArgument for arguments out of range, kNoSolid with the reason of the first
/// candidate if none can be made or if the solid is not valid in the first place, kCancelled.
/// Cost: O(n log n), and an audit of each candidate.
[[nodiscard]] DrilledSolid drill(const TriangleMesh& solid, std::span<const DrainHole> candidates,
                                 RunContext context = {}, int threads = 0);

/// The same for one hole.
[[nodiscard]] inline DrilledSolid drill(const TriangleMesh& solid, const DrainHole& hole,
                                        RunContext context = {}, int threads = 0) {
  return drill(solid, std::span(&hole, 1), std::move(context), threads);
}

}  // namespace thicken
