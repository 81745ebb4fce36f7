// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Gives back to the system what was freed: the C library keeps it for later, which counts against a limit on
// what the process holds.
#pragma once

#include <cstdlib>  // says which C library it is

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace thicken {

inline void returnFreedMemory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace thicken
