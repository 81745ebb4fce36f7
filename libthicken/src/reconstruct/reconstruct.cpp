// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "exact/box_tree.h"
#include "measure/measure.h"
#include "measure/stopwatch.h"
#include "mesh/bounds.h"
#include "mesh/normals.h"
#include "parallel_for.h"
#include "reconstruct/attempt.h"
#include "reconstruct/carrier.h"
#include "sweep/sweep.h"
#include "sweep/sweep_walls.h"
#include "thicken/error.h"

namespace thicken {

namespace {

constexpr int kMostRefinements = 16, kMostYields = 12;
// Cells of all attempts together, and attempts that are made in any case, before the whole sweep is taken.
constexpr double kMostWork = 2.5e6;
constexpr std::size_t kSomeAttempts = 4;
// Reach of a refinement in cells, and its growth from one to the next, so that they end.
constexpr double kFirstReach = 0.5, kReachGrowth = 1.4;

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
// rim would pinch. Returns whether there were any; each is given over once.
bool yield(const SweepResult& swept, const exact::BoxTree& shell, const Assembly& assembly,
           std::span<const TriangleId> meeting, double reach, std::vector<std::uint8_t>& yielded,
           std::vector<std::uint8_t>& keep) {
  bool any = false;
  for (const TriangleId t : meeting)
    for (const TriangleId s : shellNear(shell, assembly.mesh, t, reach)) {
      if (yielded[s]) continue;
      yielded[s] = 1;
      any |= keep[s] != 0;
      keep[s] = 0;
    }
  if (any) separateFans(swept, keep);
  return any;
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
// that the carrier keeps.
std::vector<double> depths(const TriangleMesh& surface, const ClosestPointTree& tree, double r,
                           const RunContext& context, int threads) {
  const auto normal =
      vertexNormals(surface.positions, surface.triangles, faceNormals(surface.positions, surface.triangles));
  std::vector<double> depth(surface.positions.size(), r);
  constexpr int kSteps = 5;
  parallelFor(depth.size(), threads, context, 128, [&](std::size_t v) {
    double good = 0, bad = r;
    for (int i = 0; i < kSteps; ++i) {
      const double h = i == 0 ? 0.95 * r : (good + bad) / 2;
      const Vec3 p = surface.positions[v] - h * normal[v];
      const auto c = tree.closest(p);
      const bool inside = c->onRim || insideThickened(p, *c, r);
      (inside ? good : bad) = h;
      if (i == 0 && inside) break;
    }
    depth[v] = good >= 0.95 * r ? r : good;
  });
  return depth;
}

Reconstruction finish(const Assembly& assembly, const TriangleMesh& surface, const SweepResult& swept,
                      std::span<const std::uint8_t> keep, std::vector<double> depth) {
  Reconstruction result;
  result.depth = std::move(depth);
  const std::size_t s = surface.triangles.size();
  for (std::size_t t = s; t < keep.size(); ++t)
    if (keep[t] && t < 2 * s && swept.region[t] == Region::kShell)
      for (const VertexId v : surface.triangles[t - s])
        result.depth[v] = std::min(result.depth[v], swept.depth[v]);
  std::vector<VertexId> to(assembly.mesh.positions.size(), kNone);
  for (VertexId v = 0; v < surface.positions.size(); ++v) to[v] = v;
  result.mesh.positions = surface.positions;
  for (std::size_t t = 0; t < assembly.mesh.triangles.size(); ++t) {
    Triangle out{};
    for (int k = 0; k < 3; ++k) {
      VertexId& id = to[assembly.mesh.triangles[t][k]];
      if (id == kNone) {
        id = static_cast<VertexId>(result.mesh.positions.size());
        result.mesh.positions.push_back(assembly.mesh.positions[assembly.mesh.triangles[t][k]]);
      }
      out[k] = id;
    }
    result.mesh.triangles.push_back(out);
    result.region.push_back(assembly.region[t]);
  }
  return result;
}

// Attempts until nothing meets, `area` mm² being contoured: walls that are in the way are drawn back, and
// where that does not help the sweep's own shell is kept. nullopt where that is needed and not proved.
std::optional<Reconstruction> complete(const TriangleMesh& surface, const ClosestPointTree& tree,
                                       const SweepResult& swept, std::vector<std::uint8_t> keep, double area,
                                       double width, const Options& options, const RunContext& context,
                                       int threads, Stopwatch& watch) {
  std::vector<std::uint8_t> isShell(keep.size());
  bool anyShell = false;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    isShell[t] = swept.region[t] == Region::kShell;
    anyShell |= isShell[t] && keep[t];
  }
  if (anyShell) separateFans(swept, keep);  // S and its walls have none to separate
  const exact::BoxTree shell(swept.mesh.positions, swept.mesh.triangles, threads, isShell);
  Attempt attempt(surface, tree, swept, options, width, context, threads);
  int refinements = 0, yields = 0;
  std::vector<std::uint8_t> yielded(keep.size(), 0);
  for (std::size_t round = 0;; ++round) {
    const std::vector<TriangleId> meeting = attempt.run(keep, watch);
    if (meeting.empty()) {
      Reconstruction result = finish(attempt.assembly(), surface, swept, keep,
                                     depths(surface, tree, options.thickness, context, threads));
      result.rounds = round;
      result.cell = width;
      result.cells = attempt.field().cells();
      result.nodes = attempt.field().size();
      result.predicted = fieldBytes(area, width);
      return result;
    }
    const double work = static_cast<double>(round + 1) * area / (width * width);
    const bool tired = round + 1 >= kSomeAttempts && work > kMostWork;
    const bool lifted = !tired && attempt.liftWalls(meeting);
    const double nearby = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(yields));
    if (!tired && refinements == 0 && yields++ < kMostYields &&
        yield(swept, shell, attempt.assembly(), meeting, nearby, yielded, keep))
      continue;
    if (lifted) continue;
    if (!swept.shellProved) return std::nullopt;
    const double reach = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(refinements));
    if (!tired && refinements++ < kMostRefinements &&
        refine(swept, shell, attempt.assembly(), meeting, width, reach, keep))
      continue;
    // In the end the whole sweep, which leaves nothing to contour.
    if (std::find(keep.begin(), keep.end(), 0) == keep.end()) refuse(attempt.assembly(), meeting);
    std::fill(keep.begin(), keep.end(), std::uint8_t{1});
  }
}

