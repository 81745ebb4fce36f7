// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Maps blocks of 4³ nodes or cells of a grid to values. Neighbours share a few lines of memory; a table of
// single keys would scatter them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "field/key_index.h"
#include "field/uniform_grid.h"

namespace thicken::field {

template <class Block>
class BlockMap {
  static constexpr int kBits = 2;  // of an index, within a block

 public:
  static constexpr std::size_t kPlaces = std::size_t{1} << (3 * kBits);

  /// Where a key (UniformGrid::key of a node) lies in its block.
  [[nodiscard]] static std::size_t placeOf(std::uint64_t key) {
    return (key & kLowest) | ((key >> UniformGrid::kBits & kLowest) << kBits) |
           ((key >> (2 * UniformGrid::kBits) & kLowest) << (2 * kBits));
  }

  /// The block of a key, which begins as `fresh`. It stays where it is until the next call.
  Block& of(std::uint64_t key, const Block& fresh) {
    const std::uint64_t block = key & ~kWithin;
    if (block != lastKey_) {  // most keys lie in the block of the one before
      const auto [b, isNew] = index_.insert(block);
      if (isNew) blocks_.push_back(fresh);
      lastKey_ = block;
      last_ = b;
    }
    return blocks_[last_];
  }

  /// The block of a key; null where it was never asked for.
  [[nodiscard]] const Block* find(std::uint64_t key) const {
    const std::uint32_t b = index_.find(key & ~kWithin);
    return b == KeyIndex::kAbsent ? nullptr : &blocks_[b];
  }

  /// Forgets all blocks, but keeps their memory.
  void clear() {
    index_.clear();
    blocks_.clear();
    lastKey_ = kNoKey;
  }

 private:
  static constexpr std::uint64_t kLowest = (1u << kBits) - 1, kNoKey = ~std::uint64_t{0};
  static constexpr std::uint64_t kWithin =
      kLowest | (kLowest << UniformGrid::kBits) | (kLowest << (2 * UniformGrid::kBits));

  KeyIndex index_;  // of blocks, by the key of their lowest node
  std::vector<Block> blocks_;
  std::uint64_t lastKey_ = kNoKey;
  std::uint32_t last_ = 0;
};

}  // namespace thicken::field
