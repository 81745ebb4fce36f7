// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Loops on several threads, with cancel checks, and with exceptions that must not leave a thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

#include "parallel/thread_pool.h"
#include "thicken/run_context.h"

namespace thicken::parallel {

/// Threads that a request of `threads` (0: all) means.
[[nodiscard]] inline int threadCount(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Calls block(b) for b in [0, blocks), which must not throw, on up to `count` threads.
template <class Block>
void runBlocks(std::size_t blocks, int count, Block block) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t b; (b = next.fetch_add(1, std::memory_order_relaxed)) < blocks;) block(b);
  };
  const auto useful = static_cast<int>(std::min<std::size_t>(blocks, static_cast<std::size_t>(count)));
  runWithHelpers(useful - 1, work);
}

/// Calls body(i) for i in [0, n), in blocks of `grain`, on `threads` threads. Results must go to
/// places addressed by i, so that they do not depend on the schedule. The exception of the lowest
/// failing block is rethrown; a cancelled context ends the loop with kCancelled. Each block counts as a unit
/// of the context's work.
template <class Body>
void parallelFor(std::size_t n, int threads, const RunContext& context, std::size_t grain, Body body) {
  const std::size_t blocks = (n + grain - 1) / grain;
  std::exception_ptr error;
  std::size_t errorBlock = blocks;
  std::mutex guard;
  runBlocks(blocks, threadCount(threads), [&](std::size_t b) {
    try {
      context.throwIfCancelled();
      const std::size_t end = b + 1 < blocks ? (b + 1) * grain : n;
      for (std::size_t i = b * grain; i < end; ++i) body(i);
      context.count();
    } catch (...) {
      const std::lock_guard lock(guard);
      if (b >= errorBlock) return;
      errorBlock = b;
      error = std::current_exception();
    }
  });
  if (error) std::rethrow_exception(error);
}

/// Calls work(i, begin, end) for every part [begin, end) of [0, n), `part` long but for the last, as
/// parallelFor() does for every i.
template <class Work>
void parallelForParts(std::size_t n, int threads, const RunContext& context, std::size_t part, Work work) {
  parallelFor((n + part - 1) / part, threads, context, 1,
              [&](std::size_t i) { work(i, i * part, std::min(n, (i + 1) * part)); });
}

}  // namespace thicken::parallel
