// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Disjoint sets of consecutive numbers. The root of a set is its smallest member, whatever the order
// in which the set was joined.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace thicken {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count = 0) { reset(count); }

  /// Every number alone again.
  void reset(std::size_t count) {
    up_.resize(count);
    std::iota(up_.begin(), up_.end(), 0u);
  }

  [[nodiscard]] std::uint32_t root(std::uint32_t i) {
    while (up_[i] != i) i = up_[i] = up_[up_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a < b)
      up_[b] = a;
    else
      up_[a] = b;
  }

 private:
  std::vector<std::uint32_t> up_;
};

}  // namespace thicken
