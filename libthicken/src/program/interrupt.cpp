// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/interrupt.h"

#include <unistd.h>

#include <csignal>

#include "thicken/error.h"
#include "thicken/io.h"

namespace thicken::program {
namespace {

// Never destroyed: a signal may arrive while the program ends.
RunContext* interrupted = nullptr;

// Only what is safe in a signal handler: lock-free atomics, unlink, write and _exit.
extern "C" void cancelInterrupted(int) {
  if (!interrupted->cancelled()) {
    interrupted->cancel();
    return;
  }
  abandonWrites();
  constexpr char kLastLine[] = "\nthicken: cancelled: the run was cut off; nothing was written\n";
  const auto written = write(STDERR_FILENO, kLastLine, sizeof kLastLine - 1);
  static_cast<void>(written);  // there is nobody else to tell
  _exit(exitStatus(ErrorCode::kCancelled));
}

}  // namespace

void cancelOnInterrupt(const RunContext& context) {
  interrupted = new RunContext(context);
  std::signal(SIGINT, cancelInterrupted);
  std::signal(SIGTERM, cancelInterrupted);
}

}  // namespace thicken::program
