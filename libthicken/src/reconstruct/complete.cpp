// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/complete.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "measure/measure.h"
#include "reconstruct/attempt.h"
#include "reconstruct/carrier_shell.h"
#include "reconstruct/cells.h"
#include "reconstruct/close_finer.h"
#include "reconstruct/depths.h"
#include "reconstruct/drop_unused.h"
#include "reconstruct/holes.h"
#include "reconstruct/loose_parts.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

using job::Job;
using mesh::kNone;
using sweep::SweepResult;

namespace {

constexpr int kMostTakenBack = 16, kMostOpened = 12;  // times
// Cells of all attempts together before the whole sweep is taken, and attempts that are made in any case.
constexpr double kMostWork = 2.5e6;
constexpr std::size_t kSomeAttempts = 4;
// Of the triangles of an attempt, one in so many: what meets is little.
constexpr std::size_t kLittle = 1000;
// What a triangle that meets others costs while it is settled, in triangles that are just assembled.
constexpr std::size_t kMeetingCost = 100;

// The reach of an nth try, mm. It grows, so that tries end.
double reachOf(int times, double width) {
  constexpr double kFirst = 0.5, kGrowth = 1.4;  // cells
  return width * kFirst * std::pow(kGrowth, static_cast<double>(times));
}

[[noreturn]] void refuse(const Assembly& assembly, std::span<const TriangleId> meeting) {
  const Triangle& t = assembly.mesh.triangles[meeting.front()];
  const Vec3& p = assembly.mesh.positions[t[0]];
  Defect d;
  d.code = ErrorCode::kNoSolid;
  d.count = meeting.size();
  d.place = p;
  d.sentence = fmt::format(
      "the reconstructed surface meets itself near ({:.6g}, {:.6g}, {:.6g}); a smaller cell width may tell "
      "the sheets apart there",
      p.x(), p.y(), p.z());
  const std::string sentence = d.sentence;
  throw Error(ErrorCode::kNoSolid, sentence, {std::move(d)});
}

// Which triangles of the assembly are shell of the sweep that `left` marks as kept for want of better, and
// what their vertices are copies of.
void tellLeft(const Assembly& assembly, const SweepResult& swept, std::span<const std::uint8_t> left,
              Reconstruction& result) {
  for (TriangleId t = 0; t < assembly.carrierTriangles; ++t) {
    if (assembly.region[t] != Region::kShell || !left[assembly.source[t]]) continue;
    result.left.resize(assembly.region.size(), 0);
    result.left[t] = 1;
    result.leftArea += measure::areaOf(assembly.mesh.positions, assembly.mesh.triangles[t]);
  }
  if (result.left.empty()) return;
  result.base = swept.base;
  result.base.resize(assembly.mesh.positions.size(), kNone);
}

Reconstruction finish(Attempt& attempt, const TriangleMesh& surface, const SweepResult& swept,
                      const ContourTask& task) {
  Reconstruction result;
  const std::vector<Vec3>& up = attempt.carrier().up;
  for (VertexId v = 0; v < up.size(); ++v)
    if (!up[v].isZero(0)) result.ends.push_back({v, up[v]});
  Assembly assembly = attempt.takeAssembly();
  tellLeft(assembly, swept, task.left, result);
  result.openable = openableOf(assembly, task);
  result.mesh = std::move(assembly.mesh);
  result.region = std::move(assembly.region);
  if (task.cut) {
    result.origin.assign(result.mesh.positions.size(), kNone);
    std::iota(result.origin.begin(),
              result.origin.begin() + static_cast<std::ptrdiff_t>(swept.mesh.positions.size()), VertexId{0});
  }
  dropUnused(result, surface.positions.size());
  return result;
}

// What is held for the surface and for its contour, at most; of a lean one that is the limit.
std::size_t predictedBytes(const ContourTask& task, const TriangleMesh& surface, const RunContext& context) {
  const std::size_t most = heldBytes(surface) + wholeBytes(task.crossings);
  return task.working.isLean ? std::min(most, context.memoryLimit()) : most;
}

// The triangles of the shell, as flags per triangle of the sweep.
std::vector<std::uint8_t> shellOf(const SweepResult& swept) {
  std::vector<std::uint8_t> is(swept.region.size());
  for (std::size_t t = 0; t < is.size(); ++t) is[t] = swept.region[t] == Region::kShell;
  return is;
}

ContourTask filledIn(ContourTask task, const SweepResult& swept) {
  if (task.openable.empty()) task.openable = shellOf(swept);
  return task;
}

// How much of a boundary of so many triangles its finer parts may cost.
std::size_t allowanceFor(std::size_t triangles) {
  constexpr std::size_t kLeast = 3'000'000, kTimes = 4;
  return std::max(kLeast, kTimes * triangles);
}

class Completion {
 public:
  Completion(const Job& job, const SweepResult& swept, ContourTask task)
      : job_(job),
        swept_(swept),
        task_(filledIn(std::move(task), swept)),
        shell_(swept, task_.openable, std::move(task_.keep), task_.width, job.threads),
        attempt_(job, swept, task_.width, task_.working, task_.cut ? &*task_.cut : nullptr) {
    if (!task_.left.empty()) return;
    for (const std::uint8_t isKept : shell_.keep()) task_.left.push_back(isKept == 0);
  }

