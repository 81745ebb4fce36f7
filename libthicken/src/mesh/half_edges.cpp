// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/half_edges.h"

#include <algorithm>

#include "mesh/buckets.h"

namespace thicken::mesh {

HalfEdges::HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles,
                     std::span<const std::uint8_t> active, int threads) {
  auto leaving =
      intoBuckets<HalfEdge>(triangles.size(), vertexCount, threads, [&](std::size_t t, const auto& put) {
        if (!active.empty() && active[t] == 0) return;
        for (std::uint32_t k = 0; k < 3; ++k)
          put(triangles[t][k], HalfEdge{triangles[t][(k + 1) % 3], 3 * static_cast<std::uint32_t>(t) + k});
      });
  offset_ = std::move(leaving.offset);
  edges_ = std::move(leaving.values);
  parallel::parallelFor(vertexCount, threads, RunContext(), 4096, [&](std::size_t v) {
    std::sort(
        edges_.begin() + offset_[v], edges_.begin() + offset_[v + 1],
        [](const HalfEdge& a, const HalfEdge& b) { return a.to != b.to ? a.to < b.to : a.slot < b.slot; });
  });
}

std::span<const HalfEdge> HalfEdges::search(std::span<const HalfEdge> leaving, VertexId to) {
  const auto begin = std::lower_bound(leaving.begin(), leaving.end(), to,
                                      [](const HalfEdge& e, VertexId v) { return e.to < v; });
  auto end = begin;
  while (end != leaving.end() && end->to == to) ++end;
  return {begin, end};
}

}  // namespace thicken::mesh
