// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The search for all pairs of triangles that meet: with one tree over all of them or, where they are more
// than are to be held at a time, block of space after block, with a tree over the triangles that reach into
// it. A pair belongs to the block that holds the lower corner of what the triangles' boxes have in common.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exact/box_tree.h"

namespace thicken::exact {

class PairSearch {
 public:
  static constexpr std::size_t kAll = ~std::size_t{0};

  /// `mesh` must outlive this; its positions may change, of which withMoved() is to be told. `most`:
  /// triangles to have in a tree at a time; a block in which more meet or are heaped has more. `active` and
  /// `order` are BoxTree's.
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
