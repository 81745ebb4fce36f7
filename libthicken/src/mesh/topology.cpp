// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/topology.h"

#include "mesh/buckets.h"
#include "mesh/half_edges.h"
#include "mesh/union_find.h"
#include "parallel/parallel_for.h"

namespace thicken::mesh {

using parallel::parallelFor;

VertexTriangles vertexTriangles(std::size_t vertexCount, std::span<const Triangle> triangles, int threads) {
  auto around =
      intoBuckets<TriangleId>(triangles.size(), vertexCount, threads, [&](std::size_t t, const auto& put) {
        for (const VertexId v : triangles[t]) put(v, static_cast<TriangleId>(t));
      });
  return {std::move(around.offset), std::move(around.values)};
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

Rim rimOf(std::size_t vertexCount, std::span<const Triangle> triangles, int threads) {
  const HalfEdges edges(vertexCount, triangles, {}, threads);
  std::vector<std::uint32_t> out(vertexCount, kNone);  // the rim edge that leaves a vertex, as a slot
  parallelFor(vertexCount, threads, RunContext(), 4096, [&](std::size_t v) {
    for (const HalfEdge& e : edges.from(static_cast<VertexId>(v)))
      if (edges.uses(e.to, static_cast<VertexId>(v)).empty() && (out[v] == kNone || out[v] < e.slot))
        out[v] = e.slot;
  });

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

Components componentsOf(std::size_t vertexCount, std::span<const Triangle> triangles, int threads) {
  UnionFind vertices(vertexCount);
  vertices.joinAll(2 * triangles.size(), threads, [&](std::size_t i) {
    const Triangle& t = triangles[i / 2];
    return std::pair(t[0], t[1 + i % 2]);
  });
  const std::vector<std::uint32_t> root = vertices.roots(threads);
  Components result;
  result.ofTriangle.resize(triangles.size());
  std::vector<std::uint32_t> number(vertexCount, kNone);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::uint32_t& n = number[root[triangles[t][0]]];
    if (n == kNone) n = result.count++;
    result.ofTriangle[t] = n;
  }
  return result;
}

}  // namespace thicken::mesh
