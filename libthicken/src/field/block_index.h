// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers nodes or cells of a grid in the order in which they arrive, as KeyIndex does for any keys, but
// looks a block of 4³ of them up at once: neighbours share a few lines of memory, where a table of single
// keys scatters them.
#pragma once

#include <array>

#include "field/key_index.h"
#include "field/uniform_grid.h"

namespace thicken {

class BlockIndex {
 public:
  static constexpr std::uint32_t kAbsent = KeyIndex::kAbsent;

  /// The number of `key` (UniformGrid::key of a node), and whether it is new.
  std::pair<std::uint32_t, bool> insert(std::uint64_t key) {
    std::uint32_t& number = blocks_[blockOf(key)][placeOf(key)];
    if (number != kAbsent) return {number, false};
    number = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {number, true};
  }

  /// The number of `key`, or kAbsent.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const {
    const std::uint32_t b = index_.find(key & ~kWithin);
    return b == KeyIndex::kAbsent ? kAbsent : blocks_[b][placeOf(key)];
  }

  [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

 private:
  static constexpr int kBits = 2;  // of an index, within a block
  static constexpr std::uint64_t kLowest = (1u << kBits) - 1;
  static constexpr std::uint64_t kWithin =
      kLowest | (kLowest << UniformGrid::kBits) | (kLowest << (2 * UniformGrid::kBits));
  using Block = std::array<std::uint32_t, std::size_t{1} << (3 * kBits)>;

  [[nodiscard]] static std::size_t placeOf(std::uint64_t key) {
    return (key & kLowest) | ((key >> UniformGrid::kBits & kLowest) << kBits) |
           ((key >> (2 * UniformGrid::kBits) & kLowest) << (2 * kBits));
  }

  // Most keys lie in the block of the one before.
  std::uint32_t blockOf(std::uint64_t key) {
    const std::uint64_t block = key & ~kWithin;
    if (block == lastKey_) return last_;
    const auto [b, isNew] = index_.insert(block);
    if (isNew) blocks_.emplace_back().fill(kAbsent);
    lastKey_ = block;
    return last_ = b;
  }

  KeyIndex index_;  // of blocks, by the key of their lowest node
  std::vector<Block> blocks_;
  std::vector<std::uint64_t> keys_;
  std::uint64_t lastKey_ = ~std::uint64_t{0};
  std::uint32_t last_ = 0;
};

}  // namespace thicken
