// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sorts values of items into numbered buckets, on several threads. Each thread counts and then puts the
// values of its part of the items. So every bucket holds its values in the order of the items.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "parallel/parallel_for.h"

namespace thicken::mesh {

/// The values in bucket b are `values[offset[b]] … values[offset[b + 1] − 1]`.
template <class T>
struct Buckets {
  std::vector<std::uint32_t> offset;
  std::vector<T> values;
};

/// `visit(i, put)` calls put(bucket, value) for each value of item i. It is called more than once, on any
/// thread, and must give the same values each time.
template <class T, class Visit>
[[nodiscard]] Buckets<T> intoBuckets(std::size_t items, std::size_t buckets, int threads, Visit visit) {
  constexpr std::size_t kWorthwhile = 1 << 14, kMostParts = 8;
  const std::size_t parts = std::clamp<std::size_t>(
      items / kWorthwhile, 1, std::min<std::size_t>(parallel::threadCount(threads), kMostParts));
  const RunContext uncancelled;
  std::vector<std::vector<std::uint32_t>> next(parts);  // place of the next value, a bucket
  const auto forPart = [&](std::size_t part, const auto& put) {
    const std::size_t end = items * (part + 1) / parts;
    for (std::size_t i = items * part / parts; i < end; ++i) visit(i, put);
  };
  parallel::parallelFor(parts, threads, uncancelled, 1, [&](std::size_t part) {
    next[part].assign(buckets, 0);
    forPart(part, [&count = next[part]](std::size_t bucket, const T&) { ++count[bucket]; });
  });
  Buckets<T> result;
  result.offset.resize(buckets + 1);
  std::uint32_t sum = 0;
  for (std::size_t b = 0; b < buckets; ++b) {
    result.offset[b] = sum;
    for (auto& places : next) {
      const std::uint32_t count = places[b];
      places[b] = sum;
      sum += count;
    }
  }
  result.offset[buckets] = sum;
  result.values.resize(sum);
  parallel::parallelFor(parts, threads, uncancelled, 1, [&](std::size_t part) {
    forPart(part, [&](std::size_t bucket, const T& value) { result.values[next[part][bucket]++] = value; });
  });
  return result;
}

}  // namespace thicken::mesh
