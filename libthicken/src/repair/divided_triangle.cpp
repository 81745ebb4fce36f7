// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/divided_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "exact/predicates.h"

namespace thicken::repairing {
namespace {

bool hasCornerTwice(const Triangle& corners, const std::array<std::span<const VertexId>, 3>& divisions) {
  std::vector<VertexId> all(corners.begin(), corners.end());
  for (const auto& edge : divisions) all.insert(all.end(), edge.begin(), edge.end());
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end()) != all.end();
}

// Fans over the divisions of one edge from `apex`.
void addFan(std::vector<Triangle>& parts, VertexId from, std::span<const VertexId> between, VertexId to,
            VertexId apex) {
  for (const VertexId v : between) {
    parts.push_back({from, v, apex});
    from = v;
  }
  parts.push_back({from, to, apex});
}

// The divisions of edge `first` are joined to the corner opposite to it. The other two edges belong to the
// first and the last of these parts.
std::vector<Triangle> fansFrom(int first, const Triangle& corners,
                               const std::array<std::span<const VertexId>, 3>& divisions) {
  const VertexId a = corners[first], b = corners[(first + 1) % 3], c = corners[(first + 2) % 3];
  const auto &ab = divisions[first], &bc = divisions[(first + 1) % 3], &ca = divisions[(first + 2) % 3];
  std::vector<Triangle> parts;
  if (ab.empty()) {
    if (bc.empty() || ca.empty()) {
      addFan(parts, bc.empty() ? c : b, bc.empty() ? ca : bc, bc.empty() ? a : c, bc.empty() ? b : a);
      return parts;
    }
    addFan(parts, b, bc, c, a);
    const Triangle last = parts.back();  // it has the edge from c to a
    parts.pop_back();
    addFan(parts, c, ca, a, last[0]);
    return parts;
  }
  addFan(parts, b, bc, c, ab.back());
  for (std::size_t i = 1; i < ab.size(); ++i) parts.push_back({ab[i - 1], ab[i], c});
  addFan(parts, c, ca, a, ab.front());
  return parts;
}

}  // namespace

double shapeOf(std::span<const Vec3> p, const Triangle& t) {
  const Vec3 u = p[t[1]] - p[t[0]], v = p[t[2]] - p[t[0]], w = v - u;
  const double longest = std::max({u.squaredNorm(), v.squaredNorm(), w.squaredNorm()});
  return longest > 0 ? u.cross(v).norm() / longest : 0;
}

Facing facingOf(std::span<const Vec3> positions, const Triangle& corners) {
  const Vec3 &p = positions[corners[0]], &q = positions[corners[1]], &r = positions[corners[2]];
  Facing facing;
  (q - p).cross(r - p).cwiseAbs().maxCoeff(&facing.axis);
  facing.sign = exact::orientation2(p, q, r, facing.axis);
  return facing;
}

std::vector<Triangle> partsOf(std::span<const Vec3> positions, const Triangle& corners,
                              const std::array<std::span<const VertexId>, 3>& divisions, Facing facing) {
  if (facing.sign == 0 || hasCornerTwice(corners, divisions)) return {};
  std::vector<Triangle> best;
  double bestShape = -1;
  for (int first = 0; first < 3; ++first) {
    std::vector<Triangle> parts = fansFrom(first, corners, divisions);
    double least = 2;
    for (const Triangle& t : parts) {
      const int sign = exact::orientation2(positions[t[0]], positions[t[1]], positions[t[2]], facing.axis);
      least = std::min(least, sign == facing.sign ? shapeOf(positions, t) : -1.0);
    }
    if (least < 0 || least <= bestShape) continue;
    bestShape = least;
    best = std::move(parts);
  }
  return best;
}

}  // namespace thicken::repairing
