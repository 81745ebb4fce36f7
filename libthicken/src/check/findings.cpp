// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/findings.h"

#include <algorithm>

#include "exact/predicates.h"
#include "mesh/buckets.h"
#include "mesh/topology.h"
#include "mesh/union_find.h"
#include "parallel/parallel_for.h"

namespace thicken::checking {

using mesh::HalfEdge;
using parallel::parallelFor;

namespace {

bool repeatsCorner(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

// Triangles with the same three vertices, in either sense: found by sorting them in buckets of their
// smallest vertex.
std::vector<std::pair<TriangleId, TriangleId>> duplicates(const TriangleMesh& mesh,
                                                          std::span<const std::uint8_t> joined,
                                                          const RunContext& context, int threads) {
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
  auto sorted = mesh::intoBuckets<Key>(mesh.triangles.size(), mesh.positions.size(), threads,
                                       [&](std::size_t i, const auto& put) {
                                         const auto t = static_cast<TriangleId>(i);
                                         if (joined[t] == 0) return;
                                         const Triangle c = sortedCorners(t);
                                         put(c[0], Key{c[1], c[2], t});
                                       });
  constexpr std::size_t kBlock = 4096;
  std::vector<std::vector<std::pair<TriangleId, TriangleId>>> parts((mesh.positions.size() + kBlock - 1) /
                                                                    kBlock);
  parallelFor(mesh.positions.size(), threads, context, kBlock, [&](std::size_t v) {
    const std::span<Key> bucket =
        std::span(sorted.values).subspan(sorted.offset[v], sorted.offset[v + 1] - sorted.offset[v]);
    std::sort(bucket.begin(), bucket.end());
    std::size_t first = 0;
    for (std::size_t i = 1; i < bucket.size(); ++i) {
      if (bucket[i].middle == bucket[first].middle && bucket[i].largest == bucket[first].largest)
        parts[v / kBlock].emplace_back(bucket[first].id, bucket[i].id);
      else
        first = i;
    }
  });
  std::vector<std::pair<TriangleId, TriangleId>> result;
  for (const auto& part : parts) append(result, part);
  std::sort(result.begin(), result.end());
  return result;
}

// Whether the corners at a vertex, joined across every edge that they share, remain in more than one group.
class FanCount {
 public:
  explicit FanCount(const TriangleMesh& mesh) : mesh_(mesh) {}

  bool operator()(std::span<const HalfEdge> leaving) {
    if (leaving.size() < 2 || goesRoundOnce(leaving)) return false;
    ends_.clear();
    for (std::uint32_t i = 0; i < leaving.size(); ++i) {
      ends_.emplace_back(leaving[i].to, i);
      ends_.emplace_back(otherEnd(leaving[i]), i);
    }
    std::sort(ends_.begin(), ends_.end());
    corners_.reset(leaving.size());
    std::size_t groups = leaving.size();
    for (std::size_t i = 1; i < ends_.size(); ++i)
      if (ends_[i].first == ends_[i - 1].first &&
          corners_.root(ends_[i].second) != corners_.root(ends_[i - 1].second)) {
        corners_.join(ends_[i].second, ends_[i - 1].second);
        --groups;
      }
    return groups > 1;
  }

 private:
  // Each corner's other end.
  [[nodiscard]] VertexId otherEnd(const HalfEdge& e) const {
    return mesh_.triangles[e.triangle()][(e.corner() + 2) % 3];
  }

  // Whether all corners follow on each other, the last one on the first: what nearly every vertex is like.
  [[nodiscard]] bool goesRoundOnce(std::span<const HalfEdge> leaving) const {
    constexpr std::size_t kMost = 24;  // of more the search for the next takes too long
    if (leaving.size() > kMost) return false;
    std::size_t at = 0;
    for (std::size_t steps = 1; steps <= leaving.size(); ++steps) {
      const VertexId end = otherEnd(leaving[at]);
      at = static_cast<std::size_t>(std::ranges::find(leaving, end, [](const HalfEdge& e) { return e.to; }) -
                                    leaving.begin());
      if (at == leaving.size()) return false;
      if (at == 0) return steps == leaving.size();
    }
    return false;
  }

  const TriangleMesh& mesh_;
  mesh::UnionFind corners_;
  std::vector<std::pair<VertexId, std::uint32_t>> ends_;  ///< other end of an edge, number of a corner
};

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
  bad.duplicates = duplicates(mesh, bad.joined, context, threads);
  for (const auto& [first, later] : bad.duplicates) bad.joined[later] = bad.proper[later] = 0;
  return bad;
}

BadJoints badJoints(const TriangleMesh& mesh, const mesh::HalfEdges& edges, const RunContext& context,
                    int threads) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t count = mesh.positions.size(), blocks = (count + kBlock - 1) / kBlock;
  std::vector<BadJoints> parts(blocks);
  parallelFor(blocks, threads, context, 1, [&](std::size_t block) {
    BadJoints& bad = parts[block];
    FanCount hasManyFans(mesh);
    const auto judge = [&bad](VertexId a, VertexId b, std::span<const HalfEdge> uses,
                              std::span<const HalfEdge> back) {
      const std::size_t all = uses.size() + back.size();
      if (all > 2)
        bad.nonManifoldEdges.push_back({a, b});
      else if (all == 1)
        bad.rim.push_back({a, b});
      else if (back.empty())
        bad.sameSense.push_back({a, b});
    };
    const std::size_t end = std::min(count, (block + 1) * kBlock);
    for (auto v = static_cast<VertexId>(block * kBlock); v < end; ++v) {
      edges.forEachEdgeOf(v, judge);
      if (hasManyFans(edges.from(v))) bad.nonManifoldVertices.push_back(v);
    }
  });
  BadJoints all;
  for (const BadJoints& part : parts) {
    append(all.rim, part.rim);
    append(all.nonManifoldEdges, part.nonManifoldEdges);
    append(all.sameSense, part.sameSense);
    append(all.nonManifoldVertices, part.nonManifoldVertices);
  }
  return all;
}

}  // namespace thicken::checking
