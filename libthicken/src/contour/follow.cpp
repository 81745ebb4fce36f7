// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/follow.h"

#include <algorithm>

#include "contour/face_matching.h"
#include "mesh/parallel_sort.h"
#include "parallel_for.h"

namespace thicken {

namespace {

// Cells are visited in waves, so that each wave's nodes are evaluated on all threads.
class Follower {
 public:
  Follower(const UniformGrid& grid, const CrossedEdges& carrier, const Membership& membership,
           NodeField& field, const RunContext& context, int threads)
      : grid_(grid),
        carrier_(carrier),
        membership_(membership),
        field_(field),
        context_(context),
        threads_(threads) {}

  std::vector<Crossing> run(std::span<const GridIndex> rimCells, const Seeds& seeds) {
    followFrom(rimCells);
    std::vector<GridIndex> further;
    for (const Vec3& p : placed(seeds)) further.push_back(cellOf(p));
    followFrom(further);
    return sorted();
  }

 private:
  void followFrom(std::span<const GridIndex> cells) {
    for (const GridIndex& cell : cells) addCell(UniformGrid::key(cell));
    follow();
    // The contour may pass a cell by that holds a point next to it.
    for (const GridIndex& cell : cells)
      if (!isCrossed(cell)) enterNeighbours(cell);
    follow();
  }

  // The seeds that the contour has not come by yet.
  [[nodiscard]] std::vector<Vec3> placed(const Seeds& seeds) const {
    std::vector<Vec3> points;
    for (const Vec3& p : seeds.points)
      if (!isCrossed(cellOf(p))) points.push_back(p);
    parallelFor(points.size(), threads_, context_, 256,
                [&](std::size_t i) { points[i] = seeds.toContour(points[i]); });
    return points;
  }

  [[nodiscard]] GridIndex cellOf(const Vec3& p) const {
    return {grid_.indexBelow(0, p.x()), grid_.indexBelow(1, p.y()), grid_.indexBelow(2, p.z())};
  }

  [[nodiscard]] bool isCrossed(const GridIndex& cell) const {
    const std::uint32_t i = cells_.find(UniformGrid::key(cell));
    return i != BlockIndex::kAbsent && crossed_[i] != 0;
  }

  std::uint32_t addCell(std::uint64_t key) {
    const auto [i, isNew] = cells_.insert(key);
    if (isNew) crossed_.push_back(0);
    return i;
  }

  void follow() {
    while (done_ < cells_.size()) {
      const std::size_t end = cells_.size();
      field_.countCells(end - done_);
      for (; done_ < end; ++done_) enter(UniformGrid::indexOf(cells_.keys()[done_]));
      field_.evaluate(membership_, context_, threads_);
      examine();
    }
  }

  void enterNeighbours(const GridIndex& cell) {
    for (int c = 0; c < 27; ++c)
      addCell(UniformGrid::key({cell[0] + c % 3 - 1, cell[1] + c / 3 % 3 - 1, cell[2] + c / 9 - 1}));
  }

  // Lists the cell's nodes and edges that no cell before it had.
  void enter(const GridIndex& cell) {
    std::array<std::uint32_t, 8> corner{};
    for (int c = 0; c < 8; ++c) corner[c] = field_.want(nodeOf(cell, c));
    listed_.resize(field_.size(), 0);
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < 8; ++c) {
        std::uint8_t& listed = listed_[corner[c]];
        if ((c >> axis & 1) || (listed >> axis & 1)) continue;
        listed |= static_cast<std::uint8_t>(1 << axis);
        edges_.push_back({corner[c], corner[c | (1 << axis)], axis});
      }
  }

  void examine() {
    constexpr std::size_t kGrain = 256;
    std::vector<std::vector<Crossing>> parts((edges_.size() + kGrain - 1) / kGrain);
    parallelFor(edges_.size(), threads_, context_, kGrain, [&](std::size_t i) {
      const Edge& e = edges_[i];
      const std::uint64_t key = UniformGrid::key(UniformGrid::indexOf(field_.key(e.low)), e.axis);
      crossEdge(grid_, field_, key, e.low, e.high, carrier_.of(key), parts[i / kGrain]);
    });
    for (auto& part : parts) {
      for (const Crossing& c : part)
        for (int k = 0; k < 4; ++k) crossed_[addCell(cellAround(c.edge, k))] = 1;
      if (!part.empty()) found_.push_back(std::move(part));
    }
    edges_.clear();
  }

  // All that was found, in order. What is sorted is a fraction of what a crossing holds.
  [[nodiscard]] std::vector<Crossing> sorted() const {
    struct Place {
      std::uint64_t edge;
      double from;
      const Crossing* crossing;
    };
    std::vector<std::size_t> first{0};
    for (const auto& part : found_) first.push_back(first.back() + part.size());
    std::vector<Place> places(first.back());
    parallelFor(found_.size(), threads_, context_, 64, [&](std::size_t i) {
      for (std::size_t k = 0; k < found_[i].size(); ++k)
        places[first[i] + k] = {found_[i][k].edge, found_[i][k].from, &found_[i][k]};
    });
    parallelSort(
        places,
        [](const Place& a, const Place& b) { return a.edge != b.edge ? a.edge < b.edge : a.from < b.from; },
        threads_);
    std::vector<Crossing> all(places.size());
    parallelFor(all.size(), threads_, context_, 4096, [&](std::size_t i) { all[i] = *places[i].crossing; });
    return all;
  }

  // Corner c of a cell.
  [[nodiscard]] static std::uint64_t nodeOf(const GridIndex& cell, int c) {
    return UniformGrid::key({cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)});
  }

  // The cell in sector k of an edge.
  [[nodiscard]] static std::uint64_t cellAround(std::uint64_t edge, int k) {
    const GridIndex n = UniformGrid::indexOf(edge >> 2), o = sectorOffset(static_cast<int>(edge & 3), k);
    return UniformGrid::key({n[0] + o[0], n[1] + o[1], n[2] + o[2]});
  }

  struct Edge {
    std::uint32_t low, high;  ///< nodes
    int axis;
  };

  const UniformGrid& grid_;
  const CrossedEdges& carrier_;
  const Membership& membership_;
  NodeField& field_;
  const RunContext& context_;
  int threads_;
  BlockIndex cells_;
  std::vector<std::uint8_t> crossed_;  ///< per cell
  std::size_t done_ = 0;               ///< cells
  std::vector<std::uint8_t> listed_;   ///< per node, a bit for each axis: its edge is in edges_
  std::vector<Edge> edges_;            ///< of the wave
  std::vector<std::vector<Crossing>> found_;
};

}  // namespace

std::vector<Crossing> followContour(const UniformGrid& grid, std::span<const GridIndex> rimCells,
                                    const Seeds& seeds, const CrossedEdges& carrier,
                                    const Membership& membership, NodeField& field, const RunContext& context,
                                    int threads) {
  return Follower(grid, carrier, membership, field, context, threads).run(rimCells, seeds);
}

}  // namespace thicken
