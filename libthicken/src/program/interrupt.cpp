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

extern "C" void cancelInterrupted(int) {
  interrupted->cancel();
}

}  // namespace

void cancelOnInterrupt(const RunContext& context) {
  interrupted = new RunContext(context);
  std::signal(SIGINT, cancelInterrupted);
  std::signal(SIGTERM, cancelInterrupted);
}

}  // namespace thicken::program
