// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/stopwatch.h"

#include <sys/resource.h>

namespace thicken {

std::size_t peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

}  // namespace thicken
