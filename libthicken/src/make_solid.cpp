// SPDX-License-Identifier: LGPL-2.1-or-later
#include "make_solid.h"

#include <fmt/format.h>

#include <utility>

#include "check/audit.h"
#include "invariants.h"
#include "measure/measure.h"
#include "measure/offset_error.h"
#include "mesh/topology.h"
#include "progress.h"
#include "reconstruct/cells.h"
#include "reconstruct/reconstruct.h"
#include "reconstruct/shell_plan.h"
#include "simplify/simplify.h"
#include "sweep/sweep.h"
#include "thicken/error.h"

namespace thicken::pipeline {

using job::Job;
using measure::areaOf;
using measure::Measure;
using reconstruct::heldBytes;
using reconstruct::Reconstruction;
using sweep::SweepResult;

namespace {

// Where the contour's solid has the sweep's shell for want of better: an entry a connected piece.
std::vector<Fallback> piecesLeft(const Reconstruction& made, int threads) {
  std::vector<Triangle> left;
  for (std::size_t t = 0; t < made.left.size(); ++t)
    if (made.left[t]) left.push_back(made.mesh.triangles[t]);
  if (left.empty()) return {};
  const mesh::Components pieces = mesh::componentsOf(made.mesh.positions.size(), left, threads);
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

class SolidMaker {
 public:
  SolidMaker(const Job& job, const TriangleMesh& given, const SurfaceFacts& input)
      : job_(job),
        given_(given),
        input_(input),
        method_(job.options.method),
        work_(workFor(input, job.options)),
        context_(job.context) {}

  Solid make() {
    const bool deepens = method_ == Method::kAuto && job_.options.side != Side::kBoth;
    context_.enter(Stage::kSweeping, progress::kChecked, deepens ? progress::kSwept : progress::kShaped,
                   method_ == Method::kReconstruct ? work_.contour : work_.sweep);
    if (deepens) {
      makeBoth();
    } else if (method_ == Method::kReconstruct) {
      better_ = ofContour(reconstruct::reconstruct(job_));
    } else {
      takeSweep(sweep::sweep(job_));
      job_.watch.lap("sweep");
    }
    Solid solid = proved();
    solid.report.fallbacks.insert(solid.report.fallbacks.end(), fallbacks_.begin(), fallbacks_.end());
    job_.watch.lap("audit");
    measureIt(solid);
    return solid;
  }

 private:
  // The sweep with the contour of the field where it is short of the thickness; the contour alone where the
  // sweep would be short of it nearly everywhere.
  void makeBoth() {
    std::optional<SweepResult> swept = sweep::sweepUnlessShort(job_, reconstruct::mostShort(job_));
    job_.watch.lap("sweep");
    context_.enter(Stage::kField, progress::kSwept, progress::kShaped, work_.contour);
    if (!swept) {
      makeBetter([&] { return std::optional(reconstruct::reconstruct(job_)); });
      if (better_) return;
      swept = sweep::sweep(job_);
    }
    makeBetter([&] { return reconstruct::deepen(job_, *swept); });
    takeSweep(*std::move(swept));
  }

  // Makes the better solid. Where there is none, the sweep stands for it, and the report says so.
  template <class Make>
  void makeBetter(Make make) {
    try {
      if (auto made = make()) better_ = ofContour(*std::move(made));
    } catch (const Error& e) {
      if (!leavesTheSweep(e)) throw;
      fallbacks_.push_back(fallbackFor(e, "contour", job_.surface));
    }
  }

  void takeSweep(SweepResult made) {
    sweptShell_ = {std::move(made.distance), std::move(made.nearest)};
    sweptOrder_ = std::move(made.order);
    const std::size_t dropped = made.droppedCopies;
    swept_ = assembled(std::move(made), Method::kSweep);
    swept_->report.droppedCopies = dropped;
  }

  Solid ofContour(Reconstruction made) {
    std::vector<Fallback> left = piecesLeft(made, job_.threads);
    const double cell = made.cell, finest = made.finest;
    const std::size_t predicted = made.predicted, cells = made.cells, nodes = made.nodes;
    Solid solid = assembled(std::move(made), method_);
    std::swap(solid.report.rounds, solid.report.attempts);  // a contour has no rounds
    solid.report.cell = cell;
    solid.report.fieldCells = cells;
    solid.report.fieldNodes = nodes;
    solid.report.finestCell = finest;
    solid.report.predictedMemory = predicted;
    solid.report.fallbacks = std::move(left);
    return solid;
  }

  // The solid of either method, with what every report says of its run.
  template <class Made>
  Solid assembled(Made made, Method method) {
    Solid solid;
    solid.mesh = std::move(made.mesh);
    solid.region = std::move(made.region);
    solid.depth = std::move(made.depth);
    Report& report = solid.report;
    report.input = input_;
    report.thickness = job_.options.thickness;
    report.side = job_.options.side;
    report.join = measure::joinOf(job_.options);
    report.asked = method_;
    report.method = method;
    report.threads = job_.threads;
    report.rounds = made.rounds;
    return solid;
  }

  // Simplifies and proves the better of the two, or the sweep where the other fails.
  Solid proved() {
    if (better_) try {
        simplifyIt(*better_);
        prove(*better_, {});
        return *std::move(better_);
      } catch (const Error& e) {
        if (method_ != Method::kAuto || !leavesTheSweep(e)) throw;
        fallbacks_.push_back(fallbackFor(e, "audit", given_));
      }
    if (!swept_) takeSweep(sweep::sweep(job_));
    simplifyIt(*swept_);
    const SimplifyFacts& fewer = swept_->report.simplify;
    prove(*swept_, fewer.after == fewer.before ? std::span<const TriangleId>(sweptOrder_)
                                               : std::span<const TriangleId>());
    return *std::move(swept_);
  }

  // Merges triangles into fewer where there is memory for that.
  void simplifyIt(Solid& solid) {
    const std::size_t before = solid.mesh.triangles.size();
    // A unit is 256 triangles, or as many edges that a collapse is tried at: some six a triangle.
    context_.enter(Stage::kShaping, progress::kShaped, progress::kSimplified,
                   static_cast<double>(before) / 30);
    Simplify what = job_.options.simplify;
    const std::size_t needed = heldBytes(job_.surface) + simplify::bytesToSimplify(before);
    if (what != Simplify::kOff && context_.memoryLimit() != 0 && needed > context_.memoryLimit()) {
      what = Simplify::kOff;
      solid.report.warnings.push_back(
          fmt::format("the solid has more triangles than it needs: merging them takes {} MiB, more than "
                      "the memory limit",
                      (needed >> 20) + 1));
    }
    solid.report.simplify = simplify::simplify(job_, solid.mesh, solid.region, what);
    job_.watch.lap("simplify");
  }

  // `order`: audit()'s.
  void prove(Solid& solid, std::span<const TriangleId> order) {
    context_.enter(Stage::kAuditing, progress::kSimplified, progress::kAudited, work_.audit);
    const std::size_t most =
        reconstruct::auditedAtATime(solid.mesh.triangles.size(), heldBytes(given_), context_);
    checking::AuditResult proof =
        checking::audit(solid.mesh, given_, job_.options.side, context_, job_.threads, order, most);
    solid.report.audit = proof.facts;
    if (proof.facts.passed()) return;
    std::string why = proof.defects.empty() ? "the audit failed" : proof.defects.front().sentence;
    throw Error(ErrorCode::kNoSolid, "no valid solid was found: " + why, std::move(proof.defects));
  }

  void measureIt(Solid& solid) {
    const bool isProved = job_.options.tolerance.has_value();
    context_.enter(Stage::kMeasuring, progress::kAudited, isProved ? progress::kMeasured : 1, work_.measure);
    const SimplifyFacts& fewer = solid.report.simplify;
    if (solid.report.method != Method::kSweep || fewer.after != fewer.before)
      sweptShell_ = {};  // another mesh than the sweep's
    measure::measure(solid, job_, std::move(sweptShell_),
                     isProved ? Measure::kAll : Measure::kRepresentative);
    job_.watch.lap("measure");
  }

  const Job& job_;
  const TriangleMesh& given_;
  const SurfaceFacts& input_;
  Method method_;
  Work work_;
  RunContext context_;
  std::optional<Solid> better_, swept_;  // that the method may come to
  measure::ShellDistances sweptShell_;
  std::vector<TriangleId> sweptOrder_;  // audit()'s, for the sweep
  std::vector<Fallback> fallbacks_;     // what was made of less than it was to be
};

}  // namespace

Solid makeSolid(const Job& job, const TriangleMesh& given, const SurfaceFacts& input) {
  return SolidMaker(job, given, input).make();
}

}  // namespace thicken::pipeline
