// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/half_edges.h"

#include <algorithm>
#include <numeric>

#include "parallel_for.h"

namespace thicken {

HalfEdges::HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles,
                     std::span<const std::uint8_t> active, int threads)
    : offset_(vertexCount + 1, 0) {
  const auto isActive = [active](std::size_t t) { return active.empty() || active[t] != 0; };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (isActive(t))
      for (const VertexId v : triangles[t]) ++offset_[v + 1];
  std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
  edges_.resize(offset_.back());
  std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (isActive(t))
      for (std::uint32_t k = 0; k < 3; ++k)
        edges_[next[triangles[t][k]]++] = {triangles[t][(k + 1) % 3], 3 * t + k};
  parallelFor(vertexCount, threads, RunContext(), 4096, [&](std::size_t v) {
    std::sort(
        edges_.begin() + offset_[v], edges_.begin() + offset_[v + 1],
        [](const HalfEdge& a, const HalfEdge& b) { return a.to != b.to ? a.to < b.to : a.slot < b.slot; });
  });
}

std::span<const HalfEdge> HalfEdges::uses(VertexId from, VertexId to) const {
  const std::span<const HalfEdge> leaving = this->from(from);
  const auto begin = std::lower_bound(leaving.begin(), leaving.end(), to,
                                      [](const HalfEdge& e, VertexId v) { return e.to < v; });
  auto end = begin;
  while (end != leaving.end() && end->to == to) ++end;
  return {begin, end};
}

}  // namespace thicken
