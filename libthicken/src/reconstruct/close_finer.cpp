// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/close_finer.h"

#include <algorithm>
#include <utility>

#include "reconstruct/cells.h"
#include "reconstruct/holes.h"
#include "reconstruct/in_windows.h"

namespace thicken::reconstruct {

using mesh::Bounds;

namespace {

// The triangles of `meeting` that reach into the zones.
std::vector<TriangleId> meetingIn(const Assembly& assembly, std::span<const TriangleId> meeting,
                                  std::span<const Bounds> zones) {
  std::vector<TriangleId> in;
  for (const TriangleId t : meeting)
    if (mesh::overlapsAny(zones, mesh::boundsOf(assembly.mesh, assembly.mesh.triangles[t]))) in.push_back(t);
  return in;
}

}  // namespace

Closing closedFiner(const job::Job& job, const sweep::SweepResult& swept, const ContourTask& task,
                    const Attempt& attempt, std::span<const TriangleId> meeting, std::vector<Bounds>& givenUp,
                    Complete& complete) {
  constexpr double kFiner = 0.5;
  constexpr std::size_t kCarriedBytes = 700;  // for each triangle of the carrier beyond S
  constexpr int kMostTimes = 5;
  // Two sheets that cross along a curve meet in twice as many triangles where cells are half as wide.
  constexpr double kGrowth = 1.5;
  const Assembly& assembly = attempt.assembly();
  Closing closing{std::nullopt, {meeting.begin(), meeting.end()}};
  const bool isHopeless = task.refined > 0 && double(meeting.size()) > kGrowth * double(task.meeting);
  if (task.refined == kMostTimes || isHopeless) return closing;
  WindowTask finer;
  finer.complete = &complete;
  finer.held = heldBytes(job.surface) +
               kCarriedBytes * (assembly.mesh.triangles.size() - job.surface.triangles.size());
  if (const std::size_t limit = job.context.memoryLimit(); limit != 0 && finer.held > limit) return closing;
  const auto holes = holesOf(job, swept, attempt, task, meeting);
  if (!holes) return closing;
  finer.width = kFiner * task.width;
  finer.refined = task.refined + 1;
  finer.allowance = task.allowance;
  // The other windows are tried, too, where the caller wants to know all that cannot be closed.
  finer.stopsAtFirst = !task.mayKeepShell;
  finer.meetingIn = [&](const Bounds& zone) { return meetingIn(assembly, meeting, {&zone, 1}).size(); };
  std::vector<Bounds> stuck;
  if (const auto there = meetingIn(assembly, meeting, givenUp); there.empty()) {
    InWindows in = completeInWindows(job, *holes, finer);
    if (in.windows.empty()) return closing;
    if (in.stuck.empty()) {
      Reconstruction made = withWindows(job.surface, *holes, in.windows, in.made);
      if (!std::all_of(in.made.begin(), in.made.end(), [](const auto& own) { return own.has_value(); }))
        return closing;
      for (VertexId& v : made.origin)
        if (v >= swept.mesh.positions.size()) v = mesh::kNone;
      closing.made = std::move(made);
      return closing;
    }
    if (!task.mayKeepShell) return closing;
    stuck = in.stuck;
    givenUp.insert(givenUp.end(), stuck.begin(), stuck.end());
  } else {
    stuck = givenUp;
  }
  if (auto there = meetingIn(assembly, meeting, stuck); !there.empty()) closing.stuck = std::move(there);
  return closing;
}

}  // namespace thicken::reconstruct
