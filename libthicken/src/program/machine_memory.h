// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>

namespace thicken::program {

/// Bytes of memory that the machine has; 0 where it does not say.
[[nodiscard]] std::size_t machineMemory() noexcept;

}  // namespace thicken::program
