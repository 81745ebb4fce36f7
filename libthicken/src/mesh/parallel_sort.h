// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sorting and merging on several threads. The order must be total, so that the result is the same for any
// number of them.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "parallel/parallel_for.h"

namespace thicken::mesh {

/// How many of the first `count` items of the merged sequence come from `a`.
template <class T, class Before>
[[nodiscard]] std::size_t shareOfFirst(std::span<const T> a, std::span<const T> b, std::size_t count,
                                       Before before) {
  std::size_t low = count > b.size() ? count - b.size() : 0, high = std::min(count, a.size());
  while (low < high) {
    const std::size_t i = (low + high) / 2;
    if (before(b[count - i - 1], a[i]))
      high = i;
    else
      low = i + 1;
  }
  return low;
}

/// Merges two sorted sequences to `out`, as std::merge does.
template <class T, class Before>
void parallelMerge(std::span<const T> a, std::span<const T> b, T* out, Before before, int threads) {
  constexpr std::size_t kPiece = 1 << 14;
  const std::size_t count = a.size() + b.size(),
                    pieces = parallel::threadCount(threads) > 1 ? count / kPiece + 1 : 1;
  parallel::parallelFor(pieces, threads, RunContext(), 1, [&](std::size_t i) {
    const std::size_t from = count * i / pieces, to = count * (i + 1) / pieces;
    const std::size_t fromA = shareOfFirst(a, b, from, before), toA = shareOfFirst(a, b, to, before);
    std::merge(a.begin() + static_cast<std::ptrdiff_t>(fromA), a.begin() + static_cast<std::ptrdiff_t>(toA),
               b.begin() + static_cast<std::ptrdiff_t>(from - fromA),
               b.begin() + static_cast<std::ptrdiff_t>(to - toA), out + from, before);
  });
}

/// Merges sorted runs of `items`, run i from bounds[i] to bounds[i + 1], to one.
template <class T, class Before>
void mergeRuns(std::vector<T>& items, std::vector<std::size_t> bounds, Before before, int threads) {
  if (bounds.size() <= 2) return;
  const auto buffer = std::make_unique_for_overwrite<T[]>(items.size());
  T *from = items.data(), *to = buffer.get();
  while (bounds.size() > 2) {
    std::vector<std::size_t> merged{0};
    for (std::size_t i = 0; i + 1 < bounds.size(); i += 2) {
      const std::size_t begin = bounds[i], middle = bounds[i + 1];
      const std::size_t end = i + 2 < bounds.size() ? bounds[i + 2] : middle;
      parallelMerge(std::span<const T>(from + begin, from + middle),
                    std::span<const T>(from + middle, from + end), to + begin, before, threads);
      merged.push_back(end);
    }
    bounds = std::move(merged);
    std::swap(from, to);
  }
  if (from == items.data()) return;
  constexpr std::size_t kGrain = 1 << 14;
  parallel::parallelFor(items.size(), threads, RunContext(), kGrain,
                        [&](std::size_t i) { items[i] = buffer[i]; });
}

/// Sorts `items`. `before` must order any two of them that differ.
template <class T, class Before>
void parallelSort(std::vector<T>& items, Before before, int threads) {
  constexpr std::size_t kWorthwhile = 1 << 14;
  std::size_t parts = 1;
  while (parts < static_cast<std::size_t>(parallel::threadCount(threads)) &&
         items.size() / parts > kWorthwhile)
    parts *= 2;
  std::vector<std::size_t> bounds;
  for (std::size_t i = 0; i <= parts; ++i) bounds.push_back(items.size() * i / parts);
  parallel::parallelFor(parts, threads, RunContext(), 1, [&](std::size_t i) {
    std::sort(items.begin() + static_cast<std::ptrdiff_t>(bounds[i]),
              items.begin() + static_cast<std::ptrdiff_t>(bounds[i + 1]), before);
  });
  mergeRuns(items, std::move(bounds), before, threads);
}

}  // namespace thicken::mesh
