// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/normals.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "parallel/parallel_for.h"

namespace thicken::mesh {

using parallel::parallelFor;

namespace {

constexpr std::size_t kGrain = 2048;  // triangles or vertices that a thread takes at a time

}  // namespace

std::vector<Vec3> faceNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                              int threads) {
  std::vector<Vec3> n(triangles.size());
  parallelFor(n.size(), threads, RunContext(), kGrain, [&](std::size_t t) {
    const auto [a, b, c] = triangles[t];
    // scaled first: the cross product of tiny edges would underflow
    const Vec3 u = (positions[b] - positions[a]).stableNormalized();
    const Vec3 v = (positions[c] - positions[a]).stableNormalized();
    n[t] = u.cross(v).stableNormalized();
  });
  return n;
}

double cornerAngle(std::span<const Vec3> positions, const Triangle& t, int k) {
  const Vec3& a = positions[t[k]];
  const Vec3 u = positions[t[(k + 1) % 3]] - a;
  const Vec3 v = positions[t[(k + 2) % 3]] - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::vector<Vec3> vertexNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                std::span<const Vec3> faceNormal, int threads) {
  std::vector<std::array<double, 3>> angle(triangles.size());
  parallelFor(triangles.size(), threads, RunContext(), kGrain, [&](std::size_t t) {
    for (int k = 0; k < 3; ++k) angle[t][k] = cornerAngle(positions, triangles[t], k);
  });
  std::vector<Vec3> n(positions.size(), Vec3::Zero());
  // In one order, so that sums do not depend on the threads.
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) n[triangles[t][k]] += angle[t][k] * faceNormal[t];
  parallelFor(n.size(), threads, RunContext(), kGrain, [&](std::size_t v) { n[v].stableNormalize(); });
  return n;
}

}  // namespace thicken::mesh
