// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "measure/warnings.h"
#include "mesh/place_text.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "plan.h"
#include "repair/fans.h"
#include "repair/outcome.h"
#include "repair/workpiece.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

// Below this share of what was asked for a gap is too small.
constexpr double kTooSmall = 0.9;
// Of the progress: the solid of the gap surface has more triangles around it.
constexpr double kGapShare = 0.4;

// What S is thickened to first. Its shell is round, so that it is at the gap from S beside edges of S, too.
Options optionsOfGap(double gap, const Options& options) {
  Options first = options;
  first.thickness = gap;
  first.cell.reset();
  first.resolution.reset();
  if (!first.join) first.join = Join::kRound;
  return first;
}

// What the gap surface is thickened to. It has no defects.
Options optionsOfSolid(const Options& options) {
  Options second = options;
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

// Parts of a shell may touch in points, and shreds lie between walls: a surface has neither. Parts of less
// than the square of the gap go, but for the largest.
TriangleMesh withoutShreds(TriangleMesh shell, double gap, double& leftOut) {
  const VertexTriangles around = vertexTriangles(shell.positions.size(), shell.triangles);
  repairing::Workpiece piece(std::move(shell));
  repairing::openPinchedVertices(piece, around);
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
  const Components parts = componentsOf(piece.mesh.positions.size(), left);
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
void measureClearance(GapFacts& gap, const TriangleMesh& surface, const TriangleMesh& solid,
                      const RunContext& context, int threads) {
  const ClosestPointTree tree(weld(surface), threads);
  std::vector<double> distance(solid.positions.size());
  parallelFor(distance.size(), threads, context, 256,
              [&](std::size_t v) { distance[v] = tree.distance(solid.positions[v]); });
  const auto least = std::min_element(distance.begin(), distance.end());
  gap.least = *least;
  gap.leastPlace = solid.positions[static_cast<std::size_t>(least - distance.begin())];
}

void warnOfGap(const GapFacts& gap, Report& report) {
  constexpr double kMuch = 1e-3;  // of the area
  if (gap.least >= kTooSmall * gap.asked && gap.shortShare < kMuch) return;
  report.warnings.insert(
      report.warnings.begin(),
      fmt::format(
          "the gap of {:.4g} mm is not kept everywhere: the solid comes within {:.4g} mm of the surface at "
          "{}, and {} of the surface has no room for 0.9 of the gap",
          gap.asked, gap.least, text(gap.leastPlace),
          gap.shortShare > 0 ? percentText(gap.shortShare) : "nothing"));
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

// The ids of what is wrong are those of the gap surface, which nobody has seen.
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

GapSolid thickenAtGap(const TriangleMesh& surface, double gap, const Options& options, RunContext context,
                      double begin, double end) {
  requireValid(options);
  if (!std::isfinite(gap) || gap <= 0)
    throw Error(ErrorCode::kInvalidArgument,
                fmt::format("the gap must be a positive number of millimetres, not {}", gap));
  if (options.side == Side::kBoth)
    throw Error(ErrorCode::kInvalidArgument,
                "a gap is on one side of the surface, and so is the solid: ask for one side");
  const double middle = begin + kGapShare * (end - begin);
  context.setPart(begin, middle);
  Solid first = thicken(surface, optionsOfGap(gap, options), context);
  GapSolid result;
  GapFacts& facts = result.facts;
  facts.asked = gap;
  facts.error = first.report.shellError;
  facts.shortShare = first.report.thinShare;
  result.surface =
      withoutShreds(surfaceOf(first, Region::kShell, options.side == Side::kNegative), gap, facts.leftOut);
  if (result.surface.triangles.empty())
    throw Error(
        ErrorCode::kNoSolid,
        fmt::format("no part of the surface has room for a gap of {:.4g} mm; ask for a smaller one", gap));
  facts.surface = check(result.surface, context, options.threads).facts;
  context.setPart(middle, end);
  try {
    result.solid = thicken(result.surface, optionsOfSolid(options), context);
  } catch (const Error& error) {
    refuseBehindGap(error, first.report, gap);
  }
  measureClearance(facts, surfaceOf(first, Region::kOriginal, false), result.solid.mesh, context,
                   threadCount(options.threads));
  addFirst(result.solid.report, first.report);
  warnOfGap(facts, result.solid.report);
  result.solid.repaired = std::move(first.repaired);
  return result;
}

}  // namespace thicken
