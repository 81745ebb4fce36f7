// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A grid over points of the plane that finds those near a triangle, however slanted it is.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::io {

class CornerGrid {
 public:
  /// Sorts the chosen `corners` of `points` (x and y count) into about as many cells.
  void build(std::span<const Vec3> points, std::vector<std::uint32_t> corners);

  /// Calls visit(corner) for every corner in the cells that the triangle touches (and a few more)
  /// until it returns true. Adds the cells and corners looked at to `work`.
  template <class Visit>
  bool any(const std::array<Vec3, 3>& triangle, std::uint64_t& work, Visit visit) const;

 private:
  struct Span {
    double low, high;
  };
  [[nodiscard]] Vec3 inCells(const Vec3& point) const { return (point - low_).cwiseProduct(cellsPerUnit_); }
  [[nodiscard]] std::uint32_t clamped(double cell) const;
  // The x of the triangle (in cells) between the heights of one row.
  [[nodiscard]] static Span spanInRow(const std::array<Vec3, 3>& triangle, double bottom, double top);

  Vec3 low_ = Vec3::Zero(), cellsPerUnit_ = Vec3::Zero();
  std::uint32_t side_ = 0;  // cells along either axis; 0: no corners
  std::vector<std::uint32_t> begin_, corners_;
};

template <class Visit>
bool CornerGrid::any(const std::array<Vec3, 3>& triangle, std::uint64_t& work, Visit visit) const {
  if (side_ == 0) return false;
  const std::array<Vec3, 3> t{inCells(triangle[0]), inCells(triangle[1]), inCells(triangle[2])};
  // In cells; far above the rounding of inCells(), far below a cell.
  constexpr double kMargin = 1e-6;
  const double bottom = std::min({t[0].y(), t[1].y(), t[2].y()});
  const double top = std::max({t[0].y(), t[1].y(), t[2].y()});
  for (std::uint32_t row = clamped(bottom - kMargin); row <= clamped(top + kMargin); ++row) {
    const Span span = spanInRow(t, row - kMargin, row + 1 + kMargin);
    if (span.low > span.high) continue;  // the grid ends before the triangle
    const std::uint32_t from = row * side_ + clamped(span.low - kMargin);
    const std::uint32_t to = row * side_ + clamped(span.high + kMargin);
    work += 1 + to - from + begin_[to + 1] - begin_[from];
    for (std::uint32_t i = begin_[from]; i < begin_[to + 1]; ++i) {
      if (visit(corners_[i])) return true;
    }
  }
  return false;
}

}  // namespace thicken::io
