// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/corner_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thicken::io {

std::uint32_t CornerGrid::clamped(double cell) const {
  return static_cast<std::uint32_t>(std::clamp(cell, 0.0, side_ - 1.0));
}

CornerGrid::Span CornerGrid::spanInRow(const std::array<Vec3, 3>& triangle, double bottom, double top) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Span span{kInfinity, -kInfinity};
  const auto include = [&span](double x) {
    span.low = std::min(span.low, x);
    span.high = std::max(span.high, x);
  };
  for (int k = 0; k < 3; ++k) {
    const Vec3& a = triangle[k];
    const Vec3& b = triangle[(k + 1) % 3];
    if (std::max(a.y(), b.y()) < bottom || std::min(a.y(), b.y()) > top) continue;
    const double rise = b.y() - a.y();
    for (const double height : {bottom, top}) {
      const double part = rise == 0 ? 0 : std::clamp((height - a.y()) / rise, 0.0, 1.0);
      include(a.x() + part * (b.x() - a.x()));
    }
    if (rise == 0) include(b.x());
  }
  return span;
}

void CornerGrid::build(std::span<const Vec3> points, std::vector<std::uint32_t> corners) {
  side_ = 0;
  if (corners.empty()) return;
  Vec3 low = points[corners[0]], high = low;
  for (const std::uint32_t corner : corners) {
    low = low.cwiseMin(points[corner]);
    high = high.cwiseMax(points[corner]);
  }
  side_ = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(corners.size()))));
  low_ = low;
  for (int k = 0; k < 2; ++k) cellsPerUnit_[k] = high[k] > low[k] ? side_ / (high[k] - low[k]) : 0;

  const auto cellOf = [this, &points](std::uint32_t corner) {
    const Vec3 at = inCells(points[corner]);
    return clamped(at.y()) * side_ + clamped(at.x());
  };
  begin_.assign(std::size_t{side_} * side_ + 1, 0);
  for (const std::uint32_t corner : corners) ++begin_[cellOf(corner) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> place(begin_.begin(), begin_.end() - 1);
  corners_.resize(corners.size());
  for (const std::uint32_t corner : corners) corners_[place[cellOf(corner)]++] = corner;
}

}  // namespace thicken::io
