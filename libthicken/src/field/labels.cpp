// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/labels.h"

#include <algorithm>
#include <cmath>

#include "parallel_for.h"

namespace thicken {

// Fills the nodes of one block from the whole block down to single nodes.
class Labels::Filler {
 public:
  Filler(const UniformGrid& grid, const Membership& membership, Block& block)
      : grid_(grid), membership_(membership), block_(block) {
    for (int k = 0; k < 3; ++k) first_[k] = block.index[k] * kSide;
  }

  void fill() {
    fill({0, 0, 0}, kSide);
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i)
          if (state_[at({i, j, k})] == kIn) block_.bits[k] |= std::uint64_t{1} << (j * kSide + i);
  }

 private:
  enum State : std::uint8_t { kUnknown, kFront, kOut, kIn };

  static std::size_t at(const GridIndex& n) {
    return static_cast<std::size_t>((n[2] * kSide + n[1]) * kSide + n[0]);
  }
  static State stateOf(const Probe& p) {
    return p.inside() ? kIn : p.standing == Standing::kFront ? kFront : kOut;
  }

  State evaluate(const GridIndex& n) {
    State& s = state_[at(n)];
    if (s == kUnknown)
      s = stateOf(membership_.probe(grid_.node({first_[0] + n[0], first_[1] + n[1], first_[2] + n[2]})));
    return s;
  }

  // The common state of the eight corner nodes of a box; kUnknown when they differ.
  State corners(const GridIndex& low, int n) {
    State common = evaluate(low);
    for (int c = 1; c < 8; ++c) {
      const State s = evaluate(
          {low[0] + (c & 1 ? n - 1 : 0), low[1] + (c & 2 ? n - 1 : 0), low[2] + (c & 4 ? n - 1 : 0)});
      if (s != common) return kUnknown;
    }
    return common;
  }

  void set(const GridIndex& low, int n, State s) {
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) state_[at({low[0] + i, low[1] + j, low[2] + k})] = s;
  }

  void fill(const GridIndex& low, int n) {
    if (n == 1) {
      evaluate(low);
      return;
    }
    const double reach = (n - 1) * grid_.width();
    const double radius = std::sqrt(3.0) / 2 * reach;
    const Vec3 centre =
        grid_.node({first_[0] + low[0], first_[1] + low[1], first_[2] + low[2]}) + Vec3::Constant(reach / 2);
    const Probe p = membership_.probe(centre);
    if (p.distance > membership_.thickness() + radius) {
      set(low, n, kOut);
      return;
    }
    // Clear of Ŝ, and of the shell unless all of the box lies before S: corners tell. What could
    // still hide between equal corners is finer than the box, and any labels give a valid topology.
    const bool clear = p.carrierDistance > radius;
    const bool offShell = std::abs(p.distance - membership_.thickness()) > radius;
    if (clear && (offShell || p.standing == Standing::kFront)) {
      const State s = corners(low, n);
      if (s != kUnknown && s == stateOf(p) && (offShell || s == kFront)) {
        set(low, n, s);
        return;
      }
    }
    const int h = n / 2;
    for (int c = 0; c < 8; ++c)
      fill({low[0] + (c & 1 ? h : 0), low[1] + (c & 2 ? h : 0), low[2] + (c & 4 ? h : 0)}, h);
  }

  const UniformGrid& grid_;
  const Membership& membership_;
  Block& block_;
  GridIndex first_{};
  std::array<State, kSide * kSide * kSide> state_{};
};

