// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/slope_limit.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "mesh/buckets.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::sweep {

using parallel::parallelFor;

namespace {

// Largest change of the way per length of edge.
constexpr double kSlope = 1.0;
constexpr std::size_t kGrain = 4096;  // copies that a thread takes at a time

}  // namespace

CopyGraph copyGraph(const SweptMesh& mesh, int threads) {
  auto neighbours = mesh::intoBuckets<std::uint32_t>(
      mesh.triangles.size() - mesh.surfaceTriangles, mesh.copies.size(), threads,
      [&](std::size_t i, const auto& put) {
        const Triangle& t = mesh.triangles[mesh.surfaceTriangles + i];
        for (int k = 0; k < 3; ++k) {
          const VertexId a = t[k], b = t[(k + 1) % 3];
          if (!mesh.isCopy(a) || !mesh.isCopy(b)) continue;
          const auto j = static_cast<std::uint32_t>(a - mesh.surfaceVertices);
          const auto l = static_cast<std::uint32_t>(b - mesh.surfaceVertices);
          put(j, l);
          put(l, j);
        }
      });
  // Each edge of two triangles comes twice: what is left of a bucket is moved to its front, then all
  // together.
  const std::vector<std::uint32_t>& first = neighbours.offset;
  std::vector<std::uint32_t> count(mesh.copies.size());
  parallelFor(count.size(), threads, RunContext(), kGrain, [&](std::size_t i) {
    const auto begin = neighbours.values.begin() + first[i], end = neighbours.values.begin() + first[i + 1];
    std::sort(begin, end);
    count[i] = static_cast<std::uint32_t>(std::unique(begin, end) - begin);
  });
  CopyGraph graph;
  graph.offset.resize(count.size() + 1);
  for (std::size_t i = 0; i < count.size(); ++i) graph.offset[i + 1] = graph.offset[i] + count[i];
  graph.links.resize(graph.offset.back());
  parallelFor(count.size(), threads, RunContext(), kGrain, [&](std::size_t i) {
    const Copy& own = mesh.copies[i];
    const Vec3& base = mesh.positions[own.base];
    for (std::uint32_t k = 0; k < count[i]; ++k) {
      const std::uint32_t j = neighbours.values[first[i] + k];
      const Copy& other = mesh.copies[j];
      graph.links[graph.offset[i] + k] = {
          j, kSlope * (base - mesh.positions[other.base]).norm() + std::max(0.0, other.length - own.length)};
    }
  });
  return graph;
}

std::vector<std::uint32_t> limitSlope(SweptMesh& mesh, const CopyGraph& graph,
                                      std::span<const std::uint32_t> from, int threads) {
  using Entry = std::pair<double, std::uint32_t>;  // way, copy
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto wayOf = [&](std::uint32_t i) { return mesh.copies[i].depth * mesh.copies[i].length; };
  // A copy that bounds none of its neighbours need not wait: it will not before it is lowered itself.
  const auto bounds = [&](std::uint32_t i) {
    const double way = wayOf(i);
    return std::any_of(graph.links.begin() + graph.offset[i], graph.links.begin() + graph.offset[i + 1],
                       [&](const CopyGraph::Link& link) {
                         return !mesh.copies[link.copy].dropped && wayOf(link.copy) > way + link.slack;
                       });
  };
  if (from.empty()) {
    std::vector<std::uint8_t> starts(mesh.copies.size());
    parallelFor(starts.size(), threads, RunContext(), kGrain, [&](std::size_t i) {
      starts[i] = !mesh.copies[i].dropped && bounds(static_cast<std::uint32_t>(i));
    });
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
      if (starts[i] != 0) open.emplace(wayOf(i), i);
  } else {
    for (const std::uint32_t i : from)
      if (!mesh.copies[i].dropped) open.emplace(wayOf(i), i);
  }
  std::vector<std::uint32_t> lowered;
  while (!open.empty()) {
    const auto [way, i] = open.top();
    open.pop();
    if (way > wayOf(i)) continue;
    for (std::uint32_t k = graph.offset[i]; k < graph.offset[i + 1]; ++k) {
      const auto& link = graph.links[k];
      Copy& other = mesh.copies[link.copy];
      const double most = way + link.slack;
      if (other.dropped || other.depth * other.length <= most) continue;
      other.depth = most / other.length;
      lowered.push_back(link.copy);
      open.emplace(wayOf(link.copy), link.copy);
    }
  }
  mesh::sortUnique(lowered);
  return lowered;
}

}  // namespace thicken::sweep
