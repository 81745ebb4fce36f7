// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A few bits for every node or cell of a grid, in a byte or two: facts that are needed to the end.
#pragma once

#include <array>

#include "field/block_map.h"

namespace thicken::field {

/// kCount bits each, all 0 at first.
template <int kCount>
class BlockBits {
 public:
  /// Sets bits, and returns those that were set before.
  std::uint8_t set(std::uint64_t key, std::uint8_t bits) {
    Block& block = blocks_.of(key, {});
    const std::size_t place = Blocks::placeOf(key);
    const std::uint8_t before = at(block, place);
    for (int i = 0; i < kCount; ++i) block[i] |= std::uint64_t{bits >> i & 1u} << place;
    return before;
  }

  [[nodiscard]] std::uint8_t of(std::uint64_t key) const {
    const Block* block = blocks_.find(key);
    return block == nullptr ? std::uint8_t{0} : at(*block, Blocks::placeOf(key));
  }

 private:
  using Block = std::array<std::uint64_t, kCount>;
  using Blocks = BlockMap<Block>;

  [[nodiscard]] static std::uint8_t at(const Block& block, std::size_t place) {
    unsigned bits = 0;
    for (int i = 0; i < kCount; ++i) bits |= static_cast<unsigned>(block[i] >> place & 1) << i;
    return static_cast<std::uint8_t>(bits);
  }

  Blocks blocks_;
};

}  // namespace thicken::field
