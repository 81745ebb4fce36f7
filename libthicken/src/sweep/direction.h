// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The direction that each vertex of S is swept along. Even thickness where it is safe: m with
// n·m = 1 for the normals n around the vertex, in the least-squares sense, and m in the planes
// perpendicular to the rim that bound Definition 2's solid. Elsewhere the direction that maximises
// the smallest n·m.
#pragma once

#include <span>
#include <vector>

#include "job/job.h"
#include "mesh/topology.h"

namespace thicken::sweep {

struct SweepDirection {
  Vec3 m = Vec3::Zero();  ///< the copy of v at full depth is v − r·m
  double safety = 0;      ///< smallest n·m/|m| over the triangles around; ≤ 0: no copy of v can be valid
};

/// Least safety of a copy that a float can keep behind all its triangles.
inline constexpr double kLeastSafety = 0.05;

/// The plane of a copied triangle at full depth, seen from a vertex v of the triangle: its point v − r·m has
/// normal·m = way. It leans as the thickness grows.
struct OffsetPlane {
  Vec3 normal = Vec3::Zero();  ///< unit
  double way = 1;              ///< in r of the vertex
};

/// Of all triangles of S; `sign` −1: behind S, 1: before it, where −m takes the place of m.
[[nodiscard]] std::vector<OffsetPlane> offsetPlanes(const job::Job& job, std::span<const Vec3> faceNormal,
                                                    double sign);

/// One direction for every vertex of S that a triangle uses; `plane`: of the triangles.
[[nodiscard]] std::vector<SweepDirection> sweepDirections(const job::Job& job,
                                                          std::span<const Vec3> faceNormal,
                                                          std::span<const OffsetPlane> plane,
                                                          const mesh::VertexTriangles& around,
                                                          const mesh::Rim& rim);

/// Point of least norm in the convex hull of `points`; zero when the hull holds the origin.
[[nodiscard]] Vec3 minNormPoint(std::span<const Vec3> points);

}  // namespace thicken::sweep
