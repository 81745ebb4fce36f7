// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/findings.h"

#include <algorithm>
#include <numeric>

#include "exact/predicates.h"
#include "mesh/topology.h"
#include "mesh/union_find.h"
#include "parallel_for.h"

namespace thicken {
namespace {

bool repeatsCorner(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Triangles with the same three vertices, in either sense: found by sorting them in buckets of their
// smallest vertex.
std::vector<std::pair<TriangleId, TriangleId>> duplicates(const TriangleMesh& mesh,
                                                          std::span<const std::uint8_t> joined) {
  struct Key {
    VertexId middle, largest;
    TriangleId id;
    bool operator<(const Key& o) const {
      return middle != o.middle ? middle < o.middle : largest != o.largest ? largest < o.largest : id < o.id;
    }
  };
  const auto sortedCorners = [&mesh](TriangleId t) {
    Triangle c = mesh.triangles[t];
    std::sort(c.begin(), c.end());
    return c;
  };
  std::vector<std::uint32_t> offset(mesh.positions.size() + 1, 0);
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
    if (joined[t] != 0) ++offset[sortedCorners(t)[0] + 1];
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<Key> keys(offset.back());
  std::vector<std::uint32_t> next(offset.begin(), offset.end() - 1);
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    if (joined[t] == 0) continue;
    const Triangle c = sortedCorners(t);
    keys[next[c[0]]++] = {c[1], c[2], t};
  }

  std::vector<std::pair<TriangleId, TriangleId>> result;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::span<Key> bucket = std::span(keys).subspan(offset[v], offset[v + 1] - offset[v]);
    std::sort(bucket.begin(), bucket.end());
    std::size_t first = 0;
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].middle == bucket[first].middle && bucket[i].largest == bucket[first].largest)
        result.emplace_back(bucket[first].id, bucket[i].id);
      else
        first = i;
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// A vertex is pinched when the corners at it, joined across every edge that they share, remain in
// more than one group.
std::vector<VertexId> pinchedVertices(const TriangleMesh& mesh, const HalfEdges& edges) {
  UnionFind corners(3 * mesh.triangles.size());
  const auto next = [](std::uint32_t slot) { return slot % 3 == 2 ? slot - 2 : slot + 1; };
  edges.forEachEdge([&](VertexId, VertexId, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
    const std::uint32_t atFrom = uses[0].slot, atTo = next(uses[0].slot);
    for (const HalfEdge& e : uses.subspan(1)) {
      corners.join(atFrom, e.slot);
      corners.join(atTo, next(e.slot));
    }
    for (const HalfEdge& e : back) {
      corners.join(atFrom, next(e.slot));
      corners.join(atTo, e.slot);
    }
  });
  std::vector<VertexId> result;
  for (VertexId v = 0; v < mesh.positions.size(); ++v) {
    const std::span<const HalfEdge> leaving = edges.from(v);
    for (std::size_t i = 1; i < leaving.size(); ++i) {
      if (corners.root(leaving[i].slot) == corners.root(leaving[0].slot)) continue;
      result.push_back(v);
      break;
    }
  }
  return result;
}

}  // namespace

BadTriangles badTriangles(const TriangleMesh& mesh, bool finite, const RunContext& context, int threads) {
  BadTriangles bad;
  const std::size_t count = mesh.triangles.size();
  bad.joined.resize(count);
  bad.proper.resize(count);
  parallelFor(count, threads, context, 4096, [&](std::size_t i) {
    const Triangle& t = mesh.triangles[i];
    const auto& p = mesh.positions;
    bad.joined[i] = !repeatsCorner(t);
    bad.proper[i] = bad.joined[i] != 0 && !(finite && exact::collinear(p[t[0]], p[t[1]], p[t[2]]));
  });
  for (TriangleId t = 0; t < count; ++t)
    if (bad.proper[t] == 0) bad.withoutArea.push_back(t);
  bad.duplicates = duplicates(mesh, bad.joined);
  for (const auto& [first, later] : bad.duplicates) bad.joined[later] = bad.proper[later] = 0;
  return bad;
}

BadJoints badJoints(const TriangleMesh& mesh, const HalfEdges& edges) {
  BadJoints bad;
  edges.forEachEdge(
      [&bad](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
        const std::size_t all = uses.size() + back.size();
        if (all > 2)
          bad.crowded.push_back({a, b});
        else if (all == 1)
          bad.rim.push_back({a, b});
        else if (back.empty())
          bad.sameSense.push_back({a, b});
      });
  bad.pinched = pinchedVertices(mesh, edges);
  return bad;
}

}  // namespace thicken
