// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A copyable handle to one run: the caller keeps one copy to poll progress and to cancel, the
// library gets another. The library never calls back into the caller, from no thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

namespace thicken {

enum class Stage {
  kWaiting,
  kReading,
  kChecking,
  kSweeping,
  kField,
  kContouring,
  kShaping,
  kJoining,
  kAuditing,
  kMeasuring,
  kWriting,
  kDone
};

/// The stage as it is printed: "checking", "sweeping", …
[[nodiscard]] std::string_view name(Stage stage) noexcept;

class RunContext {
 public:
  RunContext();

  /// Asks the run to stop. Any thread, any number of times. The run ends with ErrorCode::kCancelled
  /// well within a second, unless an error or the result came first.
  void cancel() noexcept;
  [[nodiscard]] bool cancelled() const noexcept;

  /// Share of the whole run that is done, in [0, 1]; never goes down during a run.
  [[nodiscard]] double progress() const noexcept;
  [[nodiscard]] Stage stage() const noexcept;

  /// Bytes that the run may take; 0: no limit. Set it before the run. A contour that does not fit is worked
  /// through with less in memory at a time, with the same result, and refused where that is still too much.
  void setMemoryLimit(std::size_t bytes) noexcept;
  [[nodiscard]] std::size_t memoryLimit() const noexcept;

  /// Seconds that the run may take from now on; 0: no limit. Set it before the run, which then ends with
  /// ErrorCode::kTimeLimit as soon after that as it would end when cancelled.
  void setTimeLimit(double seconds) noexcept;

  /// What the run counts as its whole progress is the part [begin, end] of the caller's.
  void setPart(double begin, double end) noexcept;
  /// That part; [0, 1] where none was set.
  [[nodiscard]] std::pair<double, double> part() const noexcept;

  // --- for the library's own stages ---
  // The progress is made of work that is counted, not of time. How much a stage takes is an estimate: the
  // first three quarters of its part are linear in the work that was done, the rest comes ever more slowly.

  /// Enters a stage, which is the part [begin, end] of the run and takes about `work` units. Where the run
  /// has come farther already, as when something is tried once more, it is a like part of what remains.
  void enter(Stage stage, double begin, double end, double work) const noexcept;
  /// Enters a stage that is a part of the last one that was entered with its share.
  void enter(Stage stage) const noexcept;
  /// Tells that units of work are done. A block of a parallel loop is one: parallelFor() counts them.
  void count(std::size_t units = 1) const noexcept;
  /// Units that were counted since the handle was made.
  [[nodiscard]] std::size_t counted() const noexcept;
  /// Throws Error(kCancelled) once cancel() was called, and Error(kTimeLimit) once the time limit is over.
  void throwIfCancelled() const;
  /// Throws Error(kMemoryLimit) when `bytes` exceed the limit; the sentence names both and `remedy`.
  void reserve(std::size_t bytes, std::string_view remedy) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace thicken
