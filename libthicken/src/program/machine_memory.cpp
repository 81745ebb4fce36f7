// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/machine_memory.h"

#include <unistd.h>

namespace thicken::program {

std::size_t machineMemory() noexcept {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 0;
  return static_cast<std::size_t>(pages) * static_cast<std::size_t>(size);
}

}  // namespace thicken::program
