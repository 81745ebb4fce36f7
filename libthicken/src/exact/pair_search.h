// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Finds all pairs of triangles that meet, with one tree over all of them. If they are more than may be held
// at a time, space is divided into blocks, and each block gets a tree over the triangles that reach into it.
// A pair belongs to the block that holds the lower corner of the intersection of its boxes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exact/box_tree.h"

namespace thicken::exact {

class PairSearch {
 public:
  static constexpr std::size_t kAll = ~std::size_t{0};

  /// `mesh` must outlive this. Its positions may change: withMoved() must be told. `most`: triangles in a
  /// tree at a time; a block in which more of them reach into one place has more. `active`, `order`:
  /// BoxTree's.
  PairSearch(const TriangleMesh& mesh, std::size_t most, int threads,
             std::span<const std::uint8_t> active = {}, std::span<const TriangleId> order = {});

  /// BoxTree::meetingPairs().
  [[nodiscard]] std::vector<TrianglePair> all(std::span<const std::uint8_t> fixed, const RunContext& context,
                                              int threads, std::size_t limit = 0) const;

  /// BoxTree::meetingPairsWith(), after the corners of `moved` (ascending) and of no others have moved.
  [[nodiscard]] std::vector<TrianglePair> withMoved(std::span<const TriangleId> moved,
                                                    std::span<const std::uint8_t> fixed,
                                                    const RunContext& context, int threads);

 private:
  const TriangleMesh& mesh_;
  std::size_t most_;
  std::span<const std::uint8_t> active_;
  std::optional<BoxTree> tree_;  ///< over all, where they are few enough
};

}  // namespace thicken::exact
