// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/cover.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace thicken::repairing {
namespace {

struct Offer {
  double pairsForWeight;
  std::uint32_t pairs;
  TriangleId triangle;
  bool operator<(const Offer& o) const {
    return pairsForWeight != o.pairsForWeight ? pairsForWeight < o.pairsForWeight : triangle > o.triangle;
  }
};

}  // namespace

MeetingGraph::MeetingGraph(std::size_t triangles, std::span<const exact::TrianglePair> pairs)
    : offset_(triangles + 1, 0), other_(2 * pairs.size()) {
  for (const auto& [a, b] : pairs) {
    ++offset_[a + 1];
    ++offset_[b + 1];
  }
  std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
  std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
  for (const auto& [a, b] : pairs) {
    other_[next[a]++] = b;
    other_[next[b]++] = a;
  }
}

std::vector<TriangleId> smallCover(const MeetingGraph& graph, std::span<const std::uint8_t> present,
                                   std::span<const double> weight) {
  std::vector<std::uint32_t> open(present.size(), 0);
  std::priority_queue<Offer> offers;
  const auto offer = [&](TriangleId t) {
    if (open[t] > 0) offers.push({open[t] / weight[t], open[t], t});
  };
  for (TriangleId t = 0; t < present.size(); ++t) {
    if (present[t] == 0) continue;
    for (const TriangleId u : graph.of(t)) open[t] += present[u] != 0;
    offer(t);
  }
  std::vector<std::uint8_t> taken(present.size(), 0);
  std::vector<TriangleId> cover;
  while (!offers.empty()) {
    const Offer best = offers.top();
    offers.pop();
    const TriangleId t = best.triangle;
    if (best.pairs != open[t]) continue;  // a later offer holds its present number of pairs
    taken[t] = 1;
    open[t] = 0;
    cover.push_back(t);
    for (const TriangleId u : graph.of(t)) {
      if (present[u] == 0 || taken[u] != 0) continue;
      --open[u];
      offer(u);
    }
  }
  std::stable_sort(cover.begin(), cover.end(),
                   [&](TriangleId a, TriangleId b) { return weight[a] > weight[b]; });
  std::erase_if(cover, [&](TriangleId t) {
    const auto others = graph.of(t);
    const bool needed = std::any_of(others.begin(), others.end(),
                                    [&](TriangleId u) { return present[u] != 0 && taken[u] == 0; });
    taken[t] = needed;
    return !needed;
  });
  std::sort(cover.begin(), cover.end());
  return cover;
}

}  // namespace thicken::repairing
