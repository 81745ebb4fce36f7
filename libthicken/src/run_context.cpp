// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/run_context.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "thicken/error.h"

namespace thicken {

namespace {

// Of what is counted before any stage was entered, as in a check by itself.
constexpr double kUnknownWork = 1000;

// A NaN counts as nothing done.
double clampShare(double share) noexcept {
  return std::isnan(share) ? 0 : std::clamp(share, 0.0, 1.0);
}

// The share of a stage that is done after `x` times the work that was expected of it.
double doneAfter(double x) noexcept {
  constexpr double kLinear = 0.75;
  return x <= 1 ? kLinear * x : 1 - (1 - kLinear) / std::sqrt(x);
}

}  // namespace

// Each value stands for itself and nothing is published through it: relaxed order is enough. The
// program cancels from a signal handler, which only lock-free atomics allow.
struct RunContext::State {
  std::atomic<bool> cancelled{false};
  std::atomic<double> progress{0};
  std::atomic<double> partBegin{0}, partEnd{1};
  // Of the run's own progress, which partBegin and partEnd are not part of.
  std::atomic<double> stageBegin{0}, stageEnd{1}, stageWork{kUnknownWork};
  std::atomic<std::size_t> work{0}, workBefore{0};
  std::atomic<Stage> stage{Stage::kWaiting};
  std::atomic<std::size_t> memoryLimit{0};
  std::atomic<double> timeLimit{0};
  std::atomic<std::int64_t> deadline{0};  // ticks of the steady clock; 0: none

  // The run's own share, of `progress`.
  [[nodiscard]] double done() const noexcept {
    const double begin = partBegin.load(std::memory_order_relaxed);
    const double end = partEnd.load(std::memory_order_relaxed);
    if (!(end > begin)) return 0;
    return clampShare((progress.load(std::memory_order_relaxed) - begin) / (end - begin));
  }

  static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<double>::is_always_lock_free);

  // `share` is of the run, whatever part of the caller's that is.
  void raiseProgress(double share) noexcept {
    const double begin = partBegin.load(std::memory_order_relaxed);
    const double end = partEnd.load(std::memory_order_relaxed);
    share = begin + share * (end - begin);
    double seen = progress.load(std::memory_order_relaxed);
    while (share > seen && !progress.compare_exchange_weak(seen, share, std::memory_order_relaxed)) {
    }
  }
};

namespace {

using Clock = std::chrono::steady_clock;

std::string mebibytes(std::size_t bytes) {
  constexpr std::size_t kMebibyte = std::size_t{1} << 20;
  return std::to_string(bytes / kMebibyte + (bytes % kMebibyte != 0)) + " MiB";
}

// The work that is left may be slower than what is done.
constexpr double kEnoughTimes = 2;
constexpr double kLeastProgress = 0.01;

Error timeIsOver(double limit, double progress) {
  std::ostringstream sentence;
  sentence
      << "the run was stopped at its time limit of " << limit << " s, with about "
      << std::lround(100 * progress)
      << " % of it done; nothing was written; allow more time, or use a coarser surface or a larger cell";
  Error error(ErrorCode::kTimeLimit, sentence.str());
  error.setEnoughSeconds(kEnoughTimes * limit / std::max(progress, kLeastProgress));
  return error;
}

}  // namespace

std::string_view name(Stage stage) noexcept {
  switch (stage) {
    case Stage::kWaiting:
      return "waiting";
    case Stage::kReading:
      return "reading";
    case Stage::kChecking:
      return "checking";
    case Stage::kSweeping:
      return "sweeping";
    case Stage::kField:
      return "field";
    case Stage::kContouring:
      return "contouring";
    case Stage::kShaping:
      return "shaping";
    case Stage::kJoining:
      return "joining";
    case Stage::kAuditing:
      return "auditing";
    case Stage::kMeasuring:
      return "measuring";
    case Stage::kWriting:
      return "writing";
    case Stage::kDone:
      return "done";
  }
  return "unknown";
}

RunContext::RunContext() : state_(std::make_shared<State>()) {}

void RunContext::cancel() noexcept {
  state_->cancelled.store(true, std::memory_order_relaxed);
}

