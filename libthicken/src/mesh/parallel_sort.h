// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sorting on several threads. The order must be total, so that the result is the same for any number of
// them.
#pragma once

#include <algorithm>
#include <vector>

#include "parallel_for.h"

namespace thicken {

/// Sorts `items`; `before` must tell any two of them apart.
template <class T, class Before>
void parallelSort(std::vector<T>& items, Before before, int threads) {
  constexpr std::size_t kWorthwhile = 1 << 14;
  std::size_t parts = 1;
  while (parts < static_cast<std::size_t>(threadCount(threads)) && items.size() / parts > kWorthwhile)
    parts *= 2;
  const auto at = [&](std::size_t part) {
    return items.begin() + static_cast<std::ptrdiff_t>(items.size() * part / parts);
  };
  const RunContext uncancelled;
  parallelFor(parts, threads, uncancelled, 1, [&](std::size_t i) { std::sort(at(i), at(i + 1), before); });
  for (std::size_t step = 1; step < parts; step *= 2)
    parallelFor(parts / (2 * step), threads, uncancelled, 1, [&](std::size_t i) {
      const std::size_t first = 2 * step * i;
      std::inplace_merge(at(first), at(first + step), at(first + 2 * step), before);
    });
}

}  // namespace thicken
