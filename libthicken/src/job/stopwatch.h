// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Wall-clock seconds of the stages of a run.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace thicken::job {

class Stopwatch {
 public:
  /// Ends a stage that began at the end of the last one.
  void lap(std::string stage) {
    const auto now = std::chrono::steady_clock::now();
    laps_.emplace_back(std::move(stage), std::chrono::duration<double>(now - last_).count());
    last_ = now;
  }
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& laps() const { return laps_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, double>> laps_;
};

}  // namespace thicken::job
