// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "contour/face_matching.h"
#include "mesh/buckets.h"
#include "mesh/topology.h"
#include "mesh/union_find.h"

namespace thicken::contour {

using mesh::kNone;
using mesh::UnionFind;
using parallel::parallelFor;
using parallel::parallelForParts;

namespace {

class Builder {
 public:
  Builder(const std::vector<Crossing>& crossings, const std::vector<RimWay>& ways,
          std::span<const Vec3> positions, int threads)
      : threads_(threads),
        crossings_(crossings),
        ways_(ways),
        positions_(positions),
        crossingCount_(static_cast<std::uint32_t>(crossings.size())) {
    for (const RimWay& way : ways_) {
      if (way.size() == 1) {
        ++lone_;
        continue;
      }
      for (const RimVisit& visit : way) passages_.push_back(visit.exit);
    }
  }

  DualSurface build() {
    joinSectors();
    numberVertices();
    divideDoubledEdges();
    makeFaces();
    makeStops();
    listCrossings();
    vertexOf_ = std::vector<VertexId>();
    placeStart();
    return std::move(out_);
  }

 private:
  // Elements of the union: four sectors a crossing, two sides a passage, one a lone loop.
  [[nodiscard]] std::uint32_t sector(std::uint32_t crossing, std::uint32_t k) const {
    return 4 * crossing + k;
  }
  [[nodiscard]] std::uint32_t sideOf(std::uint32_t passage, bool after) const {
    return 4 * crossingCount_ + 2 * passage + (after ? 1 : 0);
  }
  [[nodiscard]] std::uint32_t loneLoop(std::uint32_t i) const {
    return static_cast<std::uint32_t>(4 * crossingCount_ + 2 * passages_.size() + i);
  }

  // The element of an arc's end on the lower or upper side of the face.
  [[nodiscard]] std::uint32_t beside(std::uint32_t end, bool upper) const {
    if (end >= 4 * crossingCount_) {
      const std::uint32_t p = end - 4 * crossingCount_;
      return sideOf(p, upper == (passages_[p].sign > 0));
    }
    constexpr std::uint32_t kUpper[4] = {0, 1, 3, 0}, kLower[4] = {1, 2, 2, 3};
    const std::uint32_t k = end % 4;
    return sector(end / 4, upper ? kUpper[k] : kLower[k]);
  }

  void joinSectors() {
    union_ = UnionFind(loneLoop(lone_));
    const bool shared = parallel::threadCount(threads_) > 1;
    together_ = matchFaces(crossings_, passages_, threads_, [&](std::span<const Arc> arcs) {
      for (const auto& [a, b] : arcs)
        for (const bool upper : {false, true})
          shared ? union_.joinShared(beside(a, upper), beside(b, upper))
                 : union_.join(beside(a, upper), beside(b, upper));
    });
    std::uint32_t p = 0;
    for (const RimWay& way : ways_) {
      if (way.size() == 1) continue;
      const auto n = static_cast<std::uint32_t>(way.size());
      for (std::uint32_t i = 0; i < n; ++i)
        union_.join(sideOf(p + (i + n - 1) % n, true), sideOf(p + i, false));
      p += n;
    }
  }

  // In the order of the components' first elements, which are their roots.
  void numberVertices() {
    const std::vector<std::uint32_t> root = union_.roots(threads_);
    union_ = UnionFind();
    std::vector<std::uint32_t> first((root.size() + kPart - 1) / kPart + 1, 0);
    parallelForParts(root.size(), threads_, RunContext(), kPart,
                     [&](std::size_t part, std::size_t begin, std::size_t end) {
                       for (std::size_t e = begin; e < end; ++e) first[part + 1] += root[e] == e;
                     });
    std::partial_sum(first.begin(), first.end(), first.begin());
    out_.vertexCount = first.back();
    vertexOf_.resize(root.size());
    parallelForParts(root.size(), threads_, RunContext(), kPart,
                     [&](std::size_t part, std::size_t begin, std::size_t end) {
                       VertexId v = first[part];
                       for (std::size_t e = begin; e < end; ++e)
                         if (root[e] == e) vertexOf_[e] = v++;
                     });
    parallelFor(root.size(), threads_, RunContext(), kPart, [&](std::size_t e) {
      if (root[e] != e) vertexOf_[e] = vertexOf_[root[e]];
    });
  }

  // Two arcs in one face that join the same two vertices would be one edge: each gets a vertex.
  void divideDoubledEdges() {
    struct Dual {
      VertexId a, b;
      std::uint32_t arc;
    };
    std::vector<Dual> duals;
    for (std::uint32_t i = 0; i < together_.size(); ++i) {
      const std::uint32_t end = together_[i].first;
      duals.push_back({vertexOf_[beside(end, false)], vertexOf_[beside(end, true)], i});
    }
    std::sort(duals.begin(), duals.end(), [](const Dual& x, const Dual& y) {
      return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.arc < y.arc;
    });
    const auto same = [&](std::size_t i, std::size_t j) {
      return j < duals.size() && duals[i].a == duals[j].a && duals[i].b == duals[j].b;
    };
    for (std::size_t i = 0; i < duals.size(); ++i) {
      if (!same(i, i + 1) && (i == 0 || !same(i, i - 1))) continue;
      const Arc& arc = together_[duals[i].arc];
      if (onArcEnd_.empty()) onArcEnd_.assign(4 * crossingCount_ + passages_.size(), kNone);
      onArcEnd_[arc.first] = onArcEnd_[arc.second] = static_cast<VertexId>(out_.vertexCount++);
      edgePlaces_.push_back((placeOf(arc.first) + placeOf(arc.second)) / 2);
    }
  }

