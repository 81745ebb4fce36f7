// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Tells of nearly every key that is not in a set that it is not, by one look at memory that stays in the
// cache: where most keys that are asked for are in no set, hardly any of them is searched.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace thicken {

class KeyFilter {
 public:
  /// For about so many keys.
  explicit KeyFilter(std::size_t keys) {
    const int bits = std::bit_width(keys / kKeysPerWord) + 1;
    shift_ = 64 - bits;
    words_.assign(std::size_t{1} << bits, 0);
  }

  void add(std::uint64_t key) {
    const std::uint64_t h = hashOf(key);
    words_[h >> shift_] |= maskOf(h);
  }

  /// True for every key that was added, and for about one in a hundred others.
  [[nodiscard]] bool mayHave(std::uint64_t key) const {
    const std::uint64_t h = hashOf(key), mask = maskOf(h);
    return (words_[h >> shift_] & mask) == mask;
  }

 private:
  static constexpr std::size_t kKeysPerWord = 4;

  [[nodiscard]] static std::uint64_t hashOf(std::uint64_t key) {
    return (key ^ (key >> 29)) * 0x9e3779b97f4a7c15u;
  }
  [[nodiscard]] std::uint64_t maskOf(std::uint64_t h) const {
    return (std::uint64_t{1} << (h >> (shift_ - 6) & 63)) | (std::uint64_t{1} << (h >> (shift_ - 12) & 63));
  }

  int shift_ = 0;
  std::vector<std::uint64_t> words_;
};

}  // namespace thicken
