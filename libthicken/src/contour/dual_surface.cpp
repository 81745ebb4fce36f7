// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/dual_surface.h"

#include <algorithm>
#include <numeric>

#include "contour/face_matching.h"
#include "mesh/parallel_sort.h"
#include "mesh/topology.h"
#include "mesh/union_find.h"

namespace thicken {

namespace {

class Builder {
 public:
  Builder(const std::vector<Crossing>& crossings, const std::vector<RimWay>& ways, const UniformGrid& grid,
          std::span<const Vec3> positions, int threads)
      : threads_(threads),
        crossings_(crossings),
        ways_(ways),
        grid_(grid),
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
    arcs_ = matchFaces(crossings_, passages_, threads_);
    joinSectors();
    numberVertices();
    divideDoubledEdges();
    makeFaces();
    makeStops();
    listCrossings();
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
    for (const auto& [a, b] : arcs_)
      for (const bool upper : {false, true}) union_.join(beside(a, upper), beside(b, upper));
    std::uint32_t p = 0;
    for (const RimWay& way : ways_) {
      if (way.size() == 1) continue;
      const auto n = static_cast<std::uint32_t>(way.size());
      for (std::uint32_t i = 0; i < n; ++i)
        union_.join(sideOf(p + (i + n - 1) % n, true), sideOf(p + i, false));
      p += n;
    }
  }

  void numberVertices() {
    vertexOf_.assign(loneLoop(lone_), kNone);
    for (std::uint32_t e = 0; e < vertexOf_.size(); ++e) {
      VertexId& v = vertexOf_[union_.root(e)];
      if (v == kNone) {
        v = static_cast<VertexId>(out_.cell.size());
        out_.cell.push_back({});
      }
      vertexOf_[e] = v;
    }
    for (std::uint32_t c = 0; c < crossingCount_; ++c)
      for (int k = 0; k < 4; ++k) {
        const std::uint64_t edge = crossings_[c].edge;
        const GridIndex n = UniformGrid::indexOf(edge >> 2), o = sectorOffset(static_cast<int>(edge & 3), k);
        out_.cell[vertexOf_[sector(c, static_cast<std::uint32_t>(k))]] = {n[0] + o[0], n[1] + o[1],
                                                                          n[2] + o[2]};
      }
    std::uint32_t p = 0, loop = 0;
    for (const RimWay& way : ways_)
      for (const RimVisit& visit : way)
        out_.cell[vertexOf_[way.size() == 1 ? loneLoop(loop++) : sideOf(p++, false)]] = visit.cell;
    out_.onEdge.assign(out_.cell.size(), 0);
  }

  // Two arcs in one face that join the same two vertices would be one edge: each gets a vertex.
  void divideDoubledEdges() {
    onArcEnd_.assign(4 * crossingCount_ + passages_.size(), kNone);
    struct Dual {
      VertexId a, b;
      std::uint32_t arc;
    };
    std::vector<Dual> duals(arcs_.size());
    for (std::uint32_t i = 0; i < arcs_.size(); ++i)
      duals[i] = {vertexOf_[beside(arcs_[i].first, false)], vertexOf_[beside(arcs_[i].first, true)], i};
    parallelSort(
        duals,
        [](const Dual& x, const Dual& y) {
          return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.arc < y.arc;
        },
        threads_);
    const auto same = [&](std::size_t i, std::size_t j) {
      return j < duals.size() && duals[i].a == duals[j].a && duals[i].b == duals[j].b;
    };
    for (std::size_t i = 0; i < duals.size(); ++i) {
      if (!same(i, i + 1) && (i == 0 || !same(i, i - 1))) continue;
      const Arc& arc = arcs_[duals[i].arc];
      onArcEnd_[arc.first] = onArcEnd_[arc.second] = static_cast<VertexId>(out_.cell.size());
      edgePlaces_.push_back((placeOf(arc.first) + placeOf(arc.second)) / 2);
      out_.cell.push_back(out_.cell[duals[i].a]);
      out_.onEdge.push_back(1);
    }
    out_.vertexCount = out_.cell.size();
  }

  [[nodiscard]] const Vec3& placeOf(std::uint32_t end) const {
    return end < 4 * crossingCount_ ? crossings_[end / 4].at : passages_[end - 4 * crossingCount_].at;
  }

