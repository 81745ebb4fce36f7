// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers nodes of a grid in the order in which they arrive, as KeyIndex does for any keys. It looks up a
// block of nodes at once.
#pragma once

#include <array>
#include <utility>

#include "field/block_map.h"

namespace thicken::field {

class BlockIndex {
 public:
  static constexpr std::uint32_t kAbsent = KeyIndex::kAbsent;

  /// The number of `key` (UniformGrid::key of a node), and whether it is new.
  std::pair<std::uint32_t, bool> insert(std::uint64_t key) {
    std::uint32_t& number = blocks_.of(key, kFresh)[Blocks::placeOf(key)];
    if (number != kAbsent) return {number, false};
    number = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {number, true};
  }

  /// The number of `key`, or kAbsent.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const {
    const Block* block = blocks_.find(key);
    return block == nullptr ? kAbsent : (*block)[Blocks::placeOf(key)];
  }

  [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

  /// Forgets all keys, but keeps their memory.
  void clear() {
    blocks_.clear();
    keys_.clear();
  }

 private:
  using Block = std::array<std::uint32_t, BlockMap<int>::kPlaces>;
  using Blocks = BlockMap<Block>;

  static constexpr Block kFresh = [] {
    Block fresh{};
    fresh.fill(kAbsent);
    return fresh;
  }();

  Blocks blocks_;
  std::vector<std::uint64_t> keys_;
};

}  // namespace thicken::field
