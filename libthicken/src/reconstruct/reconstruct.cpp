// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/nesting.h"
#include "contour/dual_surface.h"
#include "exact/box_tree.h"
#include "measure/measure.h"
#include "measure/stopwatch.h"
#include "mesh/half_edges.h"
#include "mesh/normals.h"
#include "parallel_for.h"
#include "reconstruct/assembly.h"
#include "reconstruct/carrier.h"
#include "reconstruct/deep_walls.h"
#include "reconstruct/settle.h"
#include "reconstruct/shape.h"
#include "sweep/sweep.h"
#include "thicken/error.h"

namespace thicken {

namespace {

constexpr int kDefaultRounds = 15;  // of shape optimisation; the paper takes 10 to 20
constexpr int kMostRefinements = 12;
// Reach of a refinement in cells, and its growth from one to the next, so that they end.
constexpr double kFirstReach = 0.5, kReachGrowth = 1.25;
constexpr double kMargin = 3;  // cells around the box grown by r

struct Bounds {
  Vec3 low, high;
};
Bounds boundsOf(const TriangleMesh& mesh) {
  Bounds b{mesh.positions[mesh.triangles[0][0]], mesh.positions[mesh.triangles[0][0]]};
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t) {
      b.low = b.low.cwiseMin(mesh.positions[v]);
      b.high = b.high.cwiseMax(mesh.positions[v]);
    }
  return b;
}

// Nodes at places that no coordinate of a file is likely to have; another try, other places.
UniformGrid gridFor(const TriangleMesh& surface, double thickness, double width, int attempt) {
  const Bounds b = boundsOf(surface);
  const Vec3 shift{0.3819660112501051, 0.2360679774997896, 0.1458980337503154};
  Vec3 origin = b.low - Vec3::Constant(thickness + kMargin * width);
  GridIndex cells{};
  for (int k = 0; k < 3; ++k) {
    const double part = shift[k] * (attempt + 1);
    origin[k] -= width * (part - std::floor(part));
    cells[k] = static_cast<int>((b.high[k] + thickness + kMargin * width - origin[k]) / width) + 1;
  }
  return {origin, width, cells};
}

// Removes closed pieces of the contour that are but a few cells large: islands and cavities where
// the field is finer than the grid. Every part of the solid hangs together with S.
void dropSpecks(Assembly& assembly, double width) {
  constexpr double kSpeck = 8;  // cells
  const Components parts = componentsOf(assembly.mesh.positions.size(), assembly.mesh.triangles);
  std::vector<std::uint8_t> hangs(parts.count, 0);
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Bounds> bounds(parts.count, {Vec3::Constant(inf), Vec3::Constant(-inf)});
  for (std::size_t t = 0; t < parts.ofTriangle.size(); ++t) {
    if (t < assembly.carrierTriangles) hangs[parts.ofTriangle[t]] = 1;
    Bounds& b = bounds[parts.ofTriangle[t]];
    for (const VertexId v : assembly.mesh.triangles[t]) {
      b.low = b.low.cwiseMin(assembly.mesh.positions[v]);
      b.high = b.high.cwiseMax(assembly.mesh.positions[v]);
    }
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < parts.ofTriangle.size(); ++t) {
    const std::uint32_t part = parts.ofTriangle[t];
    if (!hangs[part] && (bounds[part].high - bounds[part].low).norm() < kSpeck * width) continue;
    assembly.mesh.triangles[kept] = assembly.mesh.triangles[t];
    assembly.region[kept] = assembly.region[t];
    if (t >= assembly.carrierTriangles)
      assembly.crossing[kept - assembly.carrierTriangles] = assembly.crossing[t - assembly.carrierTriangles];
    ++kept;
  }
  assembly.mesh.triangles.resize(kept);
  assembly.region.resize(kept);
  assembly.crossing.resize(kept - assembly.carrierTriangles);
}

// Removes closed pieces of a contour without meetings that turned inside out when they were shaped, or
// that float in nothing: exact, by where their lowest vertex lies.
void dropMisplaced(Assembly& assembly, int threads) {
  const TriangleMesh& mesh = assembly.mesh;
  const Components parts = componentsOf(mesh.positions.size(), mesh.triangles);
  std::vector<std::uint8_t> hangs(parts.count, 0), drop(parts.count, 0);
  for (std::size_t t = 0; t < assembly.carrierTriangles; ++t)
    if (assembly.region[t] == Region::kOriginal) hangs[parts.ofTriangle[t]] = 1;
  if (std::find(hangs.begin(), hangs.end(), 0) == hangs.end()) return;
  const HalfEdges edges(mesh.positions.size(), mesh.triangles);
  const exact::BoxTree tree(mesh.positions, mesh.triangles, threads);
  const std::vector<VertexId> lowest = lowestVertices(mesh, parts);
  for (std::uint32_t part = 0; part < parts.count; ++part)
    drop[part] = !hangs[part] && facesOutward(mesh, edges, lowest[part]) ==
                                     insideOddNumber(mesh, tree, parts, lowest[part], part);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < parts.ofTriangle.size(); ++t) {
    if (drop[parts.ofTriangle[t]]) continue;
    assembly.mesh.triangles[kept] = assembly.mesh.triangles[t];
    assembly.region[kept] = assembly.region[t];
    ++kept;
  }
  assembly.mesh.triangles.resize(kept);
  assembly.region.resize(kept);
  assembly.crossing.clear();  // nothing is moved any more
}

