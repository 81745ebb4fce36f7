// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/rim_walk.h"

#include <algorithm>
#include <utility>

#include "exact/predicates.h"

namespace thicken::contour {

using field::GridIndex;
using field::GridTouches;
using field::UniformGrid;

namespace {

GridIndex cellOf(const UniformGrid& grid, const Vec3& p) {
  GridIndex cell{};
  for (int k = 0; k < 3; ++k) {
    cell[k] = grid.indexBelow(k, p[k]);
    if (grid.coordinate(k, cell[k]) == p[k]) throw GridTouches{};
  }
  return cell;
}

// Walks from `a` to `b`; visit(passage, next cell) at every face.
class SegmentWalk {
 public:
  SegmentWalk(const UniformGrid& grid, const Vec3& a, const Vec3& b)
      : grid_(grid), a_(a), b_(b), cell_(cellOf(grid, a)), end_(cellOf(grid, b)) {}

  template <class Visit>
  void run(Visit visit) {
    while (cell_ != end_) {
      const int axis = nextAxis();
      const int step = end_[axis] > cell_[axis] ? 1 : -1;
      GridIndex lowest = cell_;
      lowest[axis] = plane(axis);
      RimPassage passage{UniformGrid::key(lowest, axis), step, at(axis)};
      cell_[axis] += step;
      visit(passage, cell_);
    }
  }

 private:
  [[nodiscard]] int plane(int axis) const { return end_[axis] > cell_[axis] ? cell_[axis] + 1 : cell_[axis]; }

  // The axis whose next plane comes first.
  [[nodiscard]] int nextAxis() const {
    int best = -1;
    for (int k = 0; k < 3; ++k)
      if (cell_[k] != end_[k] && (best < 0 || before(k, best))) best = k;
    return best;
  }

  // Whether the next plane of axis i comes before that of axis j.
  [[nodiscard]] bool before(int i, int j) const {
    const int dropped = 3 - i - j;
    const bool cyclic = i == (dropped + 1) % 3;
    const int u = cyclic ? i : j, v = cyclic ? j : i;
    Vec3 p = Vec3::Zero();
    p[u] = grid_.coordinate(u, plane(u));
    p[v] = grid_.coordinate(v, plane(v));
    const int side = exact::orientation2(a_, b_, p, dropped);
    if (side == 0) throw GridTouches{};
    const int senseU = end_[u] > cell_[u] ? 1 : -1, senseV = end_[v] > cell_[v] ? 1 : -1;
    const bool uFirst = senseU * senseV * side > 0;
    return uFirst == cyclic;
  }

  [[nodiscard]] Vec3 at(int axis) const {
    const double x = grid_.coordinate(axis, plane(axis));
    const double t = (x - a_[axis]) / (b_[axis] - a_[axis]);
    return a_ + std::clamp(t, 0.0, 1.0) * (b_ - a_);
  }

  const UniformGrid& grid_;
  const Vec3 &a_, &b_;
  GridIndex cell_, end_;
};

void append(std::vector<VertexId>& to, const std::vector<VertexId>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// A way under construction that never holds an excursion.
class WayStack {
 public:
  explicit WayStack(const GridIndex& cell) { way_.push_back({cell, {}, {}}); }

  void addVertex(VertexId v) { way_.back().vertices.push_back(v); }

  void pass(const RimPassage& passage, const GridIndex& next) {
    if (way_.size() >= 2 && way_[way_.size() - 2].cell == next) {
      const std::vector<VertexId> excursion = std::move(way_.back().vertices);
      way_.pop_back();
      append(way_.back().vertices, excursion);
      return;
    }
    way_.back().exit = passage;
    way_.push_back({next, {}, {}});
  }

  // The loop has come back to its first cell.
  RimWay close() {
    if (way_.size() == 1) return std::move(way_);
    const std::vector<VertexId> tail = std::move(way_.back().vertices);
    way_.pop_back();
    way_.front().vertices.insert(way_.front().vertices.begin(), tail.begin(), tail.end());
    std::size_t first = 0, end = way_.size();  // the cyclic way is [first, end)
    while (end - first >= 2) {
      RimVisit &last = way_[end - 1], &here = way_[first], &next = way_[first + 1];
      if (end - first == 2) {
        append(here.vertices, next.vertices);
        end = first + 1;
        break;
      }
      if (last.cell != next.cell) break;
      std::vector<VertexId> merged = std::move(last.vertices);
      append(merged, here.vertices);
      append(merged, next.vertices);
      next.vertices = std::move(merged);
      ++first;
      --end;
    }
    return {way_.begin() + static_cast<std::ptrdiff_t>(first),
            way_.begin() + static_cast<std::ptrdiff_t>(end)};
  }

 private:
  RimWay way_;
};

}  // namespace

std::vector<RimWay> rimWays(const UniformGrid& grid, std::span<const Vec3> positions, const mesh::Rim& rim) {
  std::vector<RimWay> ways;
  for (std::size_t loop = 0; loop < rim.loops(); ++loop) {
    const std::uint32_t begin = rim.loopStart[loop], end = rim.loopStart[loop + 1];
    WayStack stack(cellOf(grid, positions[rim.edges[begin].from]));
    for (std::uint32_t e = begin; e < end; ++e) {
      stack.addVertex(rim.edges[e].from);
      SegmentWalk(grid, positions[rim.edges[e].from], positions[rim.edges[e].to])
          .run([&](const RimPassage& passage, const GridIndex& next) { stack.pass(passage, next); });
    }
    ways.push_back(stack.close());
  }
  return ways;
}

}  // namespace thicken::contour