  // The vertex of a doubled dual edge; most surfaces have none.
  [[nodiscard]] VertexId onArcEnd(std::uint32_t end) const {
    return onArcEnd_.empty() ? kNone : onArcEnd_[end];
  }

  [[nodiscard]] const Vec3& placeOf(std::uint32_t end) const {
    return end < 4 * crossingCount_ ? crossings_[end / 4].at : passages_[end - 4 * crossingCount_].at;
  }

  void makeFaces() {
    out_.shared.resize(crossingCount_);
    std::vector<std::uint8_t> corners(crossingCount_, 4);
    parallelFor(crossingCount_, threads_, RunContext(), kPart, [&](std::size_t i) {
      const auto c = static_cast<std::uint32_t>(i);
      for (std::uint32_t k = 0; k < 4; ++k) corners[c] += onArcEnd(sector(c, k)) != kNone;
      const bool before = c > 0 && crossings_[c - 1].edge == crossings_[c].edge;
      const bool after = c + 1 < crossingCount_ && crossings_[c + 1].edge == crossings_[c].edge;
      out_.shared[c] = before || after;
    });
    out_.faces.resize(corners);
    parallelFor(crossingCount_, threads_, RunContext(), kPart, [&](std::size_t i) {
      const auto c = static_cast<std::uint32_t>(i);
      const std::span<VertexId> face = out_.faces[c];
      auto corner = face.begin();
      for (std::uint32_t k = 0; k < 4; ++k) {
        *corner++ = vertexOf_[sector(c, k)];
        if (const VertexId v = onArcEnd(sector(c, k)); v != kNone) *corner++ = v;
      }
      if (crossings_[c].jump > 0) std::reverse(face.begin(), face.end());
    });
  }

  void makeStops() {
    std::uint32_t p = 0, loop = 0;
    for (const RimWay& way : ways_) {
      auto& stops = out_.stops.emplace_back();
      if (way.size() == 1) {
        stops.push_back({vertexOf_[loneLoop(loop++)], kNone});
        continue;
      }
      for (std::size_t i = 0; i < way.size(); ++i, ++p)
        stops.push_back({vertexOf_[sideOf(p, false)], onArcEnd(4 * crossingCount_ + p)});
    }
  }

  void listCrossings() {
    auto around = mesh::intoBuckets<std::uint32_t>(crossingCount_, out_.vertexCount, threads_,
                                                   [&](std::size_t i, const auto& put) {
                                                     const auto c = static_cast<std::uint32_t>(i);
                                                     for (std::uint32_t k = 0; k < 4; ++k)
                                                       put(vertexOf_[sector(c, k)], c);
                                                   });
    out_.crossingOffset = std::move(around.offset);
    out_.crossingsOf = std::move(around.values);
  }

  // The mean of a component's crossings; of the rim's own places where it has none.
  void placeStart() {
    out_.start.resize(out_.vertexCount);
    parallelFor(out_.vertexCount, threads_, RunContext(), kPart, [&](std::size_t v) {
      const std::uint32_t begin = out_.crossingOffset[v], end = out_.crossingOffset[v + 1];
      Vec3 sum = Vec3::Zero();
      for (std::uint32_t i = begin; i < end; ++i) sum += crossings_[out_.crossingsOf[i]].at;
      if (end > begin) sum /= end - begin;
      out_.start[v] = sum;
    });
    for (const auto& [v, rim] : rimMeans())
      if (out_.crossingOffset[v] == out_.crossingOffset[v + 1]) out_.start[v] = rim.sum / rim.count;
    std::copy(edgePlaces_.begin(), edgePlaces_.end(), out_.start.end() - std::ssize(edgePlaces_));
  }

  struct Mean {
    Vec3 sum = Vec3::Zero();
    double count = 0;
  };
  // Of the rim's places in the cell of each vertex that it passes.
  [[nodiscard]] std::unordered_map<VertexId, Mean> rimMeans() const {
    std::unordered_map<VertexId, Mean> means;
    const auto add = [&](VertexId v, const Vec3& p) {
      Mean& mean = means[v];
      mean.sum += p;
      ++mean.count;
    };
    for (std::size_t l = 0; l < ways_.size(); ++l)
      for (std::size_t i = 0; i < ways_[l].size(); ++i) {
        const VertexId here = out_.stops[l][i].vertex;
        for (const VertexId v : ways_[l][i].vertices) add(here, positions_[v]);
        if (ways_[l].size() == 1) continue;
        add(here, ways_[l][i].exit.at);
        add(out_.stops[l][(i + 1) % ways_[l].size()].vertex, ways_[l][i].exit.at);
      }
    return means;
  }

  static constexpr std::size_t kPart = 1 << 13;  // of a range that is shared out among threads

  int threads_;
  const std::vector<Crossing>& crossings_;
  const std::vector<RimWay>& ways_;
  std::span<const Vec3> positions_;
  std::uint32_t crossingCount_;
  std::uint32_t lone_ = 0;
  std::vector<RimPassage> passages_;
  std::vector<Arc> together_;  ///< that share their face with others
  UnionFind union_{0};
  std::vector<VertexId> vertexOf_;
  std::vector<VertexId> onArcEnd_;  ///< empty: no dual edge is doubled
  std::vector<Vec3> edgePlaces_;
  DualSurface out_;
};

}  // namespace

DualSurface dualSurface(const std::vector<Crossing>& crossings, const std::vector<RimWay>& ways,
                        std::span<const Vec3> positions, int threads) {
  return Builder(crossings, ways, positions, threads).build();
}

}  // namespace thicken::contour
