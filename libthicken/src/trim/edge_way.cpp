// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim/edge_way.h"

#include <algorithm>
#include <queue>

namespace thicken::trimming {

using mesh::kNone;

namespace {

struct Reached {
  double length;
  VertexId before;
};
using Ways = std::unordered_map<VertexId, Reached>;

bool isOnRim(const DividedSurface& surface, const std::vector<EdgeOf>& link) {
  return std::any_of(link.begin(), link.end(), [&](const EdgeOf& e) {
    return surface.across({e.triangle, (e.corner + 1) % 3}) == kNone ||
           surface.across({e.triangle, (e.corner + 2) % 3}) == kNone;
  });
}

// Dijkstra's algorithm, as far as `to`.
Ways waysFrom(const DividedSurface& surface, const PathMarks& marks, VertexId from, VertexId to,
              double longest) {
  using Entry = std::pair<double, VertexId>;
  Ways ways{{from, {0, from}}};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  waiting.emplace(0, from);
  while (!waiting.empty()) {
    const auto [length, v] = waiting.top();
    waiting.pop();
    if (v == to) break;
    if (length > ways.at(v).length) continue;
    const std::vector<EdgeOf> link = surface.linkOf(v);
    if (v != from && (marks.hasVertex(v) || isOnRim(surface, link))) continue;
    for (const EdgeOf& e : link) {
      for (const VertexId next : {surface.from(e), surface.to(e)}) {
        const double far = length + (surface.at(next) - surface.at(v)).norm();
        const auto [known, fresh] = ways.try_emplace(next, Reached{far, v});
        if (far > longest || (!fresh && known->second.length <= far)) continue;
        known->second = {far, v};
        waiting.emplace(far, next);
      }
    }
  }
  return ways;
}

}  // namespace

VertexId middleOfEdgeWay(const DividedSurface& surface, const PathMarks& marks, VertexId from, VertexId to,
                         double longest) {
  const Ways ways = waysFrom(surface, marks, from, to, longest);
  const auto end = ways.find(to);
  if (end == ways.end() || end->second.length > longest) return kNone;
  const double half = end->second.length / 2;
  VertexId best = kNone;
  double off = 0;
  for (VertexId v = end->second.before; v != from; v = ways.at(v).before) {
    const double d = std::abs(ways.at(v).length - half);
    if (best != kNone && d >= off) continue;
    best = v;
    off = d;
  }
  return best;
}

}  // namespace thicken::trimming