  void makeFaces() {
    out_.faces.resize(crossingCount_);
    out_.shared.assign(crossingCount_, 0);
    for (std::uint32_t c = 0; c < crossingCount_; ++c) {
      std::vector<VertexId>& face = out_.faces[c];
      for (std::uint32_t k = 0; k < 4; ++k) {
        face.push_back(vertexOf_[sector(c, k)]);
        if (onArcEnd_[sector(c, k)] != kNone) face.push_back(onArcEnd_[sector(c, k)]);
      }
      if (crossings_[c].jump > 0) std::reverse(face.begin(), face.end());
      const bool before = c > 0 && crossings_[c - 1].edge == crossings_[c].edge;
      const bool after = c + 1 < crossingCount_ && crossings_[c + 1].edge == crossings_[c].edge;
      out_.shared[c] = before || after;
    }
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
        stops.push_back({vertexOf_[sideOf(p, false)], onArcEnd_[4 * crossingCount_ + p]});
    }
  }

  void listCrossings() {
    out_.crossingOffset.assign(out_.vertexCount + 1, 0);
    for (std::uint32_t e = 0; e < 4 * crossingCount_; ++e) ++out_.crossingOffset[vertexOf_[e] + 1];
    std::partial_sum(out_.crossingOffset.begin(), out_.crossingOffset.end(), out_.crossingOffset.begin());
    out_.crossingsOf.resize(4 * crossingCount_);
    std::vector<std::uint32_t> next(out_.crossingOffset.begin(), out_.crossingOffset.end() - 1);
    for (std::uint32_t e = 0; e < 4 * crossingCount_; ++e) out_.crossingsOf[next[vertexOf_[e]]++] = e / 4;
  }

  // The mean of a component's crossings; of the rim's own places where it has none.
  void placeStart() {
    out_.start.assign(out_.vertexCount, Vec3::Zero());
    std::vector<Vec3> rimSum(out_.vertexCount, Vec3::Zero());
    std::vector<double> rimCount(out_.vertexCount, 0);
    const auto addRim = [&](VertexId v, const Vec3& p) {
      rimSum[v] += p;
      ++rimCount[v];
    };
    for (std::size_t l = 0; l < ways_.size(); ++l)
      for (std::size_t i = 0; i < ways_[l].size(); ++i) {
        const VertexId here = out_.stops[l][i].vertex;
        for (const VertexId v : ways_[l][i].vertices) addRim(here, positions_[v]);
        if (ways_[l].size() == 1) continue;
        addRim(here, ways_[l][i].exit.at);
        addRim(out_.stops[l][(i + 1) % ways_[l].size()].vertex, ways_[l][i].exit.at);
      }
    for (VertexId v = 0; v < out_.vertexCount; ++v) {
      const std::uint32_t begin = out_.crossingOffset[v], end = out_.crossingOffset[v + 1];
      if (out_.onEdge[v]) {
        out_.start[v] = edgePlaces_[v - (out_.vertexCount - edgePlaces_.size())];
        continue;
      }
      for (std::uint32_t i = begin; i < end; ++i) out_.start[v] += crossings_[out_.crossingsOf[i]].at;
      if (end > begin)
        out_.start[v] /= end - begin;
      else if (rimCount[v] > 0)
        out_.start[v] = rimSum[v] / rimCount[v];
    }
  }

  int threads_;
  const std::vector<Crossing>& crossings_;
  const std::vector<RimWay>& ways_;
  const UniformGrid& grid_;
  std::span<const Vec3> positions_;
  std::uint32_t crossingCount_;
  std::uint32_t lone_ = 0;
  std::vector<RimPassage> passages_;
  std::vector<Arc> arcs_;
  UnionFind union_{0};
  std::vector<VertexId> vertexOf_;
  std::vector<VertexId> onArcEnd_;
  std::vector<Vec3> edgePlaces_;
  DualSurface out_;
};

}  // namespace

DualSurface dualSurface(const std::vector<Crossing>& crossings, const std::vector<RimWay>& ways,
                        const UniformGrid& grid, std::span<const Vec3> positions, int threads) {
  return Builder(crossings, ways, grid, positions, threads).build();
}

}  // namespace thicken