std::vector<GridIndex> Labels::candidates(const UniformGrid& grid, const Membership& membership,
                                          const RunContext& context, int threads) const {
  GridIndex blocks{};
  int side = 1;
  for (int k = 0; k < 3; ++k) {
    blocks[k] = grid.cells()[k] / kSide + 1;
    while (side < blocks[k]) side *= 2;
  }
  std::vector<GridIndex> boxes{{0, 0, 0}};  // lowest blocks of cubes of side³ blocks
  for (;; side /= 2) {
    std::vector<std::uint8_t> keep(boxes.size(), 0);
    parallelFor(boxes.size(), threads, context, 16, [&](std::size_t b) {
      const double extent = (side * kSide - 1) * grid.width();
      const Vec3 centre = grid.node({boxes[b][0] * kSide, boxes[b][1] * kSide, boxes[b][2] * kSide}) +
                          Vec3::Constant(extent / 2);
      const double reach = membership.thickness() + std::sqrt(3.0) / 2 * extent;
      keep[b] = membership.surface().closest(centre, reach * (1 + 1e-9)).has_value();
    });
    std::vector<GridIndex> next;
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      if (!keep[b]) continue;
      if (side == 1) {
        next.push_back(boxes[b]);
        continue;
      }
      const int h = side / 2;
      for (int c = 0; c < 8; ++c) {
        const GridIndex low{boxes[b][0] + (c & 1 ? h : 0), boxes[b][1] + (c & 2 ? h : 0),
                            boxes[b][2] + (c & 4 ? h : 0)};
        if (low[0] < blocks[0] && low[1] < blocks[1] && low[2] < blocks[2]) next.push_back(low);
      }
    }
    boxes = std::move(next);
    if (side == 1) break;
  }
  return boxes;
}

Labels::Labels(const UniformGrid& grid, const Membership& membership, const RunContext& context,
               int threads) {
  std::vector<GridIndex> boxes = candidates(grid, membership, context, threads);
  std::sort(boxes.begin(), boxes.end(),
            [](const GridIndex& a, const GridIndex& b) { return UniformGrid::key(a) < UniformGrid::key(b); });
  blocks_.resize(boxes.size());
  parallelFor(boxes.size(), threads, context, 1, [&](std::size_t b) {
    blocks_[b].index = boxes[b];
    Filler(grid, membership, blocks_[b]).fill();
  });
  std::erase_if(blocks_, [](const Block& b) {
    return std::all_of(b.bits.begin(), b.bits.end(), [](std::uint64_t w) { return w == 0; });
  });
  place_.reserve(blocks_.size());
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) place_.emplace(UniformGrid::key(blocks_[b].index), b);
}

bool Labels::inside(const GridIndex& n) const {
  if (n[0] < 0 || n[1] < 0 || n[2] < 0) return false;
  const auto found = place_.find(UniformGrid::key({n[0] / kSide, n[1] / kSide, n[2] / kSide}));
  if (found == place_.end()) return false;
  return blocks_[found->second].at(n[0] % kSide, n[1] % kSide, n[2] % kSide);
}

std::vector<std::uint64_t> Labels::boundaryEdges(const RunContext& context, int threads) const {
  std::vector<std::vector<std::uint64_t>> parts(blocks_.size());
  parallelFor(blocks_.size(), threads, context, 16, [&](std::size_t b) {
    const Block& block = blocks_[b];
    const GridIndex first{block.index[0] * kSide, block.index[1] * kSide, block.index[2] * kSide};
    // Edges within the block, those that leave it upwards, and those that come from a block below
    // that holds nothing inside and so is not stored.
    for (int k = 0; k < kSide; ++k)
      for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
          const GridIndex n{first[0] + i, first[1] + j, first[2] + k};
          const bool here = block.at(i, j, k);
          const GridIndex local{i, j, k};
          for (int axis = 0; axis < 3; ++axis) {
            GridIndex up = n;
            ++up[axis];
            const bool there = local[axis] + 1 < kSide
                                   ? block.at(i + (axis == 0), j + (axis == 1), k + (axis == 2))
                                   : inside(up);
            if (here != there) parts[b].push_back(UniformGrid::key(n, axis));
            if (local[axis] != 0 || !here) continue;
            GridIndex down = block.index;
            if (--down[axis] >= 0 && place_.contains(UniformGrid::key(down))) continue;
            GridIndex below = n;
            --below[axis];
            parts[b].push_back(UniformGrid::key(below, axis));
          }
        }
  });
  std::vector<std::uint64_t> edges;
  for (const auto& part : parts) edges.insert(edges.end(), part.begin(), part.end());
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace thicken