  std::optional<Reconstruction> run() {
    for (;; ++round_) {
      const std::vector<TriangleId> meeting = attempt_.run(shell_.keep());
      if (meeting.empty()) return told(finished());
      pay(meeting.size());
      // Where little meets, windows around that cost less than all of it once more.
      std::optional<Closing> closing;
      if (meeting.size() * kLittle < attempt_.assembly().mesh.triangles.size()) closing = madeFiner(meeting);
      if (closing && closing->made) return closing->made;
      if (!tired_ && givesWay(meeting)) continue;
      if (!closing) closing = madeFiner(meeting);
      if (closing->made) return closing->made;
      if (!task_.mayKeepShell) return std::nullopt;
      if (!tired_ && takenBack_++ < kMostTakenBack &&
          shell_.takeBack(attempt_.assembly(), closing->stuck, reachOf(takenBack_ - 1, task_.width)))
        continue;
      // At last the whole sweep is taken. It leaves nothing to contour.
      if (!shell_.takeAllBack()) refuse(attempt_.assembly(), meeting);
    }
  }

 private:
  // Makes what meets in finer cells, unless the allowance is spent.
  Closing madeFiner(const std::vector<TriangleId>& meeting) {
    if (spent_) return {std::nullopt, meeting};
    Closing closing = closedFiner(job_, swept_, task_, attempt_, meeting, givenUp_, complete);
    if (closing.made) closing.made = told(closed(*std::move(closing.made)));
    return closing;
  }

  // An attempt in which so many triangles met, off the allowance.
  void pay(std::size_t meeting) {
    const std::size_t triangles = attempt_.assembly().mesh.triangles.size();
    if (!task_.allowance) task_.allowance = &allowance_.emplace(allowanceFor(triangles));
    const std::size_t cost = triangles + kMeetingCost * meeting;
    spent_ = *task_.allowance < cost;
    if (isNested_ && !spent_) *task_.allowance -= cost;
    const double work = static_cast<double>(round_ + 1) * task_.area / (task_.width * task_.width);
    tired_ = (round_ + 1 >= kSomeAttempts && work > kMostWork) || (isNested_ && spent_);
  }

  // Draws back walls that are in the way, or opens pieces of shell. Returns whether there were any.
  bool givesWay(const std::vector<TriangleId>& meeting) {
    const bool lifted = attempt_.liftWalls(meeting);
    // Where opening more does not help at once, finer cells are the better answer.
    const bool mayGive = takenBack_ == 0 && meeting.size() < leastMeeting_;
    leastMeeting_ = std::min(leastMeeting_, meeting.size());
    return (mayGive && opened_++ < kMostOpened &&
            shell_.open(attempt_.assembly(), meeting, reachOf(opened_ - 1, task_.width))) ||
           lifted;
  }

  Reconstruction finished() {
    Reconstruction result = finish(attempt_, job_.surface, swept_, task_);
    if (!task_.cut) result.depth = depthsOf(job_, swept_, shell_.keep());
    result.finest = task_.width;
    return result;
  }

  Reconstruction closed(Reconstruction made) const {
    if (task_.cut) return made;
    dropMisplaced(made, job_.surface.positions.size(), job_.threads);
    made.depth = depthsOf(job_, made);
    return made;
  }

  Reconstruction told(Reconstruction made) const {
    made.rounds += round_;
    made.cell = task_.width;
    made.cells += attempt_.field().cells();
    made.nodes += attempt_.field().nodes();
    made.predicted = std::max(made.predicted, predictedBytes(task_, job_.surface, job_.context));
    made.shellArea = shell_.openAtFirst();
    return made;
  }

  const Job& job_;
  const SweepResult& swept_;
  ContourTask task_;
  CarrierShell shell_;
  Attempt attempt_;
  std::size_t round_ = 0;
  int takenBack_ = 0, opened_ = 0;
  std::size_t leastMeeting_ = std::numeric_limits<std::size_t>::max();
  std::vector<mesh::Bounds> givenUp_;  ///< where finer cells did not do
  bool isNested_ = task_.allowance != nullptr;
  std::optional<std::size_t> allowance_;  ///< of its own, where the task brings none
  bool spent_ = false, tired_ = false;    ///< of finer cells; of attempts
};

}  // namespace

std::optional<Reconstruction> complete(const Job& job, const SweepResult& swept, ContourTask task) {
  return Completion(job, swept, std::move(task)).run();
}

}  // namespace thicken::reconstruct
