// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/complete.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "exact/box_tree.h"
#include "measure/measure.h"
#include "mesh/bounds.h"
#include "mesh/normals.h"
#include "parallel_for.h"
#include "reconstruct/attempt.h"
#include "reconstruct/carrier.h"
#include "reconstruct/drop_unused.h"
#include "reconstruct/holes.h"
#include "reconstruct/loose_parts.h"
#include "reconstruct/shell_plan.h"
#include "thicken/error.h"

namespace thicken {

namespace {

constexpr int kMostRefinements = 16, kMostYields = 12;
// Cells of all attempts together, and attempts that are made in any case, before the whole sweep is taken.
constexpr double kMostWork = 2.5e6;
constexpr std::size_t kSomeAttempts = 4;
// Reach of a refinement in cells, and its growth from one to the next, so that they end.
constexpr double kFirstReach = 0.5, kReachGrowth = 1.4;

// What a triangle that meets others costs while it is settled, in triangles that are just assembled.
constexpr std::size_t kMeetingCost = 100;

// The largest triangle of the sweep that is given over for the sake of others, in squares of a cell.
constexpr double kLargestGiven = 1000;

// The triangles of `shell` within `reach` mm of the box around a triangle.
std::vector<TriangleId> shellNear(const exact::BoxTree& shell, const TriangleMesh& mesh, TriangleId t,
                                  double reach) {
  Bounds b;
  for (const VertexId v : mesh.triangles[t]) b.add(mesh.positions[v]);
  return shell.near(b.low - Vec3::Constant(reach), b.high + Vec3::Constant(reach));
}

// Marks the sweep's shell near the triangles that meet, first near, then farther, until there is
// something new. Returns whether there was.
bool refine(const SweepResult& swept, const exact::BoxTree& shell, const Assembly& assembly,
            std::span<const TriangleId> meeting, double width, double first,
            std::vector<std::uint8_t>& keep) {
  constexpr double kFarthest = 64;
  bool any = false;
  for (double reach = first; reach < kFarthest * width && !any; reach *= 2)
    for (const TriangleId t : meeting) {
      if (t < assembly.carrierTriangles) continue;
      for (const TriangleId s : shellNear(shell, assembly.mesh, t, reach)) {
        any |= keep[s] == 0;
        keep[s] = 1;
      }
    }
  if (any) closeFans(swept.mesh, keep);
  return any;
}

// Makes `keep` a surface without pinched vertices: by less shell where that is enough, else by more.
void separateFans(const SweepResult& swept, std::span<const std::uint8_t> openable,
                  std::vector<std::uint8_t>& keep) {
  openFans(swept.mesh, openable, keep);
  closeFans(swept.mesh, keep);
}

// Gives pieces of the sweep's shell near the triangles that meet over to the contour, with all that its own
// rim would pinch. Returns whether there were any; each is given over once, and large ones, of a great many
// cells, not at all, nor what would leave more than `mostOpen` mm² to the contour.
bool yield(const SweepResult& swept, const exact::BoxTree& shell, const Assembly& assembly,
           std::span<const TriangleId> meeting, double reach, double width, double mostOpen,
           std::span<const std::uint8_t> openable, std::vector<std::uint8_t>& yielded,
           std::vector<std::uint8_t>& keep) {
  const std::vector<std::uint8_t> before = keep;
  for (const TriangleId t : meeting)
    for (const TriangleId s : shellNear(shell, assembly.mesh, t, reach)) {
      if (yielded[s]) continue;
      yielded[s] = 1;
      if (areaOf(swept.mesh.positions, swept.mesh.triangles[s]) > kLargestGiven * width * width) continue;
      keep[s] = 0;
    }
  if (keep == before) return false;
  separateFans(swept, openable, keep);
  if (openArea(swept, keep) > mostOpen) keep = before;
  return keep != before;
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

// How deep the solid is below each vertex: to where the field ends along the normal, or to the copy
// that the carrier keeps. Where the rim is nearest it is the wall that ends there, if the way down to it is
// about as long as the rim is far; a rim that is nearer is another part's, beyond the end of the field.
std::vector<double> depths(const TriangleMesh& surface, const ClosestPointTree& tree, double r,
                           const RunContext& context, int threads) {
  const auto normal = vertexNormals(surface.positions, surface.triangles,
                                    faceNormals(surface.positions, surface.triangles, threads), threads);
  std::vector<double> depth(surface.positions.size(), r);
  constexpr int kSteps = 5;
  constexpr double kOwnRim = 0.9;
  parallelFor(depth.size(), threads, context, 128, [&](std::size_t v) {
    double good = 0, bad = r;
    for (int i = 0; i < kSteps; ++i) {
      const double h = i == 0 ? 0.95 * r : (good + bad) / 2;
      const Vec3 p = surface.positions[v] - h * normal[v];
      const auto c = tree.closest(p);
      const bool inside = c->onRim ? c->distance >= kOwnRim * h : insideThickened(p, *c, r);
      (inside ? good : bad) = h;
      if (i == 0 && inside) break;
    }
    depth[v] = good >= 0.95 * r ? r : good;
  });
  return depth;
}

// Which of the assembly's triangles are of the sweep's shell where `left` says that this is for want of
// better, and what their vertices are copies of.
void tellLeft(const Assembly& assembly, const SweepResult& swept, std::span<const std::uint8_t> left,
              Reconstruction& result) {
  for (TriangleId t = 0; t < assembly.carrierTriangles; ++t) {
    if (assembly.region[t] != Region::kShell || !left[assembly.source[t]]) continue;
    result.left.resize(assembly.region.size(), 0);
    result.left[t] = 1;
    result.leftArea += areaOf(assembly.mesh.positions, assembly.mesh.triangles[t]);
  }
  if (result.left.empty()) return;
  result.base = swept.base;
  result.base.resize(assembly.mesh.positions.size(), kNone);
}

// The least distance of the pieces of the sweep's shell that are kept, below the vertices that they are
// copies of.
void limitDepths(const TriangleMesh& surface, const SweepResult& swept, std::span<const std::uint8_t> keep,
                 std::vector<double>& depth) {
  for (std::size_t t = surface.triangles.size(); t < keep.size(); ++t) {
    if (!keep[t] || swept.region[t] != Region::kShell) continue;
    for (const VertexId v : swept.mesh.triangles[t]) {
      if (swept.base[v] == kNone) continue;
      double& at = depth[swept.base[v]];
      at = std::min(at, swept.distance[v]);
    }
  }
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

// What an attempt could not make, once it was tried in finer cells.
struct Closing {
  std::optional<Reconstruction> made;  // where all of it could be made
  std::vector<TriangleId> stuck;       // of the assembly: triangles that meet where it could not
};

// The triangles of `meeting` in zones that were given up.
std::vector<TriangleId> meetingIn(const Assembly& assembly, std::span<const TriangleId> meeting,
                                  std::span<const Bounds> zones) {
  std::vector<TriangleId> in;
  for (const TriangleId t : meeting) {
    Bounds b;
    for (const VertexId v : assembly.mesh.triangles[t]) b.add(assembly.mesh.positions[v]);
    if (std::any_of(zones.begin(), zones.end(), [&](const Bounds& zone) { return zone.overlaps(b); }))
      in.push_back(t);
  }
  return in;
}

// The zones of the windows that come near what was given up.
std::vector<Bounds> zonesAmong(std::span<const Window> windows, std::span<const Bounds> givenUp) {
  std::vector<Bounds> zones;
  for (const Window& window : windows)
    if (std::any_of(givenUp.begin(), givenUp.end(),
                    [&](const Bounds& zone) { return zone.overlaps(window.zone); }))
      zones.push_back(window.zone);
  return zones;
}

// What an attempt could not make, in finer cells: the rest of it is the carrier for that. Zones where even
// the finest ones that are tried do not do are added to `givenUp`, and are not tried again.
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
  const std::vector<Window> windows = windowsOf(surface, *holes, options.thickness, finer.width, threads);
  if (windows.empty()) return closing;
  std::vector<Bounds> stuck = zonesAmong(windows, givenUp);
  const bool isOpen = stuck.empty();
  std::vector<std::optional<Reconstruction>> made(windows.size());
  for (std::size_t i = 0; isOpen && i < windows.size(); ++i) {
    finer.meeting = meetingIn(attempt.assembly(), meeting, {&windows[i].zone, 1}).size();
    made[i] = completeWindow(surface, tree, windows[i], finer, held, options, context, threads, watch);
    if (made[i]) continue;
    stuck.push_back(windows[i].zone);
    // The others are tried, too, where it is of use to know all that cannot be closed.
    if (!task.mayKeepShell) return closing;
  }
  if (stuck.empty()) {
    closing.made = withWindows(surface, *holes, windows, made);
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

// The triangles of the shell, as flags per triangle of the sweep.
std::vector<std::uint8_t> shellOf(const SweepResult& swept) {
  std::vector<std::uint8_t> is(swept.region.size());
  for (std::size_t t = 0; t < is.size(); ++t) is[t] = swept.region[t] == Region::kShell;
  return is;
}

}  // namespace

std::optional<Reconstruction> complete(const TriangleMesh& surface, const ClosestPointTree& tree,
                                       const SweepResult& swept, ContourTask task, const Options& options,
                                       const RunContext& context, int threads, Stopwatch& watch) {
  std::vector<std::uint8_t>& keep = task.keep;
  const double width = task.width;
  if (task.openable.empty()) task.openable = shellOf(swept);
  bool anyOpenable = false;
  for (std::size_t t = 0; t < keep.size(); ++t) anyOpenable |= task.openable[t] && keep[t];
  if (anyOpenable) trimSpikes(swept.mesh, task.openable, kLargestGiven * width * width, keep);
  // Walls that were proved alone have none to separate.
  if (anyOpenable || swept.shellProved) separateFans(swept, task.openable, keep);
  const exact::BoxTree shell(swept.mesh.positions, swept.mesh.triangles, threads, task.openable);
  const double wanted = openArea(swept, keep);
  if (task.left.empty()) {
    task.left.resize(keep.size());
    std::transform(keep.begin(), keep.end(), task.left.begin(), [](std::uint8_t k) { return k == 0; });
  }
  const double mostOpen = std::max(wanted, kManyBesideSweep * width * width);
  Attempt attempt(surface, tree, swept, options, width, task.working, task.cut ? &*task.cut : nullptr,
                  context, threads);
  int refinements = 0, yields = 0;
  std::vector<Bounds> givenUp;
  std::optional<std::size_t> allowance;
  std::size_t leastMeeting = std::numeric_limits<std::size_t>::max();
  std::vector<std::uint8_t> yielded(keep.size(), 0);
  const auto told = [&](Reconstruction made, std::size_t rounds) {
    made.rounds += rounds;
    made.cell = width;
    made.cells += attempt.field().cells();
    made.nodes += attempt.field().nodes();
    made.predicted = std::max(made.predicted, predictedBytes(task, surface, context));
    made.shellArea = wanted;
    return made;
  };
  for (std::size_t round = 0;; ++round) {
    const std::vector<TriangleId> meeting = attempt.run(keep, watch);
    if (meeting.empty()) {
      Reconstruction result = finish(attempt, surface, swept, task);
      if (!task.cut) {
        result.depth = depths(surface, tree, options.thickness, context, threads);
        limitDepths(surface, swept, keep, result.depth);
      }
      result.finest = width;
      return told(std::move(result), round);
    }
    const std::size_t triangles = attempt.assembly().mesh.triangles.size();
    if (!task.allowance) task.allowance = &allowance.emplace(allowanceFor(triangles));
    const std::size_t cost = triangles + kMeetingCost * meeting.size();
    const bool spent = *task.allowance < cost;
    if (task.cut && !spent) *task.allowance -= cost;
    const double work = static_cast<double>(round + 1) * task.area / (width * width);
    const bool tired = (round + 1 >= kSomeAttempts && work > kMostWork) || (task.cut && spent);
    const bool lifted = !tired && attempt.liftWalls(meeting);
    const double nearby = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(yields));
    // At a hole finer cells are the better answer where giving over more does not help at once.
    const bool mayYield = task.refined == 0 || meeting.size() < leastMeeting;
    leastMeeting = std::min(leastMeeting, meeting.size());
    if (!tired && refinements == 0 && mayYield && yields++ < kMostYields &&
        yield(swept, shell, attempt.assembly(), meeting, nearby, width, mostOpen, task.openable, yielded,
              keep))
      continue;
    if (lifted) continue;
    std::vector<TriangleId> stuck = meeting;
    if (!spent) {
      Closing closing = closedFiner(surface, tree, swept, task, attempt, meeting, givenUp, options, context,
                                    threads, watch);
      if (closing.made) {
        if (!task.cut) {
          dropMisplaced(*closing.made, threads);
          closing.made->depth = depthsOf(*closing.made, surface, tree, options.thickness, context, threads);
        }
        return told(*std::move(closing.made), round);
      }
      stuck = std::move(closing.stuck);
    }
    if (!task.mayKeepShell) return std::nullopt;
    const double reach = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(refinements));
    if (!tired && refinements++ < kMostRefinements &&
        refine(swept, shell, attempt.assembly(), stuck, width, reach, keep))
      continue;
    // In the end the whole sweep, which leaves nothing to contour.
    if (std::find(keep.begin(), keep.end(), 0) == keep.end()) refuse(attempt.assembly(), meeting);
    std::fill(keep.begin(), keep.end(), std::uint8_t{1});
  }
}

std::optional<Reconstruction> completeWindow(const TriangleMesh& surface, const ClosestPointTree& tree,
                                             const Window& window, ContourTask task, std::size_t held,
                                             const Options& options, const RunContext& context, int threads,
                                             Stopwatch& watch) {
  task.area = window.area;
  if (!(task.area > 0) || !fewCells(task.width, task.area)) return std::nullopt;
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
    if (made && !staysWithin(window, *made)) return std::nullopt;
    return made;
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) throw;
    return std::nullopt;
  }
}

std::vector<double> depthsOf(const Reconstruction& made, const TriangleMesh& surface,
                             const ClosestPointTree& tree, double r, const RunContext& context, int threads) {
  std::vector<double> depth = depths(surface, tree, r, context, threads);
  for (TriangleId t = 0; t < made.left.size(); ++t) {
    if (!made.left[t]) continue;
    for (const VertexId v : made.mesh.triangles[t]) {
      if (made.base[v] == kNone) continue;
      double& at = depth[made.base[v]];
      at = std::min(at, tree.distance(made.mesh.positions[v]));
    }
  }
  return depth;
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
