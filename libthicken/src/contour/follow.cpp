// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/follow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include "contour/face_matching.h"
#include "field/block_bits.h"
#include "mesh/parallel_sort.h"
#include "parallel/parallel_for.h"

namespace thicken::contour {

using field::BlockBits;
using field::CarrierCrossings;
using field::GridIndex;
using field::Membership;
using field::NodeField;
using field::UniformGrid;
using mesh::parallelSort;
using parallel::parallelFor;

namespace {

// Cells are visited in batches, each of which goes through four steps: its nodes and edges are listed, its
// nodes are evaluated, its edges are examined, its crossings are placed. Four batches are under way at any
// time, one in each step. Listing is for one thread, in a fixed order; the others do the rest meanwhile.
class Follower {
 public:
  Follower(const UniformGrid& grid, const CarrierCrossings& carrier, const Membership& membership,
           NodeField& field, const Placing& placing, const RunContext& context, int threads)
      : grid_(grid),
        carrier_(carrier),
        membership_(membership),
        field_(field),
        placing_(placing),
        context_(context),
        threads_(threads) {}

  std::vector<Crossing> run(std::span<const GridIndex> rimCells, const Seeds& seeds) {
    followFrom(rimCells);
    std::vector<GridIndex> further;
    for (const Vec3& p : placed(seeds)) further.push_back(cellOf(p));
    followFrom(further);
    if (field_.mayDrop()) field_.release();
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

  // The seeds that the contour has not come by yet, moved onto it. A surface that is finer than the cells has
  // many of them side by side, which would lead to the same places.
  [[nodiscard]] std::vector<Vec3> placed(const Seeds& seeds) const {
    constexpr double kApart = 0.25;  // cells
    struct Candidate {
      std::array<std::int64_t, 3> part;
      std::size_t seed;
      bool operator<(const Candidate& b) const { return part != b.part ? part < b.part : seed < b.seed; }
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < seeds.points.size(); ++i) {
      const Vec3& p = seeds.points[i];
      if (isCrossed(cellOf(p))) continue;
      Candidate candidate{{}, i};
      for (int k = 0; k < 3; ++k)
        candidate.part[k] = static_cast<std::int64_t>(std::floor(p[k] / (kApart * grid_.width())));
      candidates.push_back(candidate);
    }
    parallelSort(candidates, std::less<>(), threads_);
    const auto last = std::unique(candidates.begin(), candidates.end(),
                                  [](const Candidate& a, const Candidate& b) { return a.part == b.part; });
    std::vector<std::size_t> some;
    for (auto at = candidates.begin(); at != last; ++at) some.push_back(at->seed);
    std::sort(some.begin(), some.end());
    std::vector<Vec3> points(some.size());
    parallelFor(points.size(), threads_, context_, 256,
                [&](std::size_t i) { points[i] = seeds.toContour(some[i]); });
    return points;
  }

  [[nodiscard]] GridIndex cellOf(const Vec3& p) const {
    return {grid_.indexBelow(0, p.x()), grid_.indexBelow(1, p.y()), grid_.indexBelow(2, p.z())};
  }

  // Of a cell.
  static constexpr std::uint8_t kEntered = 1, kCrossed = 2;

  [[nodiscard]] bool isCrossed(const GridIndex& cell) const {
    return (cells_.of(UniformGrid::key(cell)) & kCrossed) != 0;
  }

  void addCell(std::uint64_t key, std::uint8_t bits = kEntered) {
    if (cells_.set(key, bits) == 0) waiting_.push_back(key);
  }

  struct Edge {
    std::uint64_t key;
    std::uint32_t low, high;  ///< nodes
  };
  struct Batch {
    std::size_t cells = 0;
    std::vector<NodeField::Wanted> nodes;
    std::vector<Edge> edges;
    std::vector<std::vector<EdgePart>> parts;  ///< of the edges, kEdges of them at a time
  };
  static constexpr std::size_t kNodes = 16, kEdges = 256;  // that a thread takes at a time

  void follow() {
    Batch toEvaluate, toExamine, toPlace;
    for (;;) {
      const std::size_t underWay = toEvaluate.cells + toExamine.cells + toPlace.cells;
      if (underWay == 0 && waiting() == 0) return;
      if (underWay == 0 && field_.isFull()) dropNodes();
      const std::size_t nodeParts = (toEvaluate.nodes.size() + kNodes - 1) / kNodes;
      const std::size_t edgeParts = (toExamine.edges.size() + kEdges - 1) / kEdges;
      toExamine.parts.resize(edgeParts);
      const std::size_t first = found_.size();
      found_.resize(first + toPlace.parts.size());
      std::size_t mayWait = waiting();
      for (const auto& parts : toPlace.parts) mayWait += 4 * parts.size();
      field_.makeRoom(8 * share(mayWait, toEvaluate.cells + toExamine.cells));
      Batch listed;
      parallelFor(1 + nodeParts + edgeParts + toPlace.parts.size(), threads_, context_, 1,
                  [&](std::size_t i) {
                    if (i == 0) {
                      markCells(toPlace);
                      listed = list(share(waiting(), toEvaluate.cells + toExamine.cells));
                    } else if (i <= nodeParts) {
                      evaluate(toEvaluate, i - 1);
                    } else if (i <= nodeParts + edgeParts) {
                      examine(toExamine, i - 1 - nodeParts);
                    } else {
                      const std::size_t k = i - 1 - nodeParts - edgeParts;
                      found_[first + k] = allPlaced(toPlace.parts[k]);
                    }
                  });
      toPlace = std::exchange(toExamine, std::exchange(toEvaluate, std::move(listed)));
    }
  }

  [[nodiscard]] std::size_t waiting() const { return waiting_.size() - done_; }

  // How many cells of those that wait are taken, so that the three batches are of one size.
  [[nodiscard]] static std::size_t share(std::size_t waiting, std::size_t underWay) {
    return std::min(waiting, (waiting + underWay + 2) / 3);
  }

  void enterNeighbours(const GridIndex& cell) {
    for (int c = 0; c < 27; ++c)
      addCell(UniformGrid::key({cell[0] + c % 3 - 1, cell[1] + c / 3 % 3 - 1, cell[2] + c / 9 - 1}));
  }

  // Nothing while the field is full: what is under way still needs its nodes.
  Batch list(std::size_t cells) {
    Batch batch;
    if (field_.isFull()) return batch;
    batch.cells = cells;
    field_.countCells(cells);
    for (const std::size_t end = done_ + cells; done_ < end; ++done_)
      enter(UniformGrid::indexOf(waiting_[done_]), batch.edges);
    if (done_ > waiting_.size() / 2) {
      waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(done_));
      done_ = 0;
    }
    batch.nodes = field_.takeWanted();
    return batch;
  }

