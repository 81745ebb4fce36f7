// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/slope_limit.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "mesh/sort_unique.h"

namespace thicken {

namespace {

// Largest change of the way per length of edge.
constexpr double kSlope = 1.0;

}  // namespace

CopyGraph copyGraph(const SweptMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t t = mesh.surfaceTriangles; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const VertexId a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (!mesh.isCopy(a) || !mesh.isCopy(b)) continue;
      const auto i = static_cast<std::uint32_t>(a - mesh.surfaceVertices);
      const auto j = static_cast<std::uint32_t>(b - mesh.surfaceVertices);
      edges.emplace_back(i, j);
      edges.emplace_back(j, i);
    }
  sortUnique(edges);
  CopyGraph graph;
  graph.offset.assign(mesh.copies.size() + 1, 0);
  graph.links.reserve(edges.size());
  for (const auto& [i, j] : edges) {
    ++graph.offset[i + 1];
    const double length = (mesh.positions[mesh.copies[i].base] - mesh.positions[mesh.copies[j].base]).norm();
    graph.links.push_back({j, kSlope * length});
  }
  for (std::size_t i = 0; i < mesh.copies.size(); ++i) graph.offset[i + 1] += graph.offset[i];
  return graph;
}

std::vector<std::uint32_t> limitSlope(SweptMesh& mesh, const CopyGraph& graph,
                                      std::span<const std::uint32_t> from) {
  using Entry = std::pair<double, std::uint32_t>;  // way, copy
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto wayOf = [&](std::uint32_t i) { return mesh.copies[i].depth * mesh.copies[i].length; };
  if (from.empty()) {
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
      if (!mesh.copies[i].dropped) open.emplace(wayOf(i), i);
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
  sortUnique(lowered);
  return lowered;
}

}  // namespace thicken
