// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/thicken.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "check/audit.h"
#include "gap.h"
#include "invariants.h"
#include "measure/error_bound.h"
#include "measure/measure.h"
#include "measure/offset_error.h"
#include "measure/stopwatch.h"
#include "measure/warnings.h"
#include "mesh/float_lattice.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "plan.h"
#include "platform/memory.h"
#include "reconstruct/cells.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/shell_plan.h"
#include "repair/folds.h"
#include "repair/outcome.h"
#include "simplify/simplify.h"
#include "sweep/sweep.h"

namespace thicken {

namespace {

// Shares of the progress at which stages end.
constexpr double kChecked = 0.12, kSwept = 0.4, kShaped = 0.7, kSimplified = 0.82, kAudited = 0.92,
                 kMeasured = 0.96;

TriangleMesh stored(const TriangleMesh& surface, Precision precision, int threads) {
  if (precision == Precision::kDouble) return weld(surface, threads);
  TriangleMesh rounded = surface;
  for (Vec3& p : rounded.positions) p = roundToFloat(p);
  return weld(rounded, threads);
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

// Whether a contour is made where the sweep is short.
bool isDeepened(const Options& options) {
  return options.method == Method::kAuto && options.side != Side::kBoth;
}

// The side of such a surface that is swept.
Side sweptSide(Side side) {
  return side == Side::kBoth ? Side::kBoth : Side::kNegative;
}

// The solid of either method, with what every report says of its run.
template <class Made>
Solid assemble(Made made, Method method, const SurfaceFacts& input, const Options& options, int threads) {
  Solid solid;
  solid.mesh = std::move(made.mesh);
  solid.region = std::move(made.region);
  solid.depth = std::move(made.depth);
  Report& report = solid.report;
  report.input = input;
  report.thickness = options.thickness;
  report.side = options.side;
  report.join = joinOf(options);
  report.asked = options.method;
  report.method = method;
  report.threads = threads;
  report.rounds = made.rounds;
  return solid;
}

void proveOrThrow(Solid& solid, const TriangleMesh& surface, Side side, const RunContext& context,
                  int threads, std::span<const TriangleId> order = {}) {
  const std::size_t most = auditedAtATime(solid.mesh.triangles.size(), heldBytes(surface), context);
  AuditResult proof = audit(solid.mesh, surface, side, context, threads, order, most);
  solid.report.audit = proof.facts;
  if (proof.facts.passed()) return;
  std::string why = proof.defects.empty() ? "the audit failed" : proof.defects.front().sentence;
  throw Error(ErrorCode::kNoSolid, "no valid solid was found: " + why, std::move(proof.defects));
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

// The sweep alone.
Solid sweptSolid(SweepResult made, const SurfaceFacts& input, const Options& options, int threads) {
  const std::size_t dropped = made.droppedCopies;
  Solid solid = assemble(std::move(made), Method::kSweep, input, options, threads);
  solid.report.droppedCopies = dropped;
  return solid;
}

// Where the contour's solid has the sweep's shell for want of better: an entry a connected piece.
std::vector<Fallback> piecesLeft(const Reconstruction& made, int threads) {
  std::vector<Triangle> left;
  for (std::size_t t = 0; t < made.left.size(); ++t)
    if (made.left[t]) left.push_back(made.mesh.triangles[t]);
  if (left.empty()) return {};
  const Components pieces = componentsOf(made.mesh.positions.size(), left, threads);
  std::vector<Fallback> fallbacks(
      pieces.count,
      {"contour",
       "triangles of the contour met each other or the wall there, in cells of every width that was tried",
       Vec3::Zero(), 0});
  for (std::size_t t = 0; t < left.size(); ++t) {
    Fallback& piece = fallbacks[pieces.ofTriangle[t]];
    const double area = areaOf(made.mesh.positions, left[t]);
    piece.area += area;
    for (const VertexId v : left[t]) piece.place += area / 3 * made.mesh.positions[v];
  }
  for (Fallback& piece : fallbacks) piece.place /= piece.area;
  return fallbacks;
}

Solid reconstructedSolid(Reconstruction made, Method method, const SurfaceFacts& input,
                         const Options& options, int threads) {
  std::vector<Fallback> left = piecesLeft(made, threads);
  const double cell = made.cell, finest = made.finest;
  const std::size_t predicted = made.predicted, cells = made.cells, nodes = made.nodes;
  Solid solid = assemble(std::move(made), method, input, options, threads);
  std::swap(solid.report.rounds, solid.report.attempts);  // a contour has no rounds
  solid.report.cell = cell;
  solid.report.fieldCells = cells;
  solid.report.fieldNodes = nodes;
  solid.report.finestCell = finest;
  solid.report.predictedMemory = predicted;
  solid.report.fallbacks = std::move(left);
  return solid;
}

// Whether the sweep, which needs no field, is the answer when the contour fails so.
bool leavesTheSweep(const Error& e) {
  return e.code() == ErrorCode::kNoSolid || e.code() == ErrorCode::kMemoryLimit ||
         (e.code() == ErrorCode::kInternal && !violationsEndRuns);
}

// What the report says where the sweep stands for all of a contour that failed in a `stage`.
Fallback fallbackFor(const Error& e, std::string stage, const TriangleMesh& surface) {
  if (e.code() == ErrorCode::kMemoryLimit) stage = "memory";
  if (e.code() == ErrorCode::kInternal) stage = "internal";
  Fallback fallback{std::move(stage), e.what(), Vec3::Zero(), areaOf(surface)};
  if (!e.defects().empty()) fallback.place = e.defects().front().place;
  fallback.enoughMemory = e.enoughMemory();
  return fallback;
}

// The solids that a method may come to, the better one first, and what was made of less than it was to be.
struct Made {
  std::optional<Solid> better, swept;
  ShellDistances sweptShell;
  std::vector<TriangleId> sweptOrder;  ///< audit()'s, for the sweep
  std::vector<Fallback> fallbacks;
};

// Makes the better solid. Where there is none, the sweep stands for it, and `made` says so.
template <class Make>
void makeBetter(Made& made, const TriangleMesh& surface, Make make) {
  try {
    made.better = make();
  } catch (const Error& e) {
    if (!leavesTheSweep(e)) throw;
    made.fallbacks.push_back(fallbackFor(e, "contour", surface));
  }
}

void takeSweep(Made& made, SweepResult swept, const SurfaceFacts& input, const Options& options,
               int threads) {
  made.sweptShell = {std::move(swept.distance), std::move(swept.nearest)};
  made.sweptOrder = std::move(swept.order);
  made.swept = sweptSolid(std::move(swept), input, options, threads);
}

// The sweep with the contour of the field where it is short of the thickness; the contour alone where the
// sweep would be short of it nearly everywhere.
Made madeByAuto(const TriangleMesh& oriented, const ClosestPointTree& tree, const SurfaceFacts& input,
                const Options& options, const Work& work, const RunContext& context, int threads,
                Stopwatch& watch) {
  Made made;
  const double r = options.thickness;
  std::optional<SweepResult> swept =
      sweepUnlessShort(oriented, tree, r, mostShort(oriented, options, context), context, threads);
  watch.lap("sweep");
  context.enter(Stage::kField, kSwept, kShaped, work.contour);
  if (!swept) {
    makeBetter(made, oriented, [&] {
      return reconstructedSolid(reconstruct(oriented, tree, options, context, threads, watch), Method::kAuto,
                                input, options, threads);
    });
    if (made.better) return made;
    swept = sweep(oriented, tree, r, Side::kNegative, context, threads);
  }
  makeBetter(made, oriented, [&]() -> std::optional<Solid> {
    auto deepened = deepen(oriented, tree, *swept, options, context, threads, watch);
    if (!deepened) return std::nullopt;
    return reconstructedSolid(std::move(*deepened), Method::kAuto, input, options, threads);
  });
  takeSweep(made, *std::move(swept), input, options, threads);
  return made;
}

Made madeBy(const TriangleMesh& oriented, const ClosestPointTree& tree, const SurfaceFacts& input,
            const Options& options, const Work& work, const RunContext& context, int threads,
            Stopwatch& watch) {
  const Side side = sweptSide(options.side);
  if (isDeepened(options)) return madeByAuto(oriented, tree, input, options, work, context, threads, watch);
  Made made;
  if (options.method == Method::kReconstruct) {
    made.better = reconstructedSolid(reconstruct(oriented, tree, options, context, threads, watch),
                                     Method::kReconstruct, input, options, threads);
    return made;
  }
  takeSweep(made, sweep(oriented, tree, options.thickness, side, context, threads), input, options, threads);
  watch.lap("sweep");
  return made;
}

// Simplifies and proves the better of the two, or the sweep where the other fails.
template <class Simplified>
Solid provedOf(Made& made, const Simplified& simplified, const TriangleMesh& surface,
               const TriangleMesh& oriented, const ClosestPointTree& tree, const SurfaceFacts& input,
               const Options& options, const RunContext& context, int threads) {
  if (made.better) try {
      simplified(*made.better);
      proveOrThrow(*made.better, surface, options.side, context, threads);
      return *std::move(made.better);
    } catch (const Error& e) {
      if (options.method != Method::kAuto || !leavesTheSweep(e)) throw;
      made.fallbacks.push_back(fallbackFor(e, "audit", surface));
    }
  if (!made.swept)
    takeSweep(made, sweep(oriented, tree, options.thickness, Side::kNegative, context, threads), input,
              options, threads);
  simplified(*made.swept);
  proveOrThrow(*made.swept, surface, options.side, context, threads,
               made.swept->report.simplify.after == made.swept->report.simplify.before
                   ? std::span<const TriangleId>(made.sweptOrder)
                   : std::span<const TriangleId>());
  return *std::move(made.swept);
}

// Merges triangles of a solid into fewer where there is memory for that.
void simplifySolid(Solid& solid, const TriangleMesh& oriented, const ClosestPointTree& tree,
                   const Options& options, const RunContext& context, int threads) {
  SimplifyRequest request{
      oriented, tree, options.thickness, options.side, joinOf(options), options.tolerance, options.simplify};
  const std::size_t needed = heldBytes(oriented) + bytesToSimplify(solid.mesh.triangles.size());
  if (request.what != Simplify::kOff && context.memoryLimit() != 0 && needed > context.memoryLimit()) {
    request.what = Simplify::kOff;
    solid.report.warnings.push_back(
        fmt::format("the solid has more triangles than it needs: merging them takes {} MiB, more than "
                    "the memory limit",
                    (needed >> 20) + 1));
  }
  solid.report.simplify = simplify(solid.mesh, solid.region, request, context, threads);
}

// A solid of a valid surface, proved and measured.
Solid provedSolid(const TriangleMesh& surface, const TriangleMesh& oriented, const ClosestPointTree& tree,
                  const SurfaceFacts& input, const Options& options, RunContext context, int threads,
                  Stopwatch& watch) {
  const Work work = workFor(input, options);
  context.enter(Stage::kSweeping, kChecked, isDeepened(options) ? kSwept : kShaped,
                options.method == Method::kReconstruct ? work.contour : work.sweep);
  Made made = madeBy(oriented, tree, input, options, work, context, threads, watch);

  const auto simplified = [&](Solid& solid) {
    // A unit is 256 triangles, or as many edges that a collapse is tried at: some six a triangle.
    context.enter(Stage::kShaping, kShaped, kSimplified,
                  static_cast<double>(solid.mesh.triangles.size()) / 30);
    simplifySolid(solid, oriented, tree, options, context, threads);
    watch.lap("simplify");
    context.enter(Stage::kAuditing, kSimplified, kAudited, work.audit);
  };
  Solid solid = provedOf(made, simplified, surface, oriented, tree, input, options, context, threads);
  solid.report.fallbacks.insert(solid.report.fallbacks.end(), made.fallbacks.begin(), made.fallbacks.end());
  watch.lap("audit");

  context.enter(Stage::kMeasuring, kAudited, options.tolerance ? kMeasured : 1, work.measure);
  const SimplifyFacts& fewer = solid.report.simplify;
  if (solid.report.method != Method::kSweep || fewer.after != fewer.before)
    made.sweptShell = {};  // another mesh than the sweep's
  measure(solid, oriented, tree, std::move(made.sweptShell),
          options.tolerance ? Measure::kAll : Measure::kRepresentative, context, threads);
  watch.lap("measure");
  return solid;
}

// The solid of a valid surface.
Solid solidOf(const TriangleMesh& surface, const SurfaceFacts& input, const Options& options,
              const RunContext& context, int threads, Stopwatch& watch) {
  const TriangleMesh oriented = orientedFor(options.side, surface);
  const ClosestPointTree tree(oriented, threads);
  watch.lap("tree");
  if (!options.tolerance)
    return provedSolid(surface, oriented, tree, input, options, context, threads, watch);
  Solid solid = provedSolid(surface, oriented, tree, input, options, context, threads, watch);
  context.enter(Stage::kMeasuring, kMeasured, 1, workFor(input, options).tolerance);
  const ErrorBound bound = boundShellError(solid.mesh, solid.region, tree, options.thickness, options.side,
                                           *options.tolerance, context, threads);
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

// The vertices of a surface that a sweep finds no room below.
std::vector<VertexId> trySweep(TriangleMesh surface, const Options& options, const RunContext& context,
                               int threads) {
  surface = orientedFor(options.side, std::move(surface));
  try {
    (void)sweep(surface, ClosestPointTree(surface, threads), options.thickness, sweptSide(options.side),
                context, threads, Polish::kNo);
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
Solid solidOfRepaired(RepairResult& surface, const Options& options, RunContext context, int threads,
                      Stopwatch& watch, Known& known) {
  repairing::FoldOpener folds(
      [&](const TriangleMesh& patch) { return trySweep(patch, options, context, threads); });
  for (int attempt = 0;; ++attempt) {
    try {
      return solidOf(surface.mesh, *known.input, options, context, threads, watch);
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
  const int threads = threadCount(options.threads);
  Stopwatch watch;

  TriangleMesh given = stored(input, options.precision, threads);
  const SurfaceFacts sizes = sizesOf(given);
  const Forecast predicted = forecast(sizes, options);
  context.enter(Stage::kChecking, 0, kChecked, workFor(sizes, options).check);
  known.predictedMemory = predicted.leastBytes;
  context.reserve(predicted.leastBytes, "thicken a part of the surface at a time, or simplify it first");
  RepairResult surface = validSurface(std::move(given), options, context, threads, watch, known);
  requireRoom(surface.mesh, options);
  const NearRims near =
      surface.facts.surface.rims > 0 ? nearRims(surface.mesh, context, threads) : NearRims{};

  Solid solid = solidOfRepaired(surface, options, context, threads, watch, known);
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
  addWarnings(solid.report);
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
  requireValid(options);
  if (options.gap > 0) return thickenAtGap(surface, options, std::move(context));
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