  // Lists the cell's nodes and edges that no cell before it had.
  void enter(const GridIndex& cell, std::vector<Edge>& edges) {
    std::array<std::uint32_t, 8> corner{};
    for (int c = 0; c < 8; ++c) corner[c] = numberOf(nodeOf(cell, c));
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < 8; ++c) {
        std::uint8_t& listed = listed_[corner[c]];
        if ((c >> axis & 1) || (listed >> axis & 1)) continue;
        listed |= static_cast<std::uint8_t>(1 << axis);
        edges.push_back(
            {(nodeOf(cell, c) << 2) | static_cast<std::uint64_t>(axis), corner[c], corner[c | (1 << axis)]});
      }
  }

  [[nodiscard]] std::uint32_t numberOf(std::uint64_t node) {
    const std::uint32_t i = field_.want(node);
    while (listed_.size() < field_.size())
      listed_.push_back(anyDropped_ ? listedBefore_.of(field_.key(static_cast<std::uint32_t>(listed_.size())))
                                    : std::uint8_t{0});
    return i;
  }

  void dropNodes() {
    for (std::uint32_t i = 0; i < listed_.size(); ++i) listedBefore_.set(field_.key(i), listed_[i]);
    anyDropped_ = true;
    listed_.clear();
    field_.drop();
  }

