// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/normals.h"

#include <Eigen/Geometry>
#include <cmath>

namespace thicken {

std::vector<Vec3> faceNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  std::vector<Vec3> n(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    // scaled first: the cross product of tiny edges would underflow
    const Vec3 u = (positions[b] - positions[a]).stableNormalized();
    const Vec3 v = (positions[c] - positions[a]).stableNormalized();
    n[t] = u.cross(v).stableNormalized();
  }
  return n;
}

double cornerAngle(std::span<const Vec3> positions, const Triangle& t, int k) {
  const Vec3& a = positions[t[k]];
  const Vec3 u = positions[t[(k + 1) % 3]] - a;
  const Vec3 v = positions[t[(k + 2) % 3]] - a;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::vector<Vec3> vertexNormals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                std::span<const Vec3> faceNormal) {
  std::vector<Vec3> n(positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) n[triangles[t][k]] += cornerAngle(positions, triangles[t], k) * faceNormal[t];
  for (Vec3& x : n) x.stableNormalize();
  return n;
}

}  // namespace thicken