// Everything that one attempt makes; refinement changes `keep` and makes it anew.
class Attempt {
 public:
  Attempt(const TriangleMesh& surface, const ClosestPointTree& tree, const SweepResult& swept,
          const Options& options, double width, const RunContext& context, int threads)
      : walls_(surface, tree, swept, options.thickness, context, threads),
        surface_(surface),
        tree_(tree),
        swept_(swept),
        options_(options),
        width_(width),
        context_(context),
        threads_(threads) {}

  // Returns the triangles of assembly() that meet.
  std::vector<TriangleId> run(std::span<const std::uint8_t> keep, Stopwatch& watch) {
    walls_.fit(keep);
    const Carrier carrier = makeCarrier(swept_, walls_.positions(), surface_.triangles.size(), keep, width_);
    const ClosestPointTree carrierTree(carrier.mesh);
    const Membership membership(carrierTree, tree_, surface_.triangles.size(), options_.thickness);
    for (int attempt = 0;; ++attempt) {
      try {
        contour(gridFor(surface_, options_.thickness, width_, attempt), carrier, membership, watch);
        break;
      } catch (const GridTouches&) {
        if (attempt == kMostShifts)
          throw Error(ErrorCode::kNoSolid,
                      "no grid was found that the surface does not touch; change the cell width");
      }
    }
    const int rounds = options_.smooth.value_or(kDefaultRounds);
    const std::vector<Vec3> target =
        shapedPositions(assembly_, dual_, crossings_, membership, width_, rounds, context_, threads_);
    std::vector<TriangleId> meeting = settle(assembly_, target, context_, threads_);
    if (meeting.empty()) dropMisplaced(assembly_, threads_);
    watch.lap("shape");
    return meeting;
  }

  [[nodiscard]] const Assembly& assembly() const { return assembly_; }

 private:
  static constexpr int kMostShifts = 8;

  void contour(const UniformGrid& grid, const Carrier& carrier, const Membership& membership,
               Stopwatch& watch) {
    const auto onCarrier =
        surfaceCrossings(grid, carrier.mesh.positions, carrier.mesh.triangles, context_, threads_);
    const auto ways = rimWays(grid, carrier.mesh.positions, carrier.rim);
    const Labels labels(grid, membership, context_, threads_);
    watch.lap("field");
    crossings_ = findCrossings(grid, labels, onCarrier, context_, threads_);
    placeCrossings(crossings_, grid, membership, context_, threads_);
    dual_ = dualSurface(crossings_, ways, grid, carrier.mesh.positions);
    assembly_ = assemble(carrier, dual_, crossings_, ways);
    dropSpecks(assembly_, width_);
    watch.lap("faces");
  }

  DeepWalls walls_;
  const TriangleMesh& surface_;
  const ClosestPointTree& tree_;
  const SweepResult& swept_;
  const Options& options_;
  double width_;
  const RunContext& context_;
  int threads_;
  std::vector<Crossing> crossings_;
  DualSurface dual_;
  Assembly assembly_;
};

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
      Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
      for (const VertexId v : assembly.mesh.triangles[t]) {
        low = low.cwiseMin(assembly.mesh.positions[v]);
        high = high.cwiseMax(assembly.mesh.positions[v]);
      }
      for (const TriangleId s : shell.near(low - Vec3::Constant(reach), high + Vec3::Constant(reach))) {
        any |= keep[s] == 0;
        keep[s] = 1;
      }
    }
  if (any) closeFans(swept.mesh, keep);
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
      "the "
      "sheets apart there",
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

