// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/interrupt.h"

#include <csignal>

#include "platform/process.h"
#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken::program {
namespace {

// Never destroyed: a signal may arrive while the program ends.
RunContext* interrupted = nullptr;

// Only what is safe in a signal handler: lock-free atomics, and what the platform says is.
extern "C" void cancelInterrupted(int) {
  if (!interrupted->cancelled()) {
    interrupted->cancel();
    return;
  }
  abandonWrites();
  platform::writeToStderr("\nthicken: cancelled: the run was cut off; nothing was written\n");
  platform::endProcess(exitStatus(ErrorCode::kCancelled));
}

}  // namespace

void cancelOnInterrupt(const RunContext& context) {
  interrupted = new RunContext(context);
  std::signal(SIGINT, cancelInterrupted);
  std::signal(SIGTERM, cancelInterrupted);
}

}  // namespace thicken::program
