// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/complete.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "exact/box_tree.h"
#include "measure/measure.h"
#include "mesh/bounds.h"
#include "mesh/normals.h"
#include "parallel_for.h"
#include "reconstruct/attempt.h"
#include "reconstruct/carrier.h"
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
void separateFans(const SweepResult& swept, std::vector<std::uint8_t>& keep) {
  openFans(swept.mesh, swept.region, keep);
  closeFans(swept.mesh, keep);
}

// Gives pieces of the sweep's shell near the triangles that meet over to the contour, with all that its own
// rim would pinch. Returns whether there were any; each is given over once, and large ones, of a great many
// cells, not at all, nor what would leave more than `mostOpen` mm² to the contour.
bool yield(const SweepResult& swept, const exact::BoxTree& shell, const Assembly& assembly,
           std::span<const TriangleId> meeting, double reach, double width, double mostOpen,
           std::vector<std::uint8_t>& yielded, std::vector<std::uint8_t>& keep) {
  const std::vector<std::uint8_t> before = keep;
  for (const TriangleId t : meeting)
    for (const TriangleId s : shellNear(shell, assembly.mesh, t, reach)) {
      if (yielded[s]) continue;
      yielded[s] = 1;
      if (areaOf(swept.mesh.positions, swept.mesh.triangles[s]) > kLargestGiven * width * width) continue;
      keep[s] = 0;
    }
  if (keep == before) return false;
  separateFans(swept, keep);
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

// The vertices that the triangles use, numbered as they come, those of S first.
void dropUnused(TriangleMesh& mesh, std::size_t surfaceVertices) {
  std::vector<VertexId> to(mesh.positions.size(), kNone);
  auto count = static_cast<VertexId>(surfaceVertices);
  std::iota(to.begin(), to.begin() + count, VertexId{0});
  for (Triangle& t : mesh.triangles)
    for (VertexId& v : t) {
      if (to[v] == kNone) to[v] = count++;
      v = to[v];
    }
  std::vector<Vec3> positions(count);
  for (std::size_t v = 0; v < to.size(); ++v)
    if (to[v] != kNone) positions[to[v]] = mesh.positions[v];
  mesh.positions = std::move(positions);
}

Reconstruction finish(Assembly assembly, const TriangleMesh& surface, const SweepResult& swept,
                      std::span<const std::uint8_t> keep, std::vector<double> depth) {
  Reconstruction result;
  result.depth = std::move(depth);
  for (std::size_t t = surface.triangles.size(); t < keep.size(); ++t) {
    if (!keep[t] || swept.region[t] != Region::kShell) continue;
    for (const VertexId v : swept.mesh.triangles[t]) {
      double& at = result.depth[swept.base[v]];
      at = std::min(at, swept.distance[v]);
    }
  }
  result.mesh = std::move(assembly.mesh);
  result.region = std::move(assembly.region);
  dropUnused(result.mesh, surface.positions.size());
  return result;
}

// What is held for the surface and for its contour, at most; of a lean one that is the limit.
std::size_t predictedBytes(const ContourTask& task, const TriangleMesh& surface, const RunContext& context) {
  const std::size_t most = heldBytes(surface) + wholeBytes(task.crossings);
  return task.working.isLean ? std::min(most, context.memoryLimit()) : most;
}

}  // namespace

std::optional<Reconstruction> complete(const TriangleMesh& surface, const ClosestPointTree& tree,
                                       const SweepResult& swept, ContourTask task, const Options& options,
                                       const RunContext& context, int threads, Stopwatch& watch) {
  std::vector<std::uint8_t>& keep = task.keep;
  const double width = task.width;
  std::vector<std::uint8_t> isShell(keep.size());
  bool anyShell = false;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    isShell[t] = swept.region[t] == Region::kShell;
    anyShell |= isShell[t] && keep[t];
  }
  if (anyShell) trimSpikes(swept.mesh, swept.region, kLargestGiven * width * width, keep);
  // Walls that were proved alone have none to separate.
  if (anyShell || swept.shellProved) separateFans(swept, keep);
  const exact::BoxTree shell(swept.mesh.positions, swept.mesh.triangles, threads, isShell);
  const double wanted = openArea(swept, keep);
  const double mostOpen = std::max(wanted, kManyBesideSweep * width * width);
  Attempt attempt(surface, tree, swept, options, width, task.working, context, threads);
  int refinements = 0, yields = 0;
  std::vector<std::uint8_t> yielded(keep.size(), 0);
  for (std::size_t round = 0;; ++round) {
    const std::vector<TriangleId> meeting = attempt.run(keep, watch);
    if (meeting.empty()) {
      Reconstruction result = finish(attempt.takeAssembly(), surface, swept, keep,
                                     depths(surface, tree, options.thickness, context, threads));
      result.rounds = round;
      result.cell = width;
      result.cells = attempt.field().cells();
      result.nodes = attempt.field().nodes();
      result.predicted = predictedBytes(task, surface, context);
      if (wanted > 0) result.leftShare = 1 - openArea(swept, keep) / wanted;
      return result;
    }
    const double work = static_cast<double>(round + 1) * task.area / (width * width);
    const bool tired = round + 1 >= kSomeAttempts && work > kMostWork;
    const bool lifted = !tired && attempt.liftWalls(meeting);
    const double nearby = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(yields));
    if (!tired && refinements == 0 && yields++ < kMostYields &&
        yield(swept, shell, attempt.assembly(), meeting, nearby, width, mostOpen, yielded, keep))
      continue;
    if (lifted) continue;
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

}  // namespace thicken
