// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/progress_line.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

#include "platform/process.h"

namespace thicken::program {
namespace {

constexpr std::chrono::milliseconds kInterval{100};
constexpr double kWorthTelling = 2;  // seconds
constexpr const char* kWipeLine = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine(RunContext context, bool quiet) : context_(std::move(context)) {
  if (quiet || !platform::stderrIsTerminal()) return;
  try {
    thread_ = std::thread([this] { show(); });
  } catch (const std::system_error&) {
    // No thread to be had: the run is worth more than its progress line.
  }
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void ProgressLine::show() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kInterval, [this] { return ended_; })) {
    // A tenth of a percent, so that a long run is seen to move.
    const double percent = std::floor(1000 * context_.progress()) / 10;
    const std::string told =
        expected_ >= kWorthTelling ? fmt::format(", about {:.0f} s in all", expected_.load()) : "";
    std::cerr << kWipeLine << fmt::format("{:5.1f} % {}{}", percent, name(context_.stage()), told)
              << std::flush;
  }
  std::cerr << kWipeLine << std::flush;
}

}  // namespace thicken::program
