// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/machine_memory.h"

#include <unistd.h>

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

void returnFreedArrays() noexcept {
#if defined(__GLIBC__)
  constexpr int kLarge = 1 << 18;  // bytes; left alone, the C library raises it to that of what was freed
  mallopt(M_MMAP_THRESHOLD, kLarge);
  mallopt(M_TRIM_THRESHOLD, kLarge);
#endif
}

}  // namespace thicken::program
