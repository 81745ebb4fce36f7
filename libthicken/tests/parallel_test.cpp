// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is done on several threads must not depend on how many they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <map>
#include <numeric>
#include <random>
#include <thread>

#include "field/block_bits.h"
#include "field/block_index.h"
#include "mesh/buckets.h"
#include "mesh/parallel_sort.h"
#include "mesh/union_find.h"
#include "parallel/parallel_for.h"

namespace thicken {

using field::BlockIndex;
using field::UniformGrid;
using mesh::intoBuckets;
using parallel::parallelFor;

namespace {

constexpr std::size_t kMany = 100'000;  // enough to be shared out

std::vector<std::uint32_t> someNumbers(std::size_t count, std::uint32_t below) {
  std::mt19937 random(7);
  std::vector<std::uint32_t> numbers(count);
  for (std::uint32_t& n : numbers) n = random() % below;
  return numbers;
}

TEST(ParallelFor, CallsEveryNumberOnceOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 5}) {
    std::vector<std::atomic<int>> called(10'000);
    parallelFor(called.size(), threads, RunContext(), 7, [&](std::size_t i) { ++called[i]; });
    EXPECT_TRUE(std::all_of(called.begin(), called.end(), [](const auto& n) { return n == 1; })) << threads;
  }
}

TEST(ParallelFor, MayBeCalledWithinAnotherAndFromSeveralThreadsAtATime) {
  std::atomic<std::size_t> sum = 0;
  const auto nested = [&] {
    parallelFor(20, 3, RunContext(), 1, [&](std::size_t i) {
      parallelFor(100, 3, RunContext(), 1, [&](std::size_t k) { sum += 100 * i + k; });
    });
  };
  std::vector<std::thread> callers;
  for (int i = 0; i < 4; ++i) callers.emplace_back(nested);
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(sum, 4u * 2000 * 1999 / 2);
}

TEST(ParallelFor, RethrowsTheExceptionOfTheLowestBlock) {
  for (const int threads : {1, 4}) {
    try {
      parallelFor(1000, threads, RunContext(), 1, [](std::size_t i) {
        if (i >= 500) throw i;
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::size_t i) {
      EXPECT_EQ(i, 500u) << threads;
    }
  }
}

// Helpers are kept from loop to loop, and must not keep the mode of an earlier one.
TEST(ParallelFor, RoundsAsTheCallingThreadDoes) {
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_TONEAREST}) {
    std::fesetround(mode);
    std::atomic<int> others = 0;
    parallelFor(1000, 4, RunContext(), 1, [&](std::size_t) { others += std::fegetround() != mode; });
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(others, 0) << mode;
  }
}

TEST(ParallelSort, SortsOnAnyNumberOfThreads) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, kMany}) {
    const auto numbers = someNumbers(count, 5000);
    auto expected = numbers;
    std::sort(expected.begin(), expected.end());
    for (const int threads : {1, 2, 3, 4, 8}) {
      auto sorted = numbers;
      mesh::parallelSort(sorted, std::less<>(), threads);
      EXPECT_EQ(sorted, expected) << count << " on " << threads;
    }
  }
}

TEST(MergeRuns, MergesRunsOfAnyLength) {
  const auto numbers = someNumbers(kMany, 1'000'000);
  auto expected = numbers;
  std::sort(expected.begin(), expected.end());
  const std::vector<std::size_t> bounds{0, 0, 10, 50'000, 50'001, 50'001, 99'000, kMany};
  for (const int threads : {1, 2, 4}) {
    auto items = numbers;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i)
      std::sort(items.begin() + static_cast<std::ptrdiff_t>(bounds[i]),
                items.begin() + static_cast<std::ptrdiff_t>(bounds[i + 1]));
    mesh::mergeRuns(items, bounds, std::less<>(), threads);
    EXPECT_EQ(items, expected) << threads;
  }
}

TEST(Buckets, HoldValuesInTheOrderOfTheItems) {
  constexpr std::size_t kBuckets = 300;
  const auto bucket = someNumbers(kMany, kBuckets);
  std::vector<std::vector<std::uint32_t>> expected(kBuckets);
  for (std::uint32_t i = 0; i < kMany; ++i)
    if (i % 7 != 0) expected[bucket[i]].push_back(i);
  for (const int threads : {1, 2, 3, 16}) {
    const auto buckets =
        intoBuckets<std::uint32_t>(kMany, kBuckets, threads, [&](std::size_t i, const auto& put) {
          if (i % 7 != 0) put(bucket[i], static_cast<std::uint32_t>(i));
        });
    ASSERT_EQ(buckets.offset.size(), kBuckets + 1);
    for (std::size_t b = 0; b < kBuckets; ++b)
      EXPECT_EQ(std::vector(buckets.values.begin() + buckets.offset[b],
                            buckets.values.begin() + buckets.offset[b + 1]),
                expected[b]);
  }
  EXPECT_EQ(intoBuckets<int>(0, 0, 2, [](std::size_t, const auto&) {}).offset.size(), 1u);
}

// Chains that many threads join at both ends and in the middle.
TEST(UnionFind, HasTheSmallestMemberAsRootOnAnyNumberOfThreads) {
  constexpr std::uint32_t kSets = 10;
  auto order = someNumbers(kMany, kMany);
  for (const int threads : {1, 2, 4}) {
    mesh::UnionFind sets(kMany + kSets);
    sets.joinAll(2 * kMany, threads, [&](std::size_t i) {
      const std::uint32_t a = i < kMany ? static_cast<std::uint32_t>(kMany - 1 - i) : order[i - kMany];
      return std::pair(a + kSets, a);
    });
    const auto roots = sets.roots(threads);
    for (std::uint32_t i = 0; i < roots.size(); ++i) ASSERT_EQ(roots[i], i % kSets) << threads;
  }
}

TEST(BlockIndex, NumbersKeysAsTheyArrive) {
  BlockIndex index;
  std::map<std::uint64_t, std::uint32_t> expected;
  for (const std::uint32_t n : someNumbers(20'000, 1 << 15)) {
    const std::uint64_t key = UniformGrid::key(
        {static_cast<int>(n & 31), static_cast<int>(n >> 5 & 31), 1000 + static_cast<int>(n >> 10)});
    const bool isNew = !expected.contains(key);
    if (isNew) {
      EXPECT_EQ(index.find(key), BlockIndex::kAbsent);
      expected.emplace(key, static_cast<std::uint32_t>(expected.size()));
    }
    EXPECT_EQ(index.insert(key), (std::pair{expected.at(key), isNew}));
  }
  EXPECT_EQ(index.size(), expected.size());
  for (const auto& [key, number] : expected) {
    EXPECT_EQ(index.find(key), number);
    EXPECT_EQ(index.keys()[number], key);
  }
}

TEST(BlockBits, AreThoseThatWereSet) {
  field::BlockBits<3> bits;
  std::map<std::uint64_t, std::uint8_t> expected;
  for (const std::uint32_t n : someNumbers(20'000, 1 << 15)) {
    const std::uint64_t key = UniformGrid::key({static_cast<int>(n & 31), static_cast<int>(n >> 5 & 31), 7});
    const auto some = static_cast<std::uint8_t>(1 << (n >> 10) % 3);
    EXPECT_EQ(bits.set(key, some), expected[key]);
    expected[key] |= some;
  }
  for (const auto& [key, set] : expected) EXPECT_EQ(bits.of(key), set);
  EXPECT_EQ(bits.of(UniformGrid::key({40, 0, 7})), 0);
}

}  // namespace
}  // namespace thicken
