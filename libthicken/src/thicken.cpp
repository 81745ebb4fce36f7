// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/thicken.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "gap.h"
#include "job/rim_profile.h"
#include "make_solid.h"
#include "measure/error_bound.h"
#include "measure/warnings.h"
#include "mesh/float_lattice.h"
#include "mesh/vertex_values.h"
#include "parallel/parallel_for.h"
#include "plan.h"
#include "platform/memory.h"
#include "progress.h"
#include "repair/folds.h"
#include "repair/outcome.h"
#include "sweep/sweep.h"

namespace thicken {

using job::Stopwatch;
using job::thicknessOf;
using measure::ErrorBound;
using pipeline::workFor;
using platform::peakMemory;

namespace {

// The factors of the thickness at places, whatever becomes of the mesh that they were given for.
struct ThicknessMap {
  TriangleMesh places;
  std::vector<double> factors;  // per vertex of it; empty: there is none
  [[nodiscard]] std::vector<double> on(const TriangleMesh& surface) const {
    return factors.empty() ? std::vector<double>()
                           : mesh::valuesAt(places, factors, surface, "the thickness map");
  }
};

// Holds the places only where there is a map.
ThicknessMap mapAt(TriangleMesh places, const Options& options) {
  if (options.thicknessMap.empty()) return {};
  return {std::move(places), options.thicknessMap};
}

// The surface in the coordinates that it will be stored in, not welded yet.
TriangleMesh stored(TriangleMesh surface, Precision precision) {
  if (precision == Precision::kSingle)
    for (Vec3& p : surface.positions) p = mesh::roundToFloat(p);
  return surface;
}

void throwDefects(std::vector<Defect> defects) {
  std::string sentence = defects.front().sentence;
  if (defects.size() > 1) sentence += fmt::format(" (and {} more kinds of defect)", defects.size() - 1);
  const ErrorCode code = defects.front().code;
  throw Error(code, sentence, std::move(defects));
}

// The surface with its negative side where the material is to be.
TriangleMesh orientedFor(Side side, TriangleMesh surface) {
  if (side == Side::kPositive)
    for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

[[noreturn]] void refuseTolerance(const ErrorBound& bound, double tolerance) {
  Defect d;
  d.code = ErrorCode::kNoSolid;
  d.count = 1;
  d.place = bound.place;
  d.sentence = fmt::format(
      "the shell is up to {:.4g} mm from its definition near ({:.6g}, {:.6g}, {:.6g}), which is more than "
      "the tolerance of {:.4g} mm; ask for a larger tolerance or a smaller thickness",
      bound.most, d.place.x(), d.place.y(), d.place.z(), tolerance);
  const std::string sentence = d.sentence;
  throw Error(ErrorCode::kNoSolid, sentence, {std::move(d)});
}

// What is known of the surface once it has been looked at; a failure takes it along.
struct Known {
  std::optional<SurfaceFacts> input;
  std::optional<RepairFacts> repair;
  std::size_t predictedMemory = 0;
};

// The surface to thicken: valid as it is or, where that is asked for, repaired.
RepairResult validSurface(TriangleMesh surface, const Options& options, RunContext context, int threads,
                          Stopwatch& watch, Known& known) {
  CheckResult checked = check(surface, context, threads);
  watch.lap("check");
  known.input = checked.facts;
  if (!options.repair && !checked.valid()) throwDefects(std::move(checked.defects));
  const bool joins = options.weld || options.bridge || options.fillHoles;
  if (options.repair && (joins || !checked.valid())) {
    RepairResult mended =
        repair(surface, {options.weld, options.bridge, options.fillHoles}, context, threads);
    known.repair = mended.facts;
    watch.lap("repair");
    return mended;
  }
  RepairResult as;
  as.mesh = std::move(surface);
  as.facts.surface = checked.facts;
  if (options.repair) {
    as.origin.resize(as.mesh.triangles.size());
    std::iota(as.origin.begin(), as.origin.end(), 0u);
    known.repair = as.facts;
  }
  return as;
}

// The solid of a valid surface, within the tolerance where there is one.
Solid solidOf(const TriangleMesh& surface, const ThicknessMap& map, const SurfaceFacts& input,
              const Options& options, RunContext context, int threads, Stopwatch& watch) {
  const TriangleMesh oriented = orientedFor(options.side, surface);
  const ClosestPointTree tree(oriented, threads);
  watch.lap("tree");
  std::optional<ThicknessFacts> facts;
  std::optional<RimFacts> rim;
  const job::Job job{oriented, tree,    thicknessOf(oriented, options, map.on(oriented), facts, rim),
                     options,  context, threads,
                     watch};
  Solid solid = pipeline::makeSolid(job, surface, input);
  solid.report.thicknessMap = facts;
  solid.report.rim = rim;
  if (!options.tolerance) return solid;
  context.enter(Stage::kMeasuring, pipeline::progress::kMeasured, 1, workFor(input, options).tolerance);
  const ErrorBound bound = measure::boundShellError(job, solid.mesh, solid.region, *options.tolerance);
  watch.lap("tolerance");
  if (bound.most > *options.tolerance) refuseTolerance(bound, *options.tolerance);
  solid.report.shellErrorBound = bound.most;
  return solid;
}

// The vertices that a failed run names as those without room; none for other failures.
std::vector<VertexId> verticesWithoutRoom(const Error& error) {
  if (error.code() != ErrorCode::kNoSolid || error.defects().empty()) return {};
  return error.defects().front().vertices;
}

// The vertices of a surface that a sweep finds no room below. It may be a patch, whose rim is not that of S.
std::vector<VertexId> trySweep(TriangleMesh surface, const ThicknessMap& map, const Options& asked,
                               const RunContext& context, int threads) {
  const Options options = job::withoutRimProfile(asked);
  surface = orientedFor(options.side, std::move(surface));
  const ClosestPointTree tree(surface, threads);
  Stopwatch watch;
  std::optional<ThicknessFacts> facts;
  std::optional<RimFacts> rim;
  const job::Thickness thickness = thicknessOf(surface, options, map.on(surface), facts, rim);
  try {
    (void)sweep::sweep({surface, tree, thickness, options, context, threads, watch}, sweep::Polish::kNo);
  } catch (const Error& error) {
    const std::vector<VertexId> vertices = verticesWithoutRoom(error);
    if (vertices.empty()) throw;
    return vertices;
  }
  return {};
}

// Of a surface that lost more than this share of its area no more is taken away.
constexpr double kMostRemoved = 0.5;

// Where a repair is asked for, folds that no wall fits below are opened, a few triangles at a time.
Solid solidOfRepaired(RepairResult& surface, const ThicknessMap& map, const Options& options,
                      RunContext context, int threads, Stopwatch& watch, Known& known) {
  repairing::FoldOpener folds(
      [&](const TriangleMesh& patch) { return trySweep(patch, map, options, context, threads); });
  for (int attempt = 0;; ++attempt) {
    try {
      return solidOf(surface.mesh, map, *known.input, options, context, threads, watch);
    } catch (const Error& error) {
      const std::vector<VertexId> vertices = verticesWithoutRoom(error);
      const bool tooMuch = surface.facts.removedArea > kMostRemoved * known.input->area;
      if (!options.repair || vertices.empty() || tooMuch || attempt == repairing::FoldOpener::kMostAttempts)
        throw;
      watch.lap("sweep");
      surface = folds.open(surface, vertices, context, threads);
      known.repair = surface.facts;
      watch.lap("repair");
    }
  }
}

Solid thickenKnown(const TriangleMesh& input, const Options& options, RunContext context, Known& known) {
  const int threads = parallel::threadCount(options.threads);
  Stopwatch watch;

  pipeline::requireMapOf(input, options);
  TriangleMesh places = stored(input, options.precision);
  TriangleMesh given = weld(places, threads);
  const ThicknessMap map = mapAt(std::move(places), options);
  const SurfaceFacts sizes = sizesOf(given);
  const Forecast predicted = forecast(sizes, options);
  context.enter(Stage::kChecking, 0, pipeline::progress::kChecked, workFor(sizes, options).check);
  known.predictedMemory = predicted.leastBytes;
  context.reserve(predicted.leastBytes, "thicken a part of the surface at a time, or simplify it first");
  RepairResult surface = validSurface(std::move(given), options, context, threads, watch, known);
  pipeline::requireRoom(surface.mesh, options);
  const NearRims near =
      surface.facts.surface.rims > 0 ? nearRims(surface.mesh, context, threads) : NearRims{};

  Solid solid = solidOfRepaired(surface, map, options, context, threads, watch, known);
  const std::size_t limit = context.memoryLimit();
  const std::size_t expected = limit == 0 ? predicted.bytes : std::min(predicted.bytes, limit);
  solid.report.predictedMemory = std::max(solid.report.predictedMemory, expected);
  solid.report.predictedSeconds = predicted.seconds;
  solid.report.peakMemory = peakMemory();
  solid.report.enoughMemory = std::max(solid.report.predictedMemory, solid.report.peakMemory);
  for (const Fallback& f : solid.report.fallbacks)
    solid.report.enoughMemory = std::max(solid.report.enoughMemory, f.enoughMemory);
  solid.report.seconds = watch.laps();
  if (options.repair) {
    solid.report.repair = known.repair;
    solid.repaired = std::move(surface.mesh);
  }
  solid.report.nearRims = near;
  measure::addWarnings(solid.report);
  if (known.repair)
    for (std::string& told : repairing::additions(*known.repair))
      solid.report.warnings.push_back(std::move(told));
  if (const std::optional<std::string> why = repairing::shortcoming(solid)) {
    if (options.strict) throw Error(ErrorCode::kNoSolid, *why);
    solid.report.warnings.push_back(*why);
  }
  context.enter(Stage::kDone, 1, 1, 0);
  return solid;
}

}  // namespace

Solid thicken(const TriangleMesh& surface, const Options& options, RunContext context) {
  pipeline::requireValid(options);
  if (options.gap > 0) return pipeline::thickenAtGap(surface, options, std::move(context));
  Known known;
  try {
    return thickenKnown(surface, options, std::move(context), known);
  } catch (Error& error) {
    if (known.input) error.setInput(*known.input);
    if (known.repair) error.setRepair(std::move(*known.repair));
    error.setEnoughMemory(std::max({error.enoughMemory(), known.predictedMemory, peakMemory()}));
    throw;
  }
}

}  // namespace thicken
