// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Edges by what their collapse costs, to a thirtieth; of nearly equal ones the first that came. Nothing is
// compared, whatever the number of edges.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::simplify {

class EdgeQueue {
 public:
  struct Entry {
    VertexId a = 0, b = 0;
    std::uint32_t ageOfA = 0, ageOfB = 0;  ///< by which it is told whether the edge is still as it was
  };

  /// `cost`: 0 or more, finite.
  void push(double cost, const Entry& entry) {
    const std::size_t place = placeOf(cost);
    places_[place].entries.push_back(entry);
    first_ = std::min(first_, place);
  }
  /// The cheapest, or nothing.
  std::optional<Entry> pop() {
    for (; first_ < places_.size(); ++first_) {
      Place& place = places_[first_];
      if (place.next < place.entries.size()) return place.entries[place.next++];
      place.entries.clear();
      place.next = 0;
    }
    return std::nullopt;
  }

 private:
  // The bits of a float ascend with it: the exponent and the first five of the mantissa.
  static constexpr int kDropped = 18;
  [[nodiscard]] static std::size_t placeOf(double cost) {
    return std::bit_cast<std::uint32_t>(static_cast<float>(cost)) >> kDropped;
  }

  struct Place {
    std::vector<Entry> entries;
    std::size_t next = 0;
  };
  std::vector<Place> places_ = std::vector<Place>(std::size_t{1} << (31 - kDropped));
  std::size_t first_ = 0;
};

}  // namespace thicken::simplify
