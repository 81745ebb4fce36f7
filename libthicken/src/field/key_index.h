// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Numbers 64-bit keys in the order in which they arrive. Open addressing; 4 bytes a slot beside the keys
// themselves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace thicken::field {

class KeyIndex {
 public:
  static constexpr std::uint32_t kAbsent = 0xffffffffu;

  /// The number of `key`, and whether it is new.
  std::pair<std::uint32_t, bool> insert(std::uint64_t key) {
    if (2 * (keys_.size() + 1) > slots_.size()) grow();
    const std::size_t s = slotOf(key);
    if (slots_[s] != kAbsent) return {slots_[s], false};
    slots_[s] = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    return {slots_[s], true};
  }

  /// The number of `key`, or kAbsent.
  [[nodiscard]] std::uint32_t find(std::uint64_t key) const {
    return slots_.empty() ? kAbsent : slots_[slotOf(key)];
  }

  [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }
  [[nodiscard]] std::size_t size() const { return keys_.size(); }

  /// Forgets all keys, but keeps their memory.
  void clear() {
    std::fill(slots_.begin(), slots_.end(), kAbsent);
    keys_.clear();
  }

 private:
  // Fibonacci hashing; keys of neighbours differ in few bits.
  [[nodiscard]] std::size_t firstSlot(std::uint64_t key) const {
    return static_cast<std::size_t>(((key ^ (key >> 29)) * 0x9e3779b97f4a7c15u) >> shift_);
  }

  [[nodiscard]] std::size_t slotOf(std::uint64_t key) const {
    std::size_t s = firstSlot(key);
    while (slots_[s] != kAbsent && keys_[slots_[s]] != key) s = (s + 1) & (slots_.size() - 1);
    return s;
  }

  void grow() {
    shift_ = slots_.empty() ? 64 - kFirstBits : shift_ - 1;
    slots_.assign(std::size_t{1} << (64 - shift_), kAbsent);
    for (std::uint32_t i = 0; i < keys_.size(); ++i) slots_[slotOf(keys_[i])] = i;
  }

  static constexpr int kFirstBits = 10;
  int shift_ = 64;
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint64_t> keys_;
};

}  // namespace thicken::field
