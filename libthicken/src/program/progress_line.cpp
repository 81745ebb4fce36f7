// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/progress_line.h"

#include <chrono>
#include <iomanip>
#include <iostream>
#include <system_error>
#include <utility>

#include "platform/process.h"

namespace thicken::program {
namespace {

constexpr std::chrono::milliseconds kInterval{100};
constexpr const char* kWipeLine = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine(RunContext context, bool quiet) : context_(std::move(context)) {
  if (quiet || !stderrIsTerminal()) return;
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
    std::cerr << kWipeLine << std::setw(3) << static_cast<int>(100 * context_.progress()) << " % "
              << name(context_.stage()) << std::flush;
  }
  std::cerr << kWipeLine << std::flush;
}

}  // namespace thicken::program
