// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Threads that wait for work without using the processor. The thread that asks for work does it itself;
// others come to help if the machine has time for them, and nothing waits for those that have not begun. So a
// loop takes no longer on a busy machine than it would on one thread.
#pragma once

#include <functional>

namespace thicken::detail {

/// Calls `work`, which must not throw, on the calling thread, and on up to `helpers` other threads until that
/// call has returned. Returns when all calls have. The floating-point environment is the caller's in all.
void runWithHelpers(int helpers, const std::function<void()>& work);

}  // namespace thicken::detail
