// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Disjoint sets of consecutive numbers. The root of a set is its smallest member. It does not depend on the
// order in which sets were joined, nor on the number of threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "parallel/parallel_for.h"
#include "platform/shared_number.h"

namespace thicken::mesh {

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

  /// As join(), on any number of threads at a time.
  void joinShared(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = rootShared(a);
      b = rootShared(b);
      if (a == b) return;
      if (a > b) std::swap(a, b);
      std::uint32_t root = b;
      if (platform::SharedNumber(up_[b]).compare_exchange_strong(root, a, std::memory_order_relaxed)) return;
    }
  }

  /// Joins the pair of numbers pairOf(i) for every i below `count`.
  template <class PairOf>
  void joinAll(std::size_t count, int threads, PairOf pairOf) {
    constexpr std::size_t kGrain = 1 << 13;
    if (parallel::threadCount(threads) == 1 || count <= kGrain) {
      for (std::size_t i = 0; i < count; ++i) {
        const auto [a, b] = pairOf(i);
        join(a, b);
      }
      return;
    }
    parallel::parallelFor(count, threads, RunContext(), kGrain, [&](std::size_t i) {
      const auto [a, b] = pairOf(i);
      joinShared(a, b);
    });
  }

  /// The roots of all numbers.
  [[nodiscard]] std::vector<std::uint32_t> roots(int threads) {
    std::vector<std::uint32_t> result(up_.size());
    parallel::parallelFor(up_.size(), threads, RunContext(), 1 << 13, [&](std::size_t i) {
      std::uint32_t r = up_[i];
      while (up_[r] != r) r = up_[r];
      result[i] = r;
    });
    return result;
  }

 private:
  // What is written to a number that is no root is always another member of its set, and nearer to the root.
  std::uint32_t rootShared(std::uint32_t i) {
    for (;;) {
      const std::uint32_t up = platform::SharedNumber(up_[i]).load(std::memory_order_relaxed);
      if (up == i) return i;
      const std::uint32_t next = platform::SharedNumber(up_[up]).load(std::memory_order_relaxed);
      if (next != up) platform::SharedNumber(up_[i]).store(next, std::memory_order_relaxed);
      i = next;
    }
  }

  std::vector<std::uint32_t> up_;
};

}  // namespace thicken::mesh
