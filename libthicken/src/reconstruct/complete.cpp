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
#include "reconstruct/holes.h"
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

// Drops the vertices that no triangle uses; those that are left are numbered as they come, S's first.
void dropUnused(Reconstruction& made, std::size_t surfaceVertices) {
  TriangleMesh& mesh = made.mesh;
  std::vector<VertexId> to(mesh.positions.size(), kNone);
  auto count = static_cast<VertexId>(surfaceVertices);
  std::iota(to.begin(), to.begin() + count, VertexId{0});
  for (Triangle& t : mesh.triangles)
    for (VertexId& v : t) {
      if (to[v] == kNone) to[v] = count++;
      v = to[v];
    }
  std::vector<Vec3> positions(count);
  std::vector<VertexId> base(made.base.empty() ? 0 : count);
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == kNone) continue;
    positions[to[v]] = mesh.positions[v];
    if (!base.empty()) base[to[v]] = made.base[v];
  }
  mesh.positions = std::move(positions);
  made.base = std::move(base);
  std::erase_if(made.ends, [&](const WallEnd& end) { return to[end.vertex] == kNone; });
  for (WallEnd& end : made.ends) end.vertex = to[end.vertex];
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

Reconstruction finish(Attempt& attempt, const TriangleMesh& surface, const SweepResult& swept,
                      const ContourTask& task, std::vector<double> depth) {
  const std::vector<std::uint8_t>& keep = task.keep;
  Reconstruction result;
  const std::vector<Vec3>& up = attempt.carrier().up;
  for (VertexId v = 0; v < up.size(); ++v)
    if (!up[v].isZero(0)) result.ends.push_back({v, up[v]});
  Assembly assembly = attempt.takeAssembly();
  result.depth = std::move(depth);
  for (std::size_t t = surface.triangles.size(); t < keep.size(); ++t) {
    if (!keep[t] || swept.region[t] != Region::kShell) continue;
    for (const VertexId v : swept.mesh.triangles[t]) {
      if (swept.base[v] == kNone) continue;
      double& at = result.depth[swept.base[v]];
      at = std::min(at, swept.distance[v]);
    }
  }
  tellLeft(assembly, swept, task.left, result);
  result.openable = openableOf(assembly, task);
  result.mesh = std::move(assembly.mesh);
  result.region = std::move(assembly.region);
  dropUnused(result, surface.positions.size());
  return result;
}

// What is held for the surface and for its contour, at most; of a lean one that is the limit.
std::size_t predictedBytes(const ContourTask& task, const TriangleMesh& surface, const RunContext& context) {
  const std::size_t most = heldBytes(surface) + wholeBytes(task.crossings);
  return task.working.isLean ? std::min(most, context.memoryLimit()) : most;
}

// What an attempt could not make, in finer cells: the rest of it is the carrier for that. Nothing where even
// the finest ones that are tried do not do.
std::optional<Reconstruction> closedFiner(const TriangleMesh& surface, const ClosestPointTree& tree,
                                          const SweepResult& swept, const ContourTask& task,
                                          const Attempt& attempt, std::span<const TriangleId> meeting,
                                          const Options& options, const RunContext& context, int threads,
                                          Stopwatch& watch) {
  constexpr double kFiner = 0.5;
  constexpr std::size_t kCarriedBytes = 700;  // for each triangle of the carrier beyond S
  constexpr int kMostTimes = 5;
  // What meets along a curve at any width meets in twice as many triangles of half the size.
  constexpr double kGrowth = 1.5;
  const bool isHopeless = task.refined > 0 && double(meeting.size()) > kGrowth * double(task.meeting);
  if (task.refined == kMostTimes || isHopeless) return std::nullopt;
  const std::size_t carried = attempt.assembly().mesh.triangles.size() - surface.triangles.size();
  const std::size_t held = heldBytes(surface) + carried * kCarriedBytes;
  if (const std::size_t limit = context.memoryLimit(); limit != 0 && held > limit) return std::nullopt;
  auto holes = holesOf(surface, swept, attempt, task, meeting, context, threads);
  if (!holes) return std::nullopt;
  ContourTask finer;
  finer.width = kFiner * task.width;
  finer.area = openArea(holes->carried, holes->keep);
  if (!(finer.area > 0) || !fewCells(finer.width, finer.area)) return std::nullopt;
  finer.crossings = mostCrossings(finer.area, finer.width);
  finer.working = workingSetFor(finer.crossings, held, context);
  finer.keep = std::move(holes->keep);
  finer.openable = std::move(holes->openable);
  finer.left = std::move(holes->left);
  finer.refined = task.refined + 1;
  finer.meeting = meeting.size();
  return completeIfPossible(surface, tree, holes->carried, std::move(finer), options, context, threads,
                            watch);
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
  Attempt attempt(surface, tree, swept, options, width, task.working, context, threads);
  int refinements = 0, yields = 0;
  bool triedFiner = false;
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
      Reconstruction result =
          finish(attempt, surface, swept, task, depths(surface, tree, options.thickness, context, threads));
      result.finest = width;
      return told(std::move(result), round);
    }
    const double work = static_cast<double>(round + 1) * task.area / (width * width);
    const bool tired = round + 1 >= kSomeAttempts && work > kMostWork;
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
    if (!std::exchange(triedFiner, true))
      if (auto made =
              closedFiner(surface, tree, swept, task, attempt, meeting, options, context, threads, watch))
        return told(*std::move(made), round);
    if (!task.mayKeepShell) return std::nullopt;
    const double reach = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(refinements));
    if (!tired && refinements++ < kMostRefinements &&
        refine(swept, shell, attempt.assembly(), meeting, width, reach, keep))
      continue;
    // In the end the whole sweep, which leaves nothing to contour.
    if (std::find(keep.begin(), keep.end(), 0) == keep.end()) refuse(attempt.assembly(), meeting);
    std::fill(keep.begin(), keep.end(), std::uint8_t{1});
  }
}

std::optional<Reconstruction> completeIfPossible(const TriangleMesh& surface, const ClosestPointTree& tree,
                                                 const SweepResult& swept, ContourTask task,
                                                 const Options& options, const RunContext& context,
                                                 int threads, Stopwatch& watch) {
  try {
    requireCells(surface, options.thickness, task.width);
    return complete(surface, tree, swept, std::move(task), options, context, threads, watch);
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) throw;
    return std::nullopt;
  }
}

bool fewCells(double width, double area) {
  constexpr double kMostCells = 1e5;
  return area <= kMostCells * width * width;
}

}  // namespace thicken