// Refuses what would not fit before any of it is taken, with the width that would.
void requireMemory(const TriangleMesh& surface, double r, double width, const RunContext& context) {
  const std::size_t bytes = fieldBytes(surface, width), limit = context.memoryLimit();
  if (limit == 0) return;
  const double fits = width * std::sqrt(double(bytes) / double(limit)) * 1.01;
  context.reserve(
      bytes, fits < r / 2 ? fmt::format("a cell width of {:.4g} mm would fit", fits)
                          : std::string("no cell width below half the thickness would fit; thicken a part of "
                                        "the surface at a time, or ask for a larger thickness"));
}

void requireCells(const TriangleMesh& surface, double r, double width) {
  const Bounds b = boundsOf(surface);
  const double longest = (b.high - b.low).maxCoeff() + 2 * r + 2 * (kMargin + 1) * width;
  if (longest / width < UniformGrid::kMostCells) return;
  throw Error(
      ErrorCode::kNoSolid,
      fmt::format("cells of {:.4g} mm would be more than {} in a row, and the thickness of {:.4g} mm asks "
                  "for cells below its half (Remark 1 of the paper); use the method sweep, or ask for a "
                  "larger thickness",
                  width, UniformGrid::kMostCells, r));
}

}  // namespace

double cellWidth(const TriangleMesh& surface, const Options& options) {
  const double r = options.thickness;
  if (options.cell) return *options.cell;
  const Bounds b = boundsOf(surface);
  const double longest = (b.high - b.low).maxCoeff() + 2 * r;
  if (options.resolution) {
    const double w = longest / *options.resolution;
    if (w >= r / 2)
      throw Error(
          ErrorCode::kInvalidArgument,
          fmt::format("a resolution of {} gives cells {:.4g} mm wide, which is not less than half the "
                      "thickness (Remark 1 of the paper); ask for a resolution of {} or more",
                      *options.resolution, w, static_cast<int>(std::floor(2 * longest / r)) + 1));
    return w;
  }
  // r/4 is round to within 1 %; coarser where that would take very many cells.
  constexpr double kManyCells = 4e5;
  const double byArea = std::sqrt(areaOf(surface) / kManyCells);
  return std::clamp(byArea, r / 4, r / 2.2);
}

std::size_t fieldBytes(const TriangleMesh& surface, double width) {
  // Measured: what a crossing costs in all its forms, with a margin; and crossings per w² of shell,
  // the mean of |n_x| + |n_y| + |n_z| with another for what the shell is larger than S.
  constexpr double kPerCrossing = 1500;
  constexpr double kCrossings = 1.5 * 1.25;
  return static_cast<std::size_t>(
      std::min(1e18, kPerCrossing * kCrossings * areaOf(surface) / (width * width)));
}

Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree, const Options& options,
                           const RunContext& context, int threads, Stopwatch& watch) {
  const double width = cellWidth(surface, options);
  requireCells(surface, options.thickness, width);
  requireMemory(surface, options.thickness, width, context);
  SweepResult swept = sweep(surface, tree, options.thickness, Side::kNegative, context, threads);
  watch.lap("sweep");
  std::vector<std::uint8_t> keep(swept.mesh.triangles.size(), 0), isShell(keep.size(), 0);
  for (std::size_t t = 0; t < keep.size(); ++t) {
    isShell[t] = swept.region[t] == Region::kShell;
    keep[t] = !isShell[t];
  }
  closeFans(swept.mesh, keep);
  const exact::BoxTree shell(swept.mesh.positions, swept.mesh.triangles, threads, isShell);
  Attempt attempt(surface, tree, swept, options, width, context, threads);
  for (std::size_t round = 0;; ++round) {
    const std::vector<TriangleId> meeting = attempt.run(keep, watch);
    if (meeting.empty()) {
      Reconstruction result = finish(attempt.assembly(), surface, swept, keep,
                                     depths(surface, tree, options.thickness, context, threads));
      result.rounds = round;
      result.cell = width;
      return result;
    }
    // In the end the whole sweep, which leaves nothing to contour.
    const double reach = width * kFirstReach * std::pow(kReachGrowth, static_cast<double>(round));
    if (round == kMostRefinements)
      std::fill(keep.begin(), keep.end(), std::uint8_t{1});
    else if (round > kMostRefinements ||
             !refine(swept, shell, attempt.assembly(), meeting, width, reach, keep))
      refuse(attempt.assembly(), meeting);
  }
}

}  // namespace thicken
