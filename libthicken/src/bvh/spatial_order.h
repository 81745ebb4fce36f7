// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Makes many queries in the order of the tree, whatever the order of the file. Queries that are close
// together find the nodes that they look at in the processor's caches.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "parallel/parallel_for.h"
#include "thicken/closest_point.h"

namespace thicken::bvh {

/// Items that are near some triangles of S, in the order of these in the tree.
class SpatialOrder {
 public:
  /// Items whose queries are made together.
  static constexpr std::size_t kTogether = 32;

  /// `near`: a triangle of S for every item.
  SpatialOrder(std::span<const TriangleId> near, const ClosestPointTree& tree, int threads);

  /// Leaves out the items that `isOut` is true of.
  template <class IsOut>
  void eraseIf(IsOut isOut) {
    std::erase_if(items_, isOut);
  }

  /// Calls work(items) for all of them, so many at a time, on any thread.
  template <class Work>
  void forGroups(int threads, const RunContext& context, Work work) const {
    constexpr std::size_t kGroups = 8;  // that a thread takes at a time
    const std::size_t groups = (items_.size() + kTogether - 1) / kTogether;
    parallel::parallelFor(groups, threads, context, kGroups, [&](std::size_t g) {
      const std::size_t begin = g * kTogether;
      work(std::span(items_).subspan(begin, std::min(kTogether, items_.size() - begin)));
    });
  }

  /// Calls ask(item, k, query) for every item and each k below `each`, which sets the query or returns false,
  /// and take(item, k, point, answer) with what was found; on any thread.
  template <std::size_t kMostEach = 1, class Ask, class Take>
  void query(const ClosestPointTree& tree, std::size_t each, int threads, const RunContext& context, Ask ask,
             Take take) const {
    forGroups(threads, context, [&](std::span<const std::uint32_t> items) {
      constexpr std::size_t kMost = kMostEach * kTogether;
      std::array<ClosestPointTree::Query, kMost> queries;
      std::array<ClosestPoint, kMost> answers;
      std::array<std::pair<std::uint32_t, std::size_t>, kMost> asked;
      std::size_t count = 0;
      for (const std::uint32_t i : items)
        for (std::size_t k = 0; k < each; ++k)
          if (ask(i, k, queries[count])) asked[count++] = {i, k};
      tree.closest(std::span(queries).first(count), answers);
      for (std::size_t j = 0; j < count; ++j)
        take(asked[j].first, asked[j].second, queries[j].point, answers[j]);
    });
  }

 private:
  std::vector<std::uint32_t> items_;
};

}  // namespace thicken::bvh
