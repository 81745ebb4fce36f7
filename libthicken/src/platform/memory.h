// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Memory of the process and of the machine. What there is no way to ask or to do for on a system has no
// effect there.
#pragma once

#include <cstddef>

namespace thicken {

/// Largest resident size of the process so far, bytes; 0 where the system does not say.
[[nodiscard]] std::size_t peakMemory() noexcept;

/// Bytes of memory that the machine has; 0 where it does not say.
[[nodiscard]] std::size_t machineMemory() noexcept;

/// Gives back to the system what was freed: the C library keeps it for later, which counts against a limit on
/// what the process holds.
void returnFreedMemory() noexcept;

/// Has the process keep what it frees for what it allocates next, instead of returning it to the machine and
/// having every page zeroed again: that is a tenth of the time of a quick run.
void keepFreedMemory() noexcept;

/// From now on arrays that are large beside a memory limit of so many bytes go back to the system as soon as
/// they are freed, at the cost of some time, so that what the process holds is about what it uses.
void returnFreedArrays(std::size_t limit) noexcept;

}  // namespace thicken
