// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/in_windows.h"

#include <algorithm>
#include <utility>

#include "field/uniform_grid.h"
#include "parallel/parallel_for.h"
#include "reconstruct/cells.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

using job::Job;
using job::Stopwatch;
using mesh::Bounds;

namespace {

// How many times as far as usual windows reach that are too narrow. In the end, where they are not parts of
// an attempt, one is all: no grid has so many cells in a row.
constexpr double kWider = 16, kAll = field::UniformGrid::kMostCells;

struct Outcome {
  std::optional<Reconstruction> made;
  bool isKnown = false;
  bool isTooNarrow = false;  // what would be made does not stay within the window
};

class Closer {
 public:
  Closer(const Job& job, const Holes& holes, const WindowTask& task)
      : job_(job), holes_(holes), task_(task) {}

  InWindows run() {
    windows_ = windowsOf(job_, holes_, task_.width);
    if (!task_.meetingIn) job_.watch.lap("plan");
    outcomes_.resize(windows_.size());
    closeEach();
    for (double times = kWider;; times = kAll) {
      const std::vector<Bounds> narrow = zonesWhere([](const Outcome& o) { return o.isTooNarrow; });
      const std::vector<Bounds> stuck = zonesWhere([](const Outcome& o) { return !o.made; });
      if (narrow.empty() || (task_.meetingIn && (times == kAll || narrow.size() < stuck.size()))) break;
      widen({narrow, times});
      // A window that is the whole boundary would be the same attempt again.
      if (!task_.meetingIn && times < kAll && hasAllInOne()) widen({narrow, times = kAll});
      closeEach();
      if (times == kAll) break;
    }
    InWindows in;
    in.stuck = zonesWhere([](const Outcome& o) { return !o.made; });
    in.windows = std::move(windows_);
    for (Outcome& outcome : outcomes_) in.made.push_back(std::move(outcome.made));
    return in;
  }

 private:
  template <class Is>
  [[nodiscard]] std::vector<Bounds> zonesWhere(Is is) const {
    std::vector<Bounds> zones;
    for (std::size_t i = 0; i < windows_.size(); ++i)
      if (is(outcomes_[i])) zones.push_back(windows_[i].zone);
    return zones;
  }

  [[nodiscard]] bool hasAllInOne() const {
    return std::ranges::any_of(
        windows_, [this](const Window& window) { return window.source.size() == holes_.keep.size(); });
  }

  void closeEach() {
    if (task_.meetingIn) {
      for (std::size_t i = 0; i < windows_.size(); ++i) {
        if (!outcomes_[i].isKnown) outcomes_[i] = close(windows_[i], job_.threads, job_.watch);
        if (!outcomes_[i].made && !outcomes_[i].isTooNarrow && task_.stopsAtFirst) return;
      }
      return;
    }
    // A working set is for one contour at a time where memory is limited.
    const bool beside = windows_.size() > 1 && job_.context.memoryLimit() == 0;
    parallel::parallelFor(windows_.size(), beside ? job_.threads : 1, job_.context, 1, [&](std::size_t i) {
      Stopwatch own;
      if (!outcomes_[i].isKnown) outcomes_[i] = close(windows_[i], beside ? 1 : job_.threads, own);
    });
    job_.watch.lap("regions");
  }

  // Wider windows where these are too narrow. What was made in the others stays.
  void widen(const TooNarrow& narrow) {
    std::vector<Window> wide = windowsOf(job_, holes_, task_.width, narrow);
    std::vector<Outcome> outcomes(wide.size());
    for (std::size_t i = 0; i < wide.size(); ++i)
      for (std::size_t k = 0; k < windows_.size(); ++k)
        if (windows_[k].zone.low == wide[i].zone.low && windows_[k].zone.high == wide[i].zone.high)
          outcomes[i] = std::move(outcomes_[k]);
    windows_ = std::move(wide);
    outcomes_ = std::move(outcomes);
  }

  [[nodiscard]] Outcome close(const Window& window, int threads, Stopwatch& watch) const {
    ContourTask task;
    task.width = task_.width;
    task.mayKeepShell = task_.mayKeepShell;
    task.refined = task_.refined;
    task.area = window.area;
    if (!(task.area > 0) || (!task_.anyArea && !fewCells(task.width, task.area)))
      return {std::nullopt, true, false};
    std::size_t own = task_.attempts * window.source.size();
    task.allowance = task_.attempts > 0 ? &own : task_.allowance;
    if (task_.meetingIn) task.meeting = task_.meetingIn(window.zone);
    task.crossings = mostCrossings(task.area, task.width);
    task.working = workingSetFor(task.crossings, task_.held, job_.context);
    task.keep = window.part.keep;
    task.openable = window.part.openable;
    task.left = window.part.left;
    task.cut = window.cut;
    try {
      const ClosestPointTree tree(window.surface, threads);
      const Job part{window.surface, tree,         job_.thickness.of(window.surface, window.vertex),
                     job_.options,   job_.context, threads,
                     watch};
      requireCells(part, task.width);
      auto made = task_.complete(part, window.part.carried, std::move(task));
      if (made && !staysWithin(window, *made)) return {std::nullopt, true, true};
      return {std::move(made), true, false};
    } catch (const LeavesWindow&) {
      return {std::nullopt, true, true};
    } catch (const Error& e) {
      if (e.code() != ErrorCode::kNoSolid && e.code() != ErrorCode::kMemoryLimit) throw;
      return {std::nullopt, true, false};
    }
  }

  const Job& job_;
  const Holes& holes_;
  const WindowTask& task_;
  std::vector<Window> windows_;
  std::vector<Outcome> outcomes_;
};

}  // namespace

InWindows completeInWindows(const Job& job, const Holes& holes, const WindowTask& task) {
  return Closer(job, holes, task).run();
}

bool fewCells(double width, double area) {
  constexpr double kMostCells = 1e5;
  return area <= kMostCells * width * width;
}

}  // namespace thicken::reconstruct
