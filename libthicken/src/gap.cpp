// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "job/rim_profile.h"
#include "job/thickness.h"
#include "measure/measure.h"
#include "measure/warnings.h"
#include "mesh/place_text.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "plan.h"
#include "repair/fans.h"
#include "repair/outcome.h"
#include "repair/workpiece.h"
#include "thicken/thicken.h"

namespace thicken::pipeline {

using measure::repairWarning;
using mesh::text;
using parallel::parallelFor;

namespace {

// Below this share of what was asked for a gap is too small.
constexpr double kTooSmall = 0.9;
// Of the progress: the solid of the gap surface has more triangles around it.
constexpr double kGapShare = 0.4;

// The options of the first solid, whose shell becomes the gap surface. That shell is round, so that it is at
// the gap from S beside edges of S, too.
Options optionsOfGap(const Options& options) {
  Options first = job::withoutRimProfile(options);
  first.gap = 0;
  first.thickness = options.gap;
  first.thicknessMap.clear();
  first.cell.reset();
  first.resolution.reset();
  if (!first.join) first.join = Join::kRound;
  return first;
}

// Factors of the thickness at the vertices of the gap surface: those of the closest points of S.
std::vector<double> mapOn(const TriangleMesh& gapSurface, const TriangleMesh& surface,
                          const std::vector<double>& factors, const RunContext& context, int threads) {
  if (factors.empty()) return {};
  const job::Thickness ofSurface(surface, factors);
  const ClosestPointTree tree(surface, threads);
  std::vector<double> map(gapSurface.positions.size());
  parallelFor(map.size(), threads, context, 256,
              [&](std::size_t v) { map[v] = ofSurface.at(*tree.closest(gapSurface.positions[v])); });
  return map;
}

// The options of the solid of the gap surface, which has no defects to repair.
Options optionsOfSolid(const Options& options, std::vector<double> thicknessMap) {
  Options second = options;
  second.thicknessMap = std::move(thicknessMap);
  second.gap = 0;
  second.repair = second.strict = false;
  second.weld.reset();
  second.bridge.reset();
  second.fillHoles.reset();
  return second;
}

// The triangles of a region of a solid as a surface whose normals are those of S.
TriangleMesh surfaceOf(const Solid& solid, Region region, bool turned) {
  TriangleMesh surface;
  surface.positions = solid.mesh.positions;
  for (std::size_t t = 0; t < solid.region.size(); ++t) {
    if (solid.region[t] != region) continue;
    auto [a, b, c] = solid.mesh.triangles[t];
    if (turned) std::swap(b, c);
    surface.triangles.push_back({a, b, c});
  }
  return surface;
}

// How far each vertex is from S.
std::vector<double> distances(const std::vector<Vec3>& positions, const ClosestPointTree& tree,
                              const RunContext& context, int threads) {
  std::vector<double> distance(positions.size());
  parallelFor(distance.size(), threads, context, 256,
              [&](std::size_t v) { distance[v] = tree.distance(positions[v]); });
  return distance;
}

// Leaves out the triangles of a shell that are nearer to S than `least`: for want of room they are not at the
// gap.
void dropNear(TriangleMesh& shell, std::span<const double> distance, double least, double& leftOut) {
  std::erase_if(shell.triangles, [&](const Triangle& t) {
    const auto [a, b, c] = t;
    if (std::min({distance[a], distance[b], distance[c]}) >= least) return false;
    leftOut += measure::areaOf(shell.positions, t);
    return true;
  });
}

// Makes a surface of a shell: parts of a shell may touch in points, and shreds may lie between walls. Parts
// smaller than the square of the gap go, but for the largest.
TriangleMesh withoutShreds(TriangleMesh shell, double gap, double& leftOut) {
  const mesh::VertexTriangles around = mesh::vertexTriangles(shell.positions.size(), shell.triangles);
  repairing::Workpiece piece(std::move(shell));
  repairing::openNonManifoldVertices(piece, around);
  const std::size_t count = piece.mesh.triangles.size();
  std::vector<Triangle> left;
  std::vector<double> area;
  for (TriangleId t = 0; t < count; ++t)
    if (piece.present[t] == 0) {
      leftOut += piece.area(t);
    } else {
      left.push_back(piece.mesh.triangles[t]);
      area.push_back(piece.area(t));
    }
  const mesh::Components parts = mesh::componentsOf(piece.mesh.positions.size(), left);
  std::vector<double> size(parts.count, 0);
  for (std::size_t t = 0; t < left.size(); ++t) size[parts.ofTriangle[t]] += area[t];
  const double least = size.empty() ? 0 : std::min(gap * gap, *std::max_element(size.begin(), size.end()));
  TriangleMesh surface{std::move(piece.mesh.positions), {}};
  for (std::size_t t = 0; t < left.size(); ++t)
    if (size[parts.ofTriangle[t]] >= least)
      surface.triangles.push_back(left[t]);
    else
      leftOut += area[t];
  return weld(surface);
}

// Where the solid comes nearest to S.
void measureClearance(GapFacts& gap, const ClosestPointTree& tree, const TriangleMesh& solid,
                      const RunContext& context, int threads) {
  const std::vector<double> distance = distances(solid.positions, tree, context, threads);
  const auto least = std::min_element(distance.begin(), distance.end());
  gap.least = *least;
  gap.leastPlace = solid.positions[static_cast<std::size_t>(least - distance.begin())];
}

// `place`: where S has the least room.
void warnOfGap(Report& report, const Vec3& place) {
  const GapFacts& gap = *report.gap;
  constexpr double kMuch = 1e-3;  // of the area
  std::string told;
  if (gap.shortShare >= kMuch)
    told = fmt::format(
        "there is no room for the gap of {:.4g} mm at {} of the surface, such as at {}, and no solid there",
        gap.asked, measure::percentText(gap.shortShare), text(place));
  if (gap.least < kTooSmall * gap.asked)
    told += fmt::format(
        "{}the solid comes within {:.4g} mm of the surface at {}, nearer than the gap of {:.4g} mm",
        told.empty() ? "" : "; ", gap.least, text(gap.leastPlace), gap.asked);
  if (!told.empty()) report.warnings.insert(report.warnings.begin(), told);
}

// What the report of the solid says of the run as a whole.
void addFirst(Report& report, const Report& first) {
  std::vector<std::string> told;
  if (first.repair) {
    told = repairing::additions(*first.repair);
    if (const auto mended = repairWarning(first)) told.insert(told.begin(), *mended);
  }
  report.warnings.insert(report.warnings.begin(), told.begin(), told.end());
  report.input = first.input;
  report.nearRims = first.nearRims;
  report.repair = first.repair;
  report.seconds.insert(report.seconds.begin(), first.seconds.begin(), first.seconds.end());
  report.predictedSeconds += first.predictedSeconds;
  report.predictedMemory = std::max(report.predictedMemory, first.predictedMemory);
  report.enoughMemory = std::max(report.enoughMemory, first.enoughMemory);
  report.fallbacks.insert(report.fallbacks.begin(), first.fallbacks.begin(), first.fallbacks.end());
}

// The solid of the gap surface. Where folds of it leave no room for a wall, they are opened: it is no scan
// that has to be kept.
Solid solidBehind(TriangleMesh& gapSurface, Options options, const RunContext& context, double& leftOut) {
  try {
    return thicken(gapSurface, options, context);
  } catch (const Error& error) {
    const bool isFold = error.code() == ErrorCode::kNoSolid && !error.defects().empty() &&
                        !error.defects().front().vertices.empty();
    if (!isFold) throw;
  }
  options.repair = true;
  Solid solid = thicken(gapSurface, options, context);
  gapSurface = *std::move(solid.repaired);
  leftOut += solid.report.repair->removedArea;
  std::erase(solid.report.warnings, repairWarning(solid.report).value_or(""));
  return solid;
}

// Drops the ids of an error's defects: they are those of the gap surface, which the caller has not seen.
[[noreturn]] void refuseBehindGap(const Error& error, const Report& first, double gap) {
  std::vector<Defect> defects = error.defects();
  for (Defect& d : defects) {
    d.vertices.clear();
    d.edges.clear();
    d.triangles.clear();
  }
  Error told(error.code(),
             error.code() == ErrorCode::kNoSolid
                 ? fmt::format("behind the surface at the gap of {:.4g} mm: {}", gap, error.what())
                 : std::string(error.what()),
             std::move(defects));
  told.setInput(first.input);
  if (first.repair) told.setRepair(*first.repair);
  told.setEnoughMemory(std::max(error.enoughMemory(), first.enoughMemory));
  told.setEnoughSeconds(error.enoughSeconds());
  throw told;
}

}  // namespace

Solid thickenAtGap(const TriangleMesh& surface, const Options& options, RunContext context) {
  requireMapOf(surface, options);
  const auto [begin, end] = context.part();
  const double middle = begin + kGapShare * (end - begin);
  context.setPart(begin, middle);
  Solid first = thicken(surface, optionsOfGap(options), context);
  GapFacts gap;
  gap.asked = options.gap;
  gap.error = first.report.shellErrorFullDepth;
  gap.shortShare = first.report.thinShare;
  const bool turned = options.side == Side::kNegative;
  const int threads = parallel::threadCount(options.threads);
  const ClosestPointTree tree(weld(surfaceOf(first, Region::kOriginal, false)), threads);
  TriangleMesh shell = surfaceOf(first, Region::kShell, turned);
  dropNear(shell, distances(shell.positions, tree, context, threads), kTooSmall * options.gap, gap.leftOut);
  TriangleMesh gapSurface = withoutShreds(std::move(shell), options.gap, gap.leftOut);
  if (gapSurface.triangles.empty())
    throw Error(ErrorCode::kNoSolid,
                fmt::format("no part of the surface has room for a gap of {:.4g} mm; ask for a smaller one",
                            options.gap));
  context.setPart(middle, end);
  try {
    Solid solid = solidBehind(
        gapSurface,
        optionsOfSolid(options, mapOn(gapSurface, surface, options.thicknessMap, context, threads)), context,
        gap.leftOut);
    gap.surface = check(gapSurface, context, options.threads).facts;
    measureClearance(gap, tree, solid.mesh, context, threads);
    addFirst(solid.report, first.report);
    solid.report.gap = gap;
    warnOfGap(solid.report, first.report.thinnestPlace);
    solid.gapSurface = std::move(gapSurface);
    solid.repaired = std::move(first.repaired);
    return solid;
  } catch (const Error& error) {
    refuseBehindGap(error, first.report, options.gap);
  }
}

}  // namespace thicken::pipeline
