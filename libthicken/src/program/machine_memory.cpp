// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/machine_memory.h"

#include <unistd.h>

#include <algorithm>
#include <climits>
#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace thicken::program {

std::size_t machineMemory() noexcept {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 0;
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(size);
}

void keepFreedMemory() noexcept {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the largest that there is
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

void returnFreedArrays(std::size_t limit) noexcept {
#if defined(__GLIBC__)
  // Bytes; left alone, the C library raises it to that of what was freed. A hundred arrays that are free and
  // kept are a tenth of the limit then.
  constexpr std::size_t kLeast = std::size_t{1} << 18, kMost = std::size_t{32} << 20, kShare = 1000;
  const int large = static_cast<int>(std::clamp(limit / kShare, kLeast, kMost));
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, large);
#else
  static_cast<void>(limit);
#endif
}

}  // namespace thicken::program
