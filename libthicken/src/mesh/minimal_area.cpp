// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/minimal_area.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace thicken::mesh {

std::vector<Triangle> minimalAreaTriangulation(std::span<const Vec3> positions,
                                               std::span<const VertexId> loop, const EdgeSet& forbidden,
                                               const std::function<bool(const Triangle&)>& allowed) {
  const std::size_t n = loop.size();
  if (n < 3 || n > kLongestLoop) return {};
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<double> area(n * n, kInfinite);  // of the best triangulation of loop[i…j]
  std::vector<std::uint32_t> apex(n * n, 0);
  const auto at = [n](std::size_t i, std::size_t j) { return i * n + j; };
  const auto isForbidden = [&](std::size_t i, std::size_t j) {
    if (j == i + 1 || (i == 0 && j == n - 1)) return false;  // an edge of the loop itself
    return loop[i] == loop[j] || forbidden.contains(edgeKey(loop[i], loop[j]));
  };
  const auto areaOf = [&](std::size_t i, std::size_t k, std::size_t j) {
    const Vec3 &a = positions[loop[i]], &b = positions[loop[k]], &c = positions[loop[j]];
    return (b - a).cross(c - a).norm();
  };
  for (std::size_t i = 0; i + 1 < n; ++i) area[at(i, i + 1)] = 0;
  for (std::size_t span = 2; span < n; ++span)
    for (std::size_t i = 0; i + span < n; ++i) {
      const std::size_t j = i + span;
      if (isForbidden(i, j)) continue;
      for (std::size_t k = i + 1; k < j; ++k) {
        const double sum = area[at(i, k)] + area[at(k, j)];
        if (sum >= area[at(i, j)]) continue;
        const double whole = sum + areaOf(i, k, j);
        if (whole >= area[at(i, j)] || !allowed({loop[i], loop[k], loop[j]})) continue;
        area[at(i, j)] = whole;
        apex[at(i, j)] = static_cast<std::uint32_t>(k);
      }
    }
  if (!(area[at(0, n - 1)] < kInfinite)) return {};
  std::vector<Triangle> triangles;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j == i + 1) continue;
    const std::size_t k = apex[at(i, j)];
    triangles.push_back({loop[i], loop[k], loop[j]});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

}  // namespace thicken::mesh
