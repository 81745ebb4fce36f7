// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/corner_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thicken::io {
namespace {

// Extents of points of size 1 below which a division by them could overflow.
constexpr double kFlat = 1e-290;

}  // namespace

std::uint32_t CornerGrid::clamped(double cell, std::uint32_t cells) {
  return static_cast<std::uint32_t>(std::clamp(cell, 0.0, cells - 1.0));
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
  rows_ = 0;
  if (corners.empty()) return;
  Vec3 low = points[corners[0]], high = low;
  for (const std::uint32_t corner : corners) {
    low = low.cwiseMin(points[corner]);
    high = high.cwiseMax(points[corner]);
  }
  const auto count = static_cast<double>(corners.size());
  const Vec3 extent = high - low;
  // Rows cost more than cells; a triangle reaches across few of them when they lie along the points.
  upright_ = extent.y() > extent.x();
  const double width = extent[upright_ ? 1 : 0], height = extent[upright_ ? 0 : 1];
  // As square as they can be for one corner a cell.
  const double columns = height > kFlat ? std::sqrt(count * (width / height)) : count;
  columns_ = 1 + clamped(columns, static_cast<std::uint32_t>(corners.size()));
  rows_ = 1 + static_cast<std::uint32_t>(count) / columns_;
  low_ = low;
  cellsPerUnit_ = Vec3::Zero();
  if (width > kFlat) cellsPerUnit_[upright_ ? 1 : 0] = columns_ / width;
  if (height > kFlat) cellsPerUnit_[upright_ ? 0 : 1] = rows_ / height;

  begin_.assign(std::size_t{rows_} * columns_ + 1, 0);
  for (const std::uint32_t corner : corners) ++begin_[cellOf(inCells(points[corner])) + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  end_.assign(begin_.begin(), begin_.end() - 1);
  corners_.resize(corners.size());
  points_.resize(corners.size());
  place_.resize(points.size());
  for (const std::uint32_t corner : corners) {
    const Vec3 point = inCells(points[corner]);
    const std::uint32_t i = end_[cellOf(point)]++;
    corners_[i] = corner;
    points_[i] = point;
    place_[corner] = i;
  }
}

void CornerGrid::remove(std::uint32_t corner) {
  const std::uint32_t i = place_[corner];
  const std::uint32_t last = --end_[cellOf(points_[i])];
  corners_[i] = corners_[last];
  points_[i] = points_[last];
  place_[corners_[i]] = i;
}

}  // namespace thicken::io