// Error of a contour, in w²/r².
constexpr double kCellError = 0.15;

// Error of the sweep's shell that is left as it is, in r.
double errorToLeave(const Options& options) {
  constexpr double kEnough = 0.01;
  constexpr double kFinest = 5e-4;
  if (!options.tolerance) return kEnough;
  return std::clamp(*options.tolerance / (2 * options.thickness), kFinest, kEnough);
}

// How far each triangle of the sweep's shell is from the thickness, mm, in its corners and its middle; 0 for
// others. Where corners alone are farther than any contour is left for, the middle is not looked at.
std::vector<double> shellErrors(const SweepResult& swept, const ClosestPointTree& tree, double r,
                                const RunContext& context, int threads) {
  constexpr double kMost = kCellError / 4;  // cells are below r/2
  std::vector<double> error(swept.mesh.triangles.size(), 0);
  parallelFor(error.size(), threads, context, 256, [&](std::size_t t) {
    if (swept.region[t] != Region::kShell) return;
    Vec3 middle = Vec3::Zero();
    for (const VertexId v : swept.mesh.triangles[t]) {
      error[t] = std::max(error[t], std::abs(swept.distance[v] - r));
      middle += swept.mesh.positions[v] / 3;
    }
    if (error[t] <= kMost * r) error[t] = std::max(error[t], std::abs(tree.distance(middle) - r));
  });
  return error;
}

