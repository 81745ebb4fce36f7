// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which nodes of the grid lie in the solid: one bit a node, in blocks of 8 × 8 × 8 nodes that exist
// only where the surface is nearer than r. Found from the bounding box down (paper, Remark 2);
// distance is 1-Lipschitz, so that most nodes take their label from one query for a whole box.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "field/membership.h"
#include "field/uniform_grid.h"
#include "thicken/run_context.h"

namespace thicken {

class Labels {
 public:
  Labels(const UniformGrid& grid, const Membership& membership, const RunContext& context, int threads);

  /// Whether a node is inside; nodes far from S are not.
  [[nodiscard]] bool inside(const GridIndex& node) const;

  /// Edges whose ends have different labels, sorted.
  [[nodiscard]] std::vector<std::uint64_t> boundaryEdges(const RunContext& context, int threads) const;

  [[nodiscard]] std::size_t blockCount() const { return blocks_.size(); }

 private:
  static constexpr int kSide = 8;
  struct Block {
    GridIndex index{};                        ///< of the block; its nodes start at kSide times that
    std::array<std::uint64_t, kSide> bits{};  ///< one word a layer of the third axis
    [[nodiscard]] bool at(int i, int j, int k) const { return (bits[k] >> (j * kSide + i)) & 1; }
  };
  class Filler;

  [[nodiscard]] std::vector<GridIndex> candidates(const UniformGrid& grid, const Membership& membership,
                                                  const RunContext& context, int threads) const;

  std::vector<Block> blocks_;  ///< sorted by key
  std::unordered_map<std::uint64_t, std::uint32_t> place_;
};

}  // namespace thicken
