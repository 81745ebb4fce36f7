// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Axis-parallel bounding boxes in doubles.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "thicken/mesh.h"

namespace thicken::mesh {

struct Bounds {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Bounds& b) {
    low = low.cwiseMin(b.low);
    high = high.cwiseMax(b.high);
  }
  [[nodiscard]] bool contains(const Vec3& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  [[nodiscard]] bool overlaps(const Bounds& b) const {
    return (low.array() <= b.high.array()).all() && (b.low.array() <= high.array()).all();
  }
};

/// Of the vertices that triangles use.
[[nodiscard]] inline Bounds boundsOf(const TriangleMesh& mesh) {
  Bounds b;
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t) b.add(mesh.positions[v]);
  return b;
}

[[nodiscard]] inline Bounds boundsOf(const TriangleMesh& mesh, const Triangle& triangle) {
  Bounds b;
  for (const VertexId v : triangle) b.add(mesh.positions[v]);
  return b;
}

[[nodiscard]] inline bool overlapsAny(std::span<const Bounds> boxes, const Bounds& b) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Bounds& box) { return box.overlaps(b); });
}

}  // namespace thicken::mesh