// What a contour is to replace: the part of the sweep's shell that is off by more than `error` mm.
struct Plan {
  std::vector<std::uint8_t> keep;  ///< per triangle of the sweep
  double area = 0;                 ///< of the rest, mm²
  double width = 0;                ///< of the cells for it, mm
  [[nodiscard]] bool keepsAll() const { return std::find(keep.begin(), keep.end(), 0) == keep.end(); }
};

// Cells along an edge of a triangle beside a contour: its rim is divided by cells, and a fan of so many
// slivers costs exact tests by their square.
constexpr double kMostAlongEdge = 400;

double longestEdge(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
  return std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
}

Plan planFor(const TriangleMesh& surface, const SweepResult& swept, std::span<const double> errors,
             double error, const Options& options) {
  Plan plan;
  const double longest = kMostAlongEdge * options.thickness / 2.2;
  for (TriangleId t = 0; t < errors.size(); ++t) {
    plan.keep.push_back(errors[t] <= error || longestEdge(swept.mesh, t) > longest);
    if (!plan.keep[t]) plan.area += areaOf(swept.mesh.positions, swept.mesh.triangles[t]);
  }
  if (!plan.keepsAll()) plan.width = cellWidth(surface, plan.area, options);
  return plan;
}

// Cells beside a sweep. A thickness far below the extent of the surface, whose cells must be finer still,
// would take any number.
constexpr double kMostCells = 4e5;

// The error that triangles of at most `area` mm² exceed: the worst are contoured, the rest is left.
double affordableError(const TriangleMesh& mesh, std::span<const double> errors, double area) {
  std::vector<std::pair<double, double>> worst;  // error, area
  for (std::size_t t = 0; t < errors.size(); ++t)
    if (errors[t] > 0) worst.emplace_back(errors[t], areaOf(mesh.positions, mesh.triangles[t]));
  std::sort(worst.begin(), worst.end(), std::greater<>());
  double sum = 0;
  for (const auto& [error, own] : worst)
    if ((sum += own) > area) return error;
  return 0;
}

}  // namespace

Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree, const Options& options,
                           const RunContext& context, int threads, Stopwatch& watch) {
  const double area = areaOf(surface), width = cellWidth(surface, area, options);
  requireRoomForField(surface, area, options.thickness, width, context);
  const auto below = [&](const SweepResult& swept) {
    watch.lap("sweep");
    std::vector<std::uint8_t> keep(swept.mesh.triangles.size());
    for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = swept.region[t] != Region::kShell;
    return complete(surface, tree, swept, std::move(keep), area, width, options, context, threads, watch);
  };
  // Most surfaces need no more of the sweep than its walls.
  if (const auto walls = sweepWalls(surface, tree, options.thickness, context, threads))
    if (auto made = below(*walls)) return *std::move(made);
  return *below(sweep(surface, tree, options.thickness, Side::kNegative, context, threads, Polish::kNo));
}

std::optional<Reconstruction> deepen(const TriangleMesh& surface, const ClosestPointTree& tree,
                                     const SweepResult& swept, const Options& options,
                                     const RunContext& context, int threads, Stopwatch& watch) {
  const double r = options.thickness, finest = errorToLeave(options);
  const std::vector<double> errors = shellErrors(swept, tree, r, context, threads);
  Plan plan = planFor(surface, swept, errors, finest * r, options);
  if (plan.keepsAll()) return std::nullopt;
  // Wider cells are no better than a sweep that is off by as much.
  const double error = kCellError * plan.width * plan.width / (r * r);
  if (error > finest) plan = planFor(surface, swept, errors, error * r, options);
  if (plan.area > kMostCells * plan.width * plan.width)
    plan = planFor(surface, swept, errors,
                   affordableError(swept.mesh, errors, kMostCells * plan.width * plan.width), options);
  if (plan.keepsAll()) return std::nullopt;
  requireRoomForField(surface, plan.area, r, plan.width, context);
  return complete(surface, tree, swept, std::move(plan.keep), plan.area, plan.width, options, context,
                  threads, watch);
}

}  // namespace thicken
