// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/close_finer.h"

#include <algorithm>
#include <utility>

#include "reconstruct/holes.h"
#include "thicken/error.h"

namespace thicken {

namespace {

// The triangles of `meeting` that reach into the zones.
std::vector<TriangleId> meetingIn(const Assembly& assembly, std::span<const TriangleId> meeting,
                                  std::span<const Bounds> zones) {
  std::vector<TriangleId> in;
  for (const TriangleId t : meeting)
    if (overlapsAny(zones, boundsOf(assembly.mesh, assembly.mesh.triangles[t]))) in.push_back(t);
  return in;
}

// The zones of the windows that come near what was given up.
std::vector<Bounds> zonesAmong(std::span<const Window> windows, std::span<const Bounds> givenUp) {
  std::vector<Bounds> zones;
  for (const Window& window : windows)
    if (overlapsAny(givenUp, window.zone)) zones.push_back(window.zone);
  return zones;
}

// Windows, and what could be made in them.
struct Tried {
  std::vector<Window> windows;
  std::vector<std::optional<Reconstruction>> made;
  std::vector<Bounds> stuck;  // zones where nothing could be
  bool mayWiden = true;       // whether wider windows may do for all of these
};

// The same with wider windows where nothing could be made. What was made in the others stays.
Tried widened(const TriangleMesh& surface, const Holes& holes, double r, double width, int threads,
              Tried narrow) {
  Tried wide{windowsOf(surface, holes, r, width, threads, narrow.stuck), {}, {}};
  for (const Window& window : wide.windows) {
    auto& made = wide.made.emplace_back();
    for (std::size_t i = 0; i < narrow.windows.size(); ++i)
      if (narrow.windows[i].zone.low == window.zone.low && narrow.windows[i].zone.high == window.zone.high)
        made = std::move(narrow.made[i]);
  }
  return wide;
}

}  // namespace

Closing closedFiner(const TriangleMesh& surface, const ClosestPointTree& tree, const SweepResult& swept,
                    const ContourTask& task, const Attempt& attempt, std::span<const TriangleId> meeting,
                    std::vector<Bounds>& givenUp, const Options& options, const RunContext& context,
                    int threads, Stopwatch& watch) {
  constexpr double kFiner = 0.5;
  constexpr std::size_t kCarriedBytes = 700;  // for each triangle of the carrier beyond S
  constexpr int kMostTimes = 5;
  // What meets along a curve at any width meets in twice as many triangles of half the size.
  constexpr double kGrowth = 1.5;
  Closing closing{std::nullopt, {meeting.begin(), meeting.end()}};
  const bool isHopeless = task.refined > 0 && double(meeting.size()) > kGrowth * double(task.meeting);
  if (task.refined == kMostTimes || isHopeless) return closing;
  const std::size_t carried = attempt.assembly().mesh.triangles.size() - surface.triangles.size();
  const std::size_t held = heldBytes(surface) + carried * kCarriedBytes;
  if (const std::size_t limit = context.memoryLimit(); limit != 0 && held > limit) return closing;
  const auto holes = holesOf(surface, swept, attempt, task, meeting, context, threads);
  if (!holes) return closing;
  ContourTask finer;
  finer.width = kFiner * task.width;
  finer.refined = task.refined + 1;
  finer.allowance = task.allowance;
  Tried tried{windowsOf(surface, *holes, options.thickness, finer.width, threads), {}, {}};
  if (tried.windows.empty()) return closing;
  std::vector<Bounds> stuck = zonesAmong(tried.windows, givenUp);
  const bool isOpen = stuck.empty();
  if (isOpen) {
    const auto closeEach = [&] {
      for (std::size_t i = 0; i < tried.windows.size(); ++i) {
        if (tried.made[i]) continue;
        const Window& window = tried.windows[i];
        finer.meeting = meetingIn(attempt.assembly(), meeting, {&window.zone, 1}).size();
        InWindow in = completeWindow(surface, tree, window, finer, held, options, context, threads, watch);
        tried.made[i] = std::move(in.made);
        if (tried.made[i]) continue;
        tried.stuck.push_back(window.zone);
        tried.mayWiden &= in.isTooNarrow;
        // The others are tried, too, where it is of use to know all that cannot be closed.
        if (!in.isTooNarrow && !task.mayKeepShell) return;
      }
    };
    tried.made.resize(tried.windows.size());
    closeEach();
    stuck = tried.stuck;
    if (!stuck.empty() && tried.mayWiden) {
      tried = widened(surface, *holes, options.thickness, finer.width, threads, std::move(tried));
      closeEach();
      std::erase_if(stuck, [&](const Bounds& zone) { return !overlapsAny(tried.stuck, zone); });
    }
    if (!stuck.empty() && !task.mayKeepShell) return closing;
  }
  if (stuck.empty()) {
    closing.made = withWindows(surface, *holes, tried.windows, tried.made);
    if (!closing.made) return closing;
    for (VertexId& v : closing.made->origin)
      if (v >= swept.mesh.positions.size()) v = kNone;
    return closing;
  }
  if (isOpen) givenUp.insert(givenUp.end(), stuck.begin(), stuck.end());
  if (auto there = meetingIn(attempt.assembly(), meeting, stuck); !there.empty())
    closing.stuck = std::move(there);
  return closing;
}

InWindow completeWindow(const TriangleMesh& surface, const ClosestPointTree& tree, const Window& window,
                        ContourTask task, std::size_t held, const Options& options, const RunContext& context,
                        int threads, Stopwatch& watch) {
  task.area = window.area;
  if (!(task.area > 0) || !fewCells(task.width, task.area)) return {};
  task.crossings = mostCrossings(task.area, task.width);
  task.working = workingSetFor(task.crossings, held, context);
  task.keep = window.part.keep;
  task.openable = window.part.openable;
  task.left = window.part.left;
  task.cut = window.cut;
  try {
    requireCells(surface, options.thickness, task.width);
    auto made =
        complete(surface, tree, window.part.carried, std::move(task), options, context, threads, watch);
    if (made && !staysWithin(window, *made)) return {std::nullopt, true};
    return {std::move(made), false};
  } catch (const LeavesWindow&) {
    return {std::nullopt, true};
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) throw;
    return {};
  }
}

std::size_t allowanceFor(std::size_t triangles) {
  constexpr std::size_t kLeast = 3'000'000, kTimes = 4;
  return std::max(kLeast, kTimes * triangles);
}

bool fewCells(double width, double area) {
  constexpr double kMostCells = 1e5;
  return area <= kMostCells * width * width;
}

}  // namespace thicken
