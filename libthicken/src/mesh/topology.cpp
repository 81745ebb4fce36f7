// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/topology.h"

#include <numeric>

#include "mesh/half_edges.h"
#include "mesh/union_find.h"
#include "parallel_for.h"

namespace thicken {

VertexTriangles vertexTriangles(std::size_t vertexCount, std::span<const Triangle> triangles) {
  VertexTriangles result;
  result.offset.assign(vertexCount + 1, 0);
  for (const Triangle& t : triangles)
    for (const VertexId v : t) ++result.offset[v + 1];
  std::partial_sum(result.offset.begin(), result.offset.end(), result.offset.begin());
  result.triangles.resize(3 * triangles.size());
  std::vector<std::uint32_t> next(result.offset.begin(), result.offset.end() - 1);
  for (TriangleId t = 0; t < triangles.size(); ++t)
    for (const VertexId v : triangles[t]) result.triangles[next[v]++] = t;
  return result;
}

std::vector<std::array<TriangleId, 3>> neighbours(std::size_t vertexCount,
                                                  std::span<const Triangle> triangles, int threads) {
  const HalfEdges edges(vertexCount, triangles, {}, threads);
  std::vector<std::array<TriangleId, 3>> result(triangles.size());
  parallelFor(triangles.size(), threads, RunContext(), 4096, [&](std::size_t t) {
    for (int k = 0; k < 3; ++k) {
      const auto opposite = edges.uses(triangles[t][(k + 1) % 3], triangles[t][k]);
      result[t][k] = opposite.empty() ? kNone : opposite.front().triangle();
    }
  });
  return result;
}

Rim rimOf(std::size_t vertexCount, std::span<const Triangle> triangles) {
  const HalfEdges edges(vertexCount, triangles);
  std::vector<std::uint32_t> out(vertexCount, kNone);  // the rim edge that leaves a vertex, as a slot
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (edges.uses(triangles[t][(k + 1) % 3], triangles[t][k]).empty()) out[triangles[t][k]] = 3 * t + k;

  Rim rim;
  rim.loopStart.push_back(0);
  for (VertexId start = 0; start < vertexCount; ++start) {
    VertexId v = start;
    while (out[v] != kNone) {
      const std::uint32_t slot = out[v];
      const TriangleId t = slot / 3;
      const VertexId to = triangles[t][(slot % 3 + 1) % 3];
      out[v] = kNone;
      rim.edges.push_back({v, to, t});
      v = to;
    }
    if (rim.edges.size() > rim.loopStart.back())
      rim.loopStart.push_back(static_cast<std::uint32_t>(rim.edges.size()));
  }
  return rim;
}

Components componentsOf(std::size_t vertexCount, std::span<const Triangle> triangles) {
  UnionFind vertices(vertexCount);
  for (const Triangle& t : triangles) {
    vertices.join(t[0], t[1]);
    vertices.join(t[0], t[2]);
  }
  Components result;
  result.ofTriangle.resize(triangles.size());
  std::vector<std::uint32_t> number(vertexCount, kNone);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::uint32_t& n = number[vertices.root(triangles[t][0])];
    if (n == kNone) n = result.count++;
    result.ofTriangle[t] = n;
  }
  return result;
}

}  // namespace thicken
