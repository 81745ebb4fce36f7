// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Threads that wait for work without using the processor. The thread that asks for work does it itself.
// Others help if the machine has time for them. Nothing waits for those that have not begun: on a busy
// machine a loop takes no longer than on one thread.
#pragma once

#include <functional>

namespace thicken::parallel {

/// Calls `work` on the calling thread, and on up to `helpers` other threads until the first call has
/// returned. Returns when all calls have. `work` must not throw. All calls have the caller's floating-point
/// environment.
void runWithHelpers(int helpers, const std::function<void()>& work);

}  // namespace thicken::parallel
