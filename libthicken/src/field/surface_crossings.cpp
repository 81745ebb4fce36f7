// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/surface_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "exact/predicates.h"

namespace thicken::field {

namespace {

bool before(const SurfaceCrossing& x, const SurfaceCrossing& y) {
  return x.at != y.at ? x.at < y.at : x.jump < y.jump;
}

// Crossings of one grid edge with triangles.
class EdgeProbe {
 public:
  EdgeProbe(const UniformGrid& grid, std::uint64_t edge) : edge_(edge), axis_(static_cast<int>(edge & 3)) {
    GridIndex end = UniformGrid::indexOf(edge >> 2);
    low = grid.node(end);
    ++end[axis_];
    high = grid.node(end);
  }

  [[nodiscard]] std::optional<SurfaceCrossing> crossing(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const int side = exact::orientation2(a, b, c, axis_);
    if (side == 0) return {};  // seen edge-on: a line along the axis that met it would touch an edge
    if (!within(a, b, c, side)) return {};
    if (beyond(a, b, c, low, side) || !beyond(a, b, c, high, side)) return {};
    const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    const Vec3 normal = (b - a).cross(c - a);
    const double x = a[axis_] - (normal[u] * (low[u] - a[u]) + normal[v] * (low[v] - a[v])) / normal[axis_];
    const double at = x >= low[axis_] && x <= high[axis_] ? x : x < low[axis_] ? low[axis_] : high[axis_];
    return SurfaceCrossing{edge_, at, -side};
  }

  Vec3 low, high;  ///< its ends

 private:
  // Whether the edge's line goes through the triangle.
  [[nodiscard]] bool within(const Vec3& a, const Vec3& b, const Vec3& c, int side) const {
    const int s0 = exact::orientation2(a, b, low, axis_) * side;
    if (s0 < 0) return false;
    const int s1 = exact::orientation2(b, c, low, axis_) * side;
    if (s1 < 0) return false;
    const int s2 = exact::orientation2(c, a, low, axis_) * side;
    if (s2 < 0) return false;
    if (s0 == 0 || s1 == 0 || s2 == 0) throw GridTouches{};
    return true;
  }

  // Whether a node lies beyond the triangle's plane in the axis' direction.
  [[nodiscard]] static bool beyond(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& node, int side) {
    const int s = exact::orientation(a, b, c, node);
    if (s == 0) throw GridTouches{};
    return s == side;
  }

  std::uint64_t edge_;
  int axis_;
};

}  // namespace

void SurfaceCrossings::addTo(std::vector<SurfaceCrossing>& out, std::uint64_t edge) const {
  const EdgeProbe probe(grid_, edge);
  for (const TriangleId t : tree_.near(probe.low, probe.high)) {
    const auto& [a, b, c] = triangles_[t];
    if (const auto found = probe.crossing(positions_[a], positions_[b], positions_[c])) out.push_back(*found);
  }
}

std::vector<SurfaceCrossing> CarrierCrossings::of(std::uint64_t edge) const {
  std::vector<SurfaceCrossing> crossings;
  surface_.addTo(crossings, edge);
  beyond_.addTo(crossings, edge);
  std::sort(crossings.begin(), crossings.end(), before);
  return crossings;
}

}  // namespace thicken::field
