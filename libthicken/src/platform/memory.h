// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Memory of the process and of the machine. What a system cannot tell or do has no effect there.
#pragma once

#include <cstddef>

namespace thicken::platform {

/// Largest resident size of the process so far, bytes; 0 where the system does not say.
[[nodiscard]] std::size_t peakMemory() noexcept;

/// Bytes of memory that the machine has; 0 where it does not say.
[[nodiscard]] std::size_t machineMemory() noexcept;

/// Gives freed memory back to the system. The C library keeps it otherwise, and it counts against a limit on
/// what the process holds.
void returnFreedMemory() noexcept;

/// Has the process keep freed memory for later. Otherwise the system takes it and clears every page again: a
/// tenth of the time of a quick run.
void keepFreedMemory() noexcept;

/// From now on arrays that are large beside a memory limit of so many bytes go back to the system when they
/// are freed. Then the process holds about what it uses. It costs some time.
void returnFreedArrays(std::size_t limit) noexcept;

}  // namespace thicken::platform
