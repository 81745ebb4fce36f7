// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Long work without the GIL that Ctrl-C can still end.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <utility>

#include "thicken/run_context.h"

namespace thicken::python {

/// Runs `work` on a thread of its own and returns its result. The calling thread, which must hold
/// the GIL, gives it up meanwhile and looks for signals now and then; a signal handler that raises
/// (KeyboardInterrupt) cancels `context`, and its exception is thrown once the work has ended.
/// `work` must not touch Python. It does not wait longer than the work takes.
template <class Work>
auto runInterruptibly(RunContext context, Work work) {
  constexpr std::chrono::milliseconds kSignalInterval{50};
  const pybind11::gil_scoped_release released;
  auto future = std::async(std::launch::async, std::move(work));
  while (future.wait_for(kSignalInterval) != std::future_status::ready) {
    const pybind11::gil_scoped_acquire held;
    if (PyErr_CheckSignals() == 0) continue;
    const pybind11::error_already_set interruption;
    context.cancel();
    {
      const pybind11::gil_scoped_release releasedAgain;
      future.wait();
    }
    throw interruption;
  }
  return future.get();
}

}  // namespace thicken::python