  void evaluate(const Batch& batch, std::size_t part) {
    const std::size_t end = std::min(batch.nodes.size(), (part + 1) * kNodes);
    for (std::size_t i = part * kNodes; i < end; ++i) field_.evaluate(batch.nodes[i], membership_);
  }

  void examine(Batch& batch, std::size_t part) const {
    constexpr double kSure = 1.001;
    const std::size_t end = std::min(batch.edges.size(), (part + 1) * kEdges);
    for (std::size_t i = part * kEdges; i < end; ++i) {
      const Edge& e = batch.edges[i];
      // An edge is as long as a cell is wide, so that nothing crosses it which is farther from its end.
      const bool reached = field_[e.low].carrierDistance <= kSure * grid_.width();
      crossEdge(grid_, field_, e.key, e.low, e.high,
                reached ? carrier_.of(e.key) : std::vector<field::SurfaceCrossing>(), batch.parts[part]);
    }
  }

  // The cells around what was found are crossed; those that are new are to be visited.
  void markCells(const Batch& examined) {
    for (const auto& parts : examined.parts)
      for (const EdgePart& p : parts)
        for (int k = 0; k < 4; ++k) addCell(cellAround(p.edge, k), kEntered | kCrossed);
  }

  [[nodiscard]] std::vector<Crossing> allPlaced(std::span<const EdgePart> parts) const {
    std::vector<Crossing> crossings;
    crossings.reserve(parts.size());
    for (const EdgePart& p : parts) crossings.push_back(placing_(p));
    return crossings;
  }

  // All that was found, in order. What is sorted is a fraction of what a crossing holds; those of one edge
  // were found together, in their order.
  [[nodiscard]] std::vector<Crossing> sorted() const {
    struct Place {
      std::uint64_t edge;
      std::uint32_t part, within;
    };
    std::vector<std::size_t> first{0};
    for (const auto& part : found_) first.push_back(first.back() + part.size());
    std::vector<Place> places(first.back());
    parallelFor(found_.size(), threads_, context_, 64, [&](std::size_t i) {
      for (std::size_t k = 0; k < found_[i].size(); ++k)
        places[first[i] + k] = {found_[i][k].edge, static_cast<std::uint32_t>(i),
                                static_cast<std::uint32_t>(k)};
    });
    parallelSort(
        places,
        [](const Place& a, const Place& b) {
          return a.edge != b.edge   ? a.edge < b.edge
                 : a.part != b.part ? a.part < b.part
                                    : a.within < b.within;
        },
        threads_);
    std::vector<Crossing> all(places.size());
    parallelFor(all.size(), threads_, context_, 4096,
                [&](std::size_t i) { all[i] = found_[places[i].part][places[i].within]; });
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

  const UniformGrid& grid_;
  const CarrierCrossings& carrier_;
  const Membership& membership_;
  NodeField& field_;
  const Placing& placing_;
  const RunContext& context_;
  int threads_;
  BlockBits<2> cells_;                  ///< kEntered, kCrossed
  std::vector<std::uint64_t> waiting_;  ///< cells that were entered; the first done_ have been listed
  std::size_t done_ = 0;
  std::vector<std::uint8_t> listed_;  ///< per node that is known, a bit for each axis: its edge was listed
  BlockBits<3> listedBefore_;         ///< the same for nodes that were dropped
  bool anyDropped_ = false;
  std::vector<std::vector<Crossing>> found_;
};

}  // namespace

std::vector<Crossing> followContour(const UniformGrid& grid, std::span<const GridIndex> rimCells,
                                    const Seeds& seeds, const CarrierCrossings& carrier,
                                    const Membership& membership, NodeField& field, const Placing& placing,
                                    const RunContext& context, int threads) {
  return Follower(grid, carrier, membership, field, placing, context, threads).run(rimCells, seeds);
}

}  // namespace thicken::contour
