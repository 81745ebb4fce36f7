// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Splits a range of triangles' boxes by the surface-area heuristic. Boxes are floats: they decide the quality
// of a tree and no answer. They are moved along with the order, so that each pass over a range reads memory
// in sequence.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "thicken/mesh.h"

namespace thicken::bvh {

class AreaSplit {
 public:
  using Four = Eigen::Array<float, 4, 1>;

  /// A box; the fourth numbers have no meaning.
  struct Box {
    Four low = Four::Constant(std::numeric_limits<float>::infinity());
    Four high = Four::Constant(-std::numeric_limits<float>::infinity());
    void add(const Box& b) {
      low = low.min(b.low);
      high = high.max(b.high);
    }
    [[nodiscard]] double halfArea() const;
  };

  /// Triangles [begin, end) of the order.
  struct Range {
    std::uint32_t begin = 0, end = 0;
    Box box;      ///< around them
    Box middles;  ///< around twice the middles of their boxes
    [[nodiscard]] std::uint32_t size() const { return end - begin; }
  };

  /// Boxes are taken from `centre`, so that floats hold them well.
  AreaSplit(std::span<const Vec3> positions, std::span<const Triangle> triangles, const Vec3& centre,
            int threads);

  /// All of them.
  [[nodiscard]] Range whole() const;

  /// Reorders a range of at least two triangles and splits it. Disjoint ranges may be split at the same
  /// time.
  [[nodiscard]] std::pair<Range, Range> split(const Range& r, int threads = 1);

  /// Splits a range of at least two triangles in the middle of its order.
  [[nodiscard]] std::pair<Range, Range> halve(const Range& r) const;

  /// The triangle at a place of the order.
  [[nodiscard]] TriangleId triangle(std::uint32_t place) const { return items_[place].id(); }

 private:
  // The fourth numbers are the triangle and the bin that it is in.
  struct Item {
    Four low, high;
    [[nodiscard]] std::uint32_t id() const { return std::bit_cast<std::uint32_t>(low[3]); }
    [[nodiscard]] std::uint32_t bin() const { return std::bit_cast<std::uint32_t>(high[3]); }
    void setBin(std::uint32_t bin) { high[3] = std::bit_cast<float>(bin); }
  };

  [[nodiscard]] Range rangeOf(std::uint32_t begin, std::uint32_t end) const;

  std::uint32_t count_;
  std::unique_ptr<Item[]> items_, other_;  // `other_`: room for those that go to the right
};

}  // namespace thicken::bvh
