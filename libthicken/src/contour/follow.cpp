// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/follow.h"

#include <algorithm>

#include "contour/face_matching.h"
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

  std::vector<Crossing> run(std::span<const GridIndex> seeds) {
    for (const GridIndex& cell : seeds) cells_.insert(UniformGrid::key(cell));
    follow();
    // A seed is a point near the contour, which may pass its cell by.
    for (const GridIndex& cell : seeds)
      if (!crossed_.contains(UniformGrid::key(cell))) enterNeighbours(cell);
    follow();
    std::sort(found_.begin(), found_.end(), inOrder);
    return std::move(found_);
  }

 private:
  void follow() {
    while (done_ < cells_.size()) {
      const std::size_t end = cells_.size(), firstEdge = edges_.size();
      field_.countCells(end - done_);
      for (; done_ < end; ++done_) enter(UniformGrid::indexOf(cells_.keys()[done_]));
      field_.evaluate(membership_, context_, threads_);
      examine(firstEdge);
    }
  }

  void enterNeighbours(const GridIndex& cell) {
    for (int c = 0; c < 27; ++c)
      cells_.insert(UniformGrid::key({cell[0] + c % 3 - 1, cell[1] + c / 3 % 3 - 1, cell[2] + c / 9 - 1}));
  }

  // Lists the cell's nodes and edges that no cell before it had.
  void enter(const GridIndex& cell) {
    std::array<std::uint32_t, 8> corner{};
    for (int c = 0; c < 8; ++c)
      corner[c] =
          field_.want(UniformGrid::key({cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)}));
    for (int axis = 0; axis < 3; ++axis)
      for (int c = 0; c < 8; ++c) {
        if (c >> axis & 1) continue;
        const GridIndex low{cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)};
        if (edges_.insert(UniformGrid::key(low, axis)).second)
          ends_.push_back({corner[c], corner[c | (1 << axis)]});
      }
  }

  void examine(std::size_t firstEdge) {
    constexpr std::size_t kGrain = 1024;
    const std::size_t count = edges_.size() - firstEdge;
    std::vector<std::vector<Crossing>> parts((count + kGrain - 1) / kGrain);
    parallelFor(count, threads_, context_, kGrain, [&](std::size_t i) {
      const std::size_t e = firstEdge + i;
      const std::uint64_t edge = edges_.keys()[e];
      crossEdge(grid_, field_, edge, ends_[e][0], ends_[e][1], carrier_.of(edge), parts[i / kGrain]);
    });
    for (const auto& part : parts)
      for (const Crossing& c : part) {
        found_.push_back(c);
        const GridIndex n = UniformGrid::indexOf(c.edge >> 2);
        for (int k = 0; k < 4; ++k) {
          const GridIndex o = sectorOffset(static_cast<int>(c.edge & 3), k);
          const std::uint64_t cell = UniformGrid::key({n[0] + o[0], n[1] + o[1], n[2] + o[2]});
          cells_.insert(cell);
          crossed_.insert(cell);
        }
      }
  }

  const UniformGrid& grid_;
  const CrossedEdges& carrier_;
  const Membership& membership_;
  NodeField& field_;
  const RunContext& context_;
  int threads_;
  KeyIndex cells_, edges_, crossed_;
  std::size_t done_ = 0;                            ///< cells
  std::vector<std::array<std::uint32_t, 2>> ends_;  ///< nodes of each edge
  std::vector<Crossing> found_;
};

}  // namespace

std::vector<Crossing> followContour(const UniformGrid& grid, std::span<const GridIndex> seeds,
                                    const CrossedEdges& carrier, const Membership& membership,
                                    NodeField& field, const RunContext& context, int threads) {
  return Follower(grid, carrier, membership, field, context, threads).run(seeds);
}

}  // namespace thicken