bool RunContext::cancelled() const noexcept {
  return state_->cancelled.load(std::memory_order_relaxed);
}

double RunContext::progress() const noexcept {
  return state_->progress.load(std::memory_order_relaxed);
}

Stage RunContext::stage() const noexcept {
  return state_->stage.load(std::memory_order_relaxed);
}

void RunContext::setMemoryLimit(std::size_t bytes) noexcept {
  state_->memoryLimit.store(bytes, std::memory_order_relaxed);
}

std::size_t RunContext::memoryLimit() const noexcept {
  return state_->memoryLimit.load(std::memory_order_relaxed);
}

void RunContext::setTimeLimit(double seconds) noexcept {
  constexpr double kMost = 1e9;  // beyond any run, and its ticks fit 64 bits
  const std::chrono::duration<double> given(std::min(seconds, kMost));
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(given);
  state_->timeLimit.store(seconds, std::memory_order_relaxed);
  state_->deadline.store(seconds > 0 ? end.time_since_epoch().count() : 0, std::memory_order_relaxed);
}

void RunContext::setPart(double begin, double end) noexcept {
  const double from = clampShare(begin);
  state_->partBegin.store(from, std::memory_order_relaxed);
  state_->partEnd.store(std::max(from, clampShare(end)), std::memory_order_relaxed);
  state_->stageBegin.store(0, std::memory_order_relaxed);
  state_->stageEnd.store(1, std::memory_order_relaxed);
  state_->raiseProgress(0);
}

std::pair<double, double> RunContext::part() const noexcept {
  return {state_->partBegin.load(std::memory_order_relaxed), state_->partEnd.load(std::memory_order_relaxed)};
}

void RunContext::enter(Stage stage, double begin, double end, double work) const noexcept {
  const double from = clampShare(begin);
  const double share = from < 1 ? (std::max(from, clampShare(end)) - from) / (1 - from) : 0;
  const double before = std::max(from, state_->done());
  state_->stage.store(stage, std::memory_order_relaxed);
  state_->stageBegin.store(before, std::memory_order_relaxed);
  state_->stageEnd.store(before + share * (1 - before), std::memory_order_relaxed);
  state_->stageWork.store(work > 0 ? work : kUnknownWork, std::memory_order_relaxed);
  state_->workBefore.store(counted(), std::memory_order_relaxed);
  state_->raiseProgress(before);
}

void RunContext::enter(Stage stage) const noexcept {
  state_->stage.store(stage, std::memory_order_relaxed);
}

void RunContext::count(std::size_t units) const noexcept {
  const std::size_t work = state_->work.fetch_add(units, std::memory_order_relaxed) + units;
  const double done = static_cast<double>(work - state_->workBefore.load(std::memory_order_relaxed)) /
                      state_->stageWork.load(std::memory_order_relaxed);
  const double begin = state_->stageBegin.load(std::memory_order_relaxed);
  const double end = state_->stageEnd.load(std::memory_order_relaxed);
  state_->raiseProgress(begin + doneAfter(done) * (end - begin));
}

std::size_t RunContext::counted() const noexcept {
  return state_->work.load(std::memory_order_relaxed);
}

void RunContext::throwIfCancelled() const {
  if (cancelled()) throw Error(ErrorCode::kCancelled, "the run was cancelled; nothing was written");
  const std::int64_t deadline = state_->deadline.load(std::memory_order_relaxed);
  if (deadline != 0 && Clock::now().time_since_epoch().count() >= deadline)
    throw timeIsOver(state_->timeLimit.load(std::memory_order_relaxed), progress());
}

void RunContext::reserve(std::size_t bytes, std::string_view remedy) const {
  const std::size_t limit = memoryLimit();
  if (limit == 0 || bytes <= limit) return;
  std::string sentence = "the run would need about " + mebibytes(bytes) +
                         " of memory, more than the limit of " + mebibytes(limit);
  sentence += remedy.empty() ? "" : ": " + std::string(remedy);
  Error error(ErrorCode::kMemoryLimit, sentence);
  error.setEnoughMemory(bytes);
  throw error;
}

}  // namespace thicken
