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
  Follower(const UniformGrid& grid, const CarrierCrossings& carrier, const Membership& membership,
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
    parallelSort(found_, inOrder, threads_);
    return std::move(found_);
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
    return i != KeyIndex::kAbsent && crossed_[i] != 0;
  }

  std::uint32_t addCell(std::uint64_t key) {
    const auto [i, isNew] = cells_.insert(key);
    if (isNew) crossed_.push_back(0);
    return i;
  }

  void follow() {
    while (done_ < cells_.size()) {
      const std::size_t end = cells_.size(), firstEdge = edges_.size();
      field_.countCells(end - done_);
      for (; done_ < end; ++done_) {
        if (done_ + kAhead < end)
          for (int c = 0; c < 8; ++c)
            field_.prefetch(nodeOf(UniformGrid::indexOf(cells_.keys()[done_ + kAhead]), c));
        enter(UniformGrid::indexOf(cells_.keys()[done_]));
      }
      field_.evaluate(membership_, context_, threads_);
      examine(firstEdge);
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

  void examine(std::size_t firstEdge) {
    constexpr std::size_t kGrain = 1024;
    constexpr double kSure = 1.001;
    const std::size_t count = edges_.size() - firstEdge;
    std::vector<std::vector<Crossing>> parts((count + kGrain - 1) / kGrain);
    parallelFor(count, threads_, context_, kGrain, [&](std::size_t i) {
      const Edge& e = edges_[firstEdge + i];
      const std::uint64_t key = UniformGrid::key(UniformGrid::indexOf(field_.key(e.low)), e.axis);
      // An edge is as long as a cell is wide, so that nothing crosses it which is farther from its end.
      const bool reached = field_[e.low].carrierDistance <= kSure * grid_.width();
      crossEdge(grid_, field_, key, e.low, e.high,
                reached ? carrier_.of(key) : std::vector<SurfaceCrossing>(), parts[i / kGrain]);
    });
    for (const auto& part : parts)
      for (std::size_t i = 0; i < part.size(); ++i) {
        if (i + kAhead < part.size())
          for (int k = 0; k < 4; ++k) cells_.prefetch(cellAround(part[i + kAhead].edge, k));
        found_.push_back(part[i]);
        for (int k = 0; k < 4; ++k) crossed_[addCell(cellAround(part[i].edge, k))] = 1;
      }
  }

  static constexpr std::size_t kAhead = 8;  // cells or crossings whose look-ups are prepared

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
  const CarrierCrossings& carrier_;
  const Membership& membership_;
  NodeField& field_;
  const RunContext& context_;
  int threads_;
  KeyIndex cells_;
  std::vector<std::uint8_t> crossed_;  ///< per cell
  std::size_t done_ = 0;               ///< cells
  std::vector<std::uint8_t> listed_;   ///< per node, a bit for each axis: its edge is in edges_
  std::vector<Edge> edges_;
  std::vector<Crossing> found_;
};

}  // namespace

std::vector<Crossing> followContour(const UniformGrid& grid, std::span<const GridIndex> rimCells,
                                    const Seeds& seeds, const CarrierCrossings& carrier,
                                    const Membership& membership, NodeField& field, const RunContext& context,
                                    int threads) {
  return Follower(grid, carrier, membership, field, context, threads).run(rimCells, seeds);
}

}  // namespace thicken
