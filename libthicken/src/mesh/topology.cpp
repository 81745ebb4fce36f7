// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/topology.h"

#include <algorithm>
#include <numeric>

namespace thicken {
namespace {

struct HalfEdge {
  VertexId to;
  std::uint32_t slot;  // 3 · triangle + corner
};

// Half-edges in buckets of their first vertex, each bucket sorted by the second, so that a vertex of
// very many triangles costs no more than n log n.
class HalfEdges {
 public:
  HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles)
      : offset_(vertexCount + 1, 0), edges_(3 * triangles.size()) {
    for (const Triangle& t : triangles)
      for (const VertexId v : t) ++offset_[v + 1];
    std::partial_sum(offset_.begin(), offset_.end(), offset_.begin());
    std::vector<std::uint32_t> next(offset_.begin(), offset_.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k)
        edges_[next[triangles[t][k]]++] = {triangles[t][(k + 1) % 3], 3 * t + k};
    const auto before = [](const HalfEdge& a, const HalfEdge& b) {
      return a.to != b.to ? a.to < b.to : a.slot < b.slot;
    };
    for (std::size_t v = 0; v < vertexCount; ++v)
      std::sort(edges_.begin() + offset_[v], edges_.begin() + offset_[v + 1], before);
  }

  // The first slot that uses the edge in this direction, or kNone.
  [[nodiscard]] std::uint32_t find(VertexId from, VertexId to) const {
    const auto end = edges_.begin() + offset_[from + 1];
    const auto it = std::lower_bound(edges_.begin() + offset_[from], end, to,
                                     [](const HalfEdge& e, VertexId v) { return e.to < v; });
    return it != end && it->to == to ? it->slot : kNone;
  }

 private:
  std::vector<std::uint32_t> offset_;
  std::vector<HalfEdge> edges_;
};

}  // namespace

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
                                                  std::span<const Triangle> triangles) {
  const HalfEdges edges(vertexCount, triangles);
  std::vector<std::array<TriangleId, 3>> result(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t slot = edges.find(triangles[t][(k + 1) % 3], triangles[t][k]);
      result[t][k] = slot == kNone ? kNone : slot / 3;
    }
  }
  return result;
}

Rim rimOf(std::size_t vertexCount, std::span<const Triangle> triangles) {
  const HalfEdges edges(vertexCount, triangles);
  std::vector<std::uint32_t> out(vertexCount, kNone);  // the rim edge that leaves a vertex, as a slot
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (edges.find(triangles[t][(k + 1) % 3], triangles[t][k]) == kNone) out[triangles[t][k]] = 3 * t + k;

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
  std::vector<VertexId> up(vertexCount);
  std::iota(up.begin(), up.end(), 0u);
  const auto root = [&up](VertexId v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  for (const Triangle& t : triangles) {
    for (int k = 1; k < 3; ++k) {
      const VertexId a = root(t[0]), b = root(t[k]);
      up[std::max(a, b)] = std::min(a, b);
    }
  }
  Components result;
  result.ofTriangle.resize(triangles.size());
  std::vector<std::uint32_t> number(vertexCount, kNone);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    std::uint32_t& n = number[root(triangles[t][0])];
    if (n == kNone) n = result.count++;
    result.ofTriangle[t] = n;
  }
  return result;
}

}  // namespace thicken
