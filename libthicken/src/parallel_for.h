// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The one place with OpenMP loops: threads, cancel checks, and exceptions that must not leave a
// parallel region.
#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

#include <cstddef>
#include <exception>

#include "thicken/run_context.h"

namespace thicken {

/// Threads that a request of `threads` (0: all) means.
[[nodiscard]] inline int threadCount(int threads) {
#ifdef _OPENMP
  return threads > 0 ? threads : omp_get_max_threads();
#else
  return threads > 0 ? threads : 1;
#endif
}

/// Calls body(i) for i in [0, n), in blocks of `grain`, on `threads` threads. Results must go to
/// places addressed by i, so that they do not depend on the schedule. The exception of the lowest
/// failing block is rethrown; a cancelled context ends the loop with kCancelled.
template <class Body>
void parallelFor(std::size_t n, int threads, const RunContext& context, std::size_t grain, Body body) {
  const std::size_t blocks = (n + grain - 1) / grain;
  std::exception_ptr error;
  std::size_t errorBlock = blocks;
  const int count = threadCount(threads);
#pragma omp parallel for schedule(dynamic, 1) num_threads(count) if (count > 1 && blocks > 1)
  for (std::size_t b = 0; b < blocks; ++b) {
    try {
      context.throwIfCancelled();
      const std::size_t end = b + 1 < blocks ? (b + 1) * grain : n;
      for (std::size_t i = b * grain; i < end; ++i) body(i);
    } catch (...) {
#pragma omp critical(thicken_parallel_for)
      if (b < errorBlock) {
        errorBlock = b;
        error = std::current_exception();
      }
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace thicken
