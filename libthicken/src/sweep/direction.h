// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The direction that each vertex of S is swept along. Even thickness where it is safe: m with
// n·m = 1 for the normals n around the vertex, in the least-squares sense, and m in the planes
// perpendicular to the rim that bound Definition 2's solid. Elsewhere the direction that maximises
// the smallest n·m.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"
#include "thicken/mesh.h"

namespace thicken {

struct SweepDirection {
  Vec3 m = Vec3::Zero();  ///< the copy of v at full depth is v − r·m
  double safety = 0;      ///< smallest n·m/|m| over the triangles around; ≤ 0: no copy of v can be valid
};

/// Least safety of a copy that a float can keep behind all its triangles.
inline constexpr double kLeastSafety = 0.05;

/// One direction for every vertex of `surface` that a triangle uses; `thickness` in mm.
[[nodiscard]] std::vector<SweepDirection> sweepDirections(const TriangleMesh& surface,
                                                          std::span<const Vec3> faceNormal,
                                                          const VertexTriangles& around, const Rim& rim,
                                                          double thickness, int threads);

/// Point of least norm in the convex hull of `points`; zero when the hull holds the origin.
[[nodiscard]] Vec3 minNormPoint(std::span<const Vec3> points);

}  // namespace thicken
