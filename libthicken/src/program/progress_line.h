// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A line on the terminal that shows how far a run is.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "thicken/run_context.h"

namespace thicken::program {

/// Shows the progress of `context` on stderr until it is destroyed, which wipes the line. Shows
/// nothing where stderr is no terminal or `quiet` is set.
class ProgressLine {
 public:
  ProgressLine(RunContext context, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void show();

  RunContext context_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace thicken::program
