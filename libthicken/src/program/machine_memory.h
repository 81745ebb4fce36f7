// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace thicken::program {

/// Bytes of memory that the machine has; 0 where it does not say.
[[nodiscard]] std::size_t machineMemory() noexcept;

/// Has the process keep what it frees for what it allocates next, instead of returning it to the machine and
/// having every page zeroed again: that is a tenth of the time of a quick run.
void keepFreedMemory() noexcept;

/// From now on arrays that are large beside a memory limit of so many bytes go back to the system as soon as
/// they are freed, at the cost of some time, so that what the process holds is about what it uses.
void returnFreedArrays(std::size_t limit) noexcept;

}  // namespace thicken::program
