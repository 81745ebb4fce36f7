// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A line on the terminal that shows how far a run is.
#pragma once

#include <atomic>
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

  /// From now on the line also tells how long the whole run is likely to take, if that is worth telling.
  void expect(double seconds) { expected_ = seconds; }

 private:
  void show();

  RunContext context_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::atomic<double> expected_{0};  ///< seconds
  std::thread thread_;
};

}  // namespace thicken::program
