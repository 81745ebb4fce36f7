// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/surface_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "exact/predicates.h"
#include "mesh/parallel_sort.h"
#include "parallel_for.h"

namespace thicken {

namespace {

bool before(const SurfaceCrossing& x, const SurfaceCrossing& y) {
  return x.edge != y.edge ? x.edge < y.edge : x.at != y.at ? x.at < y.at : x.jump < y.jump;
}

// The crossings of one triangle with the grid edges along one axis.
class TriangleRaster {
 public:
  TriangleRaster(const UniformGrid& grid, const Vec3& a, const Vec3& b, const Vec3& c)
      : grid_(grid), a_(a), b_(b), c_(c), normal_((b - a).cross(c - a)) {}

  void rasterize(int axis, std::vector<SurfaceCrossing>& out) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Vec3 low = a_.cwiseMin(b_).cwiseMin(c_), high = a_.cwiseMax(b_).cwiseMax(c_);
    const int u0 = grid_.indexBelow(u, low[u]), u1 = grid_.indexBelow(u, high[u]);
    const int v0 = grid_.indexBelow(v, low[v]), v1 = grid_.indexBelow(v, high[v]);
    if (u0 == u1 || v0 == v1) return;
    const int side = exact::orientation2(a_, b_, c_, axis);
    if (side == 0) return;  // seen edge-on: a line along the axis that met it would touch an edge
    for (int i = u0 + 1; i <= u1; ++i)
      for (int j = v0 + 1; j <= v1; ++j) {
        Vec3 p = Vec3::Zero();
        p[u] = grid_.coordinate(u, i);
        p[v] = grid_.coordinate(v, j);
        if (!within(p, axis, side)) continue;
        GridIndex n{};
        n[u] = i;
        n[v] = j;
        out.push_back(locate(p, n, axis, side));
      }
  }

 private:
  [[nodiscard]] bool within(const Vec3& p, int axis, int side) const {
    const int s0 = exact::orientation2(a_, b_, p, axis) * side;
    if (s0 < 0) return false;
    const int s1 = exact::orientation2(b_, c_, p, axis) * side;
    if (s1 < 0) return false;
    const int s2 = exact::orientation2(c_, a_, p, axis) * side;
    if (s2 < 0) return false;
    if (s0 == 0 || s1 == 0 || s2 == 0) throw GridTouches{};
    return true;
  }

  // Whether the node lies beyond the plane in the axis' direction.
  [[nodiscard]] bool beyond(const GridIndex& n, int side) const {
    const int s = exact::orientation(a_, b_, c_, grid_.node(n));
    if (s == 0) throw GridTouches{};
    return s == side;
  }

  [[nodiscard]] SurfaceCrossing locate(Vec3 p, GridIndex n, int axis, int side) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double low = std::min({a_[axis], b_[axis], c_[axis]});
    const double high = std::max({a_[axis], b_[axis], c_[axis]});
    double x = a_[axis] - (normal_[u] * (p[u] - a_[u]) + normal_[v] * (p[v] - a_[v])) / normal_[axis];
    x = x >= low && x <= high ? x : (low + high) / 2;
    n[axis] = grid_.indexBelow(axis, x);
    while (beyond(n, side)) --n[axis];
    for (GridIndex next = n;; n = next) {
      ++next[axis];
      if (beyond(next, side)) break;
    }
    return {UniformGrid::key(n, axis),
            std::clamp(x, grid_.coordinate(axis, n[axis]), grid_.coordinate(axis, n[axis] + 1)), -side};
  }

  const UniformGrid& grid_;
  const Vec3 &a_, &b_, &c_;
  Vec3 normal_;
};

}  // namespace

std::vector<SurfaceCrossing> surfaceCrossings(const UniformGrid& grid, std::span<const Vec3> positions,
                                              std::span<const Triangle> triangles, const RunContext& context,
                                              int threads) {
  constexpr std::size_t kGrain = 256;
  std::vector<std::vector<SurfaceCrossing>> parts((triangles.size() + kGrain - 1) / kGrain);
  parallelFor(triangles.size(), threads, context, kGrain, [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    const TriangleRaster raster(grid, positions[a], positions[b], positions[c]);
    for (int axis = 0; axis < 3; ++axis) raster.rasterize(axis, parts[t / kGrain]);
  });
  std::vector<SurfaceCrossing> all;
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  all.reserve(count);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  parallelSort(all, before, threads);
  return all;
}

CrossedEdges::CrossedEdges(std::span<const SurfaceCrossing> one, std::span<const SurfaceCrossing> other,
                           int threads)
    : crossings_(one.size() + other.size()), filter_(crossings_.size()) {
  parallelMerge(one, other, crossings_.data(), before, threads);
  for (const SurfaceCrossing& c : crossings_) filter_.add(c.edge);
}

std::span<const SurfaceCrossing> CrossedEdges::found(std::uint64_t edge) const {
  const auto begin = std::lower_bound(crossings_.begin(), crossings_.end(), edge,
                                      [](const SurfaceCrossing& c, std::uint64_t e) { return c.edge < e; });
  auto end = begin;
  while (end != crossings_.end() && end->edge == edge) ++end;
  return {begin, end};
}

}  // namespace thicken
