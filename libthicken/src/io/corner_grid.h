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
  /// Sorts the chosen `corners` of `points` (x and y count, at most about 1) into about as many cells.
  void build(std::span<const Vec3> points, std::vector<std::uint32_t> corners);

  /// Takes a corner out that was chosen, once.
  void remove(std::uint32_t corner);

  /// Calls visit(corner) for every corner in the cells that the triangle touches (and a few more)
  /// until it returns true. Adds the cells and corners looked at to `work`.
  template <class Visit>
  bool any(const std::array<Vec3, 3>& triangle, std::uint64_t& work, Visit visit) const;

 private:
  struct Span {
    double low, high;
  };
  [[nodiscard]] Vec3 inCells(const Vec3& point) const {
    const Vec3 cells = (point - low_).cwiseProduct(cellsPerUnit_);
    return upright_ ? Vec3(cells.y(), cells.x(), 0) : cells;
  }
  [[nodiscard]] std::uint32_t cellOf(const Vec3& pointInCells) const {
    return clamped(pointInCells.y(), rows_) * columns_ + clamped(pointInCells.x(), columns_);
  }
  [[nodiscard]] static std::uint32_t clamped(double cell, std::uint32_t cells);
  // The x of the triangle (in cells) between the heights of one row.
  [[nodiscard]] static Span spanInRow(const std::array<Vec3, 3>& triangle, double bottom, double top);

  Vec3 low_ = Vec3::Zero(), cellsPerUnit_ = Vec3::Zero();
  bool upright_ = false;                  // x and y are swapped, so that columns_ >= rows_
  std::uint32_t columns_ = 0, rows_ = 0;  // 0: no corners
  std::vector<std::uint32_t> begin_;      // of each cell, row by row
  std::vector<std::uint32_t> end_;        // of what is left in each cell
  std::vector<std::uint32_t> corners_;
  std::vector<Vec3> points_;          // in cells, in the order of corners_
  std::vector<std::uint32_t> place_;  // of each corner in corners_
};

template <class Visit>
bool CornerGrid::any(const std::array<Vec3, 3>& triangle, std::uint64_t& work, Visit visit) const {
  if (rows_ == 0) return false;
  const std::array<Vec3, 3> t{inCells(triangle[0]), inCells(triangle[1]), inCells(triangle[2])};
  // In cells; far above the rounding of inCells(), far below a cell.
  constexpr double kMargin = 1e-6;
  const double bottom = std::min({t[0].y(), t[1].y(), t[2].y()});
  const double top = std::max({t[0].y(), t[1].y(), t[2].y()});
  for (std::uint32_t row = clamped(bottom - kMargin, rows_); row <= clamped(top + kMargin, rows_); ++row) {
    const Span span = spanInRow(t, row - kMargin, row + 1 + kMargin);
    if (span.low > span.high) continue;  // the grid ends before the triangle
    const std::uint32_t from = row * columns_ + clamped(span.low - kMargin, columns_);
    const std::uint32_t to = row * columns_ + clamped(span.high + kMargin, columns_);
    constexpr std::uint64_t kRowWork = 8;
    work += kRowWork + to - from;
    for (std::uint32_t cell = from; cell <= to; ++cell) {
      work += end_[cell] - begin_[cell];
      for (std::uint32_t i = begin_[cell]; i < end_[cell]; ++i) {
        const Vec3& p = points_[i];
        const bool near = p.y() >= bottom - kMargin && p.y() <= top + kMargin &&
                          p.x() >= span.low - kMargin && p.x() <= span.high + kMargin;
        if (near && visit(corners_[i])) return true;
      }
    }
  }
  return false;
}

}  // namespace thicken::io
