// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The uniform grid of the paper's section 3 as numbers only: nothing is stored for a node, an edge, a
// face or a cell but its key, so that sparse sets of them are sorted vectors of integers.
#pragma once

#include <array>
#include <cstdint>

#include "thicken/mesh.h"

namespace thicken::field {

/// Index of a node, and of the cell whose lowest corner it is.
using GridIndex = std::array<int, 3>;

class UniformGrid {
 public:
  static constexpr int kBits = 20;
  static constexpr int kMostCells = (1 << kBits) - 2;

  UniformGrid() = default;
  UniformGrid(const Vec3& origin, double width, const GridIndex& cells)
      : origin_(origin), width_(width), cells_(cells) {}

  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] const GridIndex& cells() const { return cells_; }
  /// Coordinate of the nodes with index `i` along `axis`; every exact test sees this very double.
  [[nodiscard]] double coordinate(int axis, int i) const { return origin_[axis] + width_ * i; }
  [[nodiscard]] Vec3 node(const GridIndex& n) const {
    return {coordinate(0, n[0]), coordinate(1, n[1]), coordinate(2, n[2])};
  }
  /// The largest i whose nodes are not above `x`.
  [[nodiscard]] int indexBelow(int axis, double x) const {
    int i = static_cast<int>((x - origin_[axis]) / width_);
    while (coordinate(axis, i) > x) --i;
    while (coordinate(axis, i + 1) <= x) ++i;
    return i;
  }

  [[nodiscard]] static std::uint64_t key(const GridIndex& n) {
    return (std::uint64_t(n[2]) << (2 * kBits)) | (std::uint64_t(n[1]) << kBits) | std::uint64_t(n[0]);
  }
  /// Key of the edge from node `n` along `axis`, or of the face with lowest node `n` and that normal.
  [[nodiscard]] static std::uint64_t key(const GridIndex& n, int axis) { return (key(n) << 2) | axis; }
  [[nodiscard]] static GridIndex indexOf(std::uint64_t nodeKey) {
    constexpr std::uint64_t kMask = (1u << kBits) - 1;
    return {static_cast<int>(nodeKey & kMask), static_cast<int>((nodeKey >> kBits) & kMask),
            static_cast<int>((nodeKey >> (2 * kBits)) & kMask)};
  }

 private:
  Vec3 origin_ = Vec3::Zero();
  double width_ = 1;
  GridIndex cells_{};
};

/// Thrown if a vertex, edge or plane of a surface touches a grid line exactly: no sign decides there. The
/// caller shifts the grid and starts again.
struct GridTouches {};

}  // namespace thicken::field
