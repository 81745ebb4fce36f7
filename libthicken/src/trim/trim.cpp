// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/trim.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/float_lattice.h"
#include "mesh/place_text.h"
#include "thicken/check.h"
#include "thicken/error.h"
#include "trim/parts.h"
#include "trim/path_cutter.h"
#include "trim/trim_line_error.h"

namespace thicken {

using mesh::text;
using trimming::CutPath;
using trimming::Ground;
using trimming::PathCutter;

namespace trimming {

Error trimLineError(const std::string& sentence, const Vec3& place) {
  Defect d;
  d.code = ErrorCode::kInvalidArgument;
  d.sentence = sentence;
  d.count = 1;
  d.place = place;
  return {ErrorCode::kInvalidArgument, sentence, {d}};
}

}  // namespace trimming

namespace {

// Corners of a path go onto a vertex within so many steps of float: nearer ones would leave pieces that
// rounding turns over. Where the first distance does not do the next one is tried, as in meshes with needles.
constexpr std::array<double, 4> kFloatSteps{16, 128, 1024, 8192};

constexpr int kMostSmoothing = 5;

void requireSmoothing(int rounds) {
  if (rounds < 0 || rounds > kMostSmoothing)
    throw Error(ErrorCode::kInvalidArgument,
                fmt::format("the rounds of smoothing must be from 0 to {}, not {}", kMostSmoothing, rounds));
}

// Throws unless every triangle of `surface` has its neighbours and an area. Returns what is known of it.
SurfaceFacts requireSurface(const TriangleMesh& surface, const RunContext& context, int threads) {
  CheckResult result = check(surface, context, threads);
  std::erase_if(result.defects, [](const Defect& d) { return d.code == ErrorCode::kSelfIntersecting; });
  if (result.valid()) return result.facts;
  Error error(result.defects.front().code, result.defects.front().sentence, result.defects);
  error.setInput(result.facts);
  throw error;
}

TriangleMesh prepared(const TriangleMesh& surface, Precision precision, int threads) {
  if (precision == Precision::kDouble) return weld(surface, threads);
  TriangleMesh rounded = surface;
  for (Vec3& p : rounded.positions) p = mesh::roundToFloat(p);
  return weld(rounded, threads);
}

struct Attempt {
  TrimmedSurface result;
  std::vector<Defect> defects;  // of the part
  bool isOwn = false;           // whether they are the surface's own: no piece of a divided triangle has any
};

// Whether a defect of the part has to do with a piece of a divided triangle.
bool concernsPieces(const TrimmedSurface& part, const Defect& defect) {
  if (defect.triangles.empty()) return true;
  return std::any_of(defect.triangles.begin(), defect.triangles.end(),
                     [&](TriangleId t) { return t >= part.facts.untouched; });
}

Attempt attempt(const Ground& ground, const std::vector<TrimLoop>& loops, const TrimOptions& options,
                double tolerance, const RunContext& context, int threads) {
  PathCutter cutter(ground, tolerance);
  Attempt made;
  TrimmedSurface& result = made.result;
  std::vector<std::vector<VertexId>> paths;
  for (const TrimLoop& loop : loops) {
    context.throwIfCancelled();
    CutPath path = cutter.cut(loop, true);
    result.facts.loops.push_back(path.facts);
    result.paths.emplace_back();
    for (const VertexId v : path.vertices) result.paths.back().push_back(cutter.surface().at(v));
    paths.push_back(std::move(path.vertices));
  }
  result.facts.deviation = cutter.deviation();
  const trimming::Parts parts(cutter.surface(), cutter.marks(), paths);
  const std::uint32_t kept = options.keep ? parts.at(cutter.pieceAt(*options.keep)) : parts.inside();
  for (const std::size_t loop : parts.loopsWithin(kept)) {
    const Vec3& place = result.paths[loop].front();
    throw trimming::trimLineError(
        fmt::format(
            "loop {} at {} does not cut a part off: the surface goes on around it, through a hole or a "
            "handle; add a loop there",
            loop + 1, text(place)),
        place);
  }
  for (const std::size_t loop : parts.loopsAwayFrom(kept))
    result.facts.warnings.push_back(
        fmt::format("loop {} does not border the part that stays, and changes nothing", loop + 1));
  parts.extract(kept, result);
  CheckResult checked = check(result.mesh, context, threads);
  result.facts.surface = checked.facts;
  made.defects = std::move(checked.defects);
  made.isOwn = std::none_of(made.defects.begin(), made.defects.end(),
                            [&](const Defect& d) { return concernsPieces(result, d); });
  return made;
}

Error tooNarrow(const trimming::TooNarrow& narrow) {
  return trimming::trimLineError(
      fmt::format(
          "the triangles at {} are too narrow to be divided there in single precision; move the points of "
          "the loop that are near",
          text(narrow.place)),
      narrow.place);
}

Error notValid(const std::vector<Defect>& defects) {
  return {defects.front().code, "the part that stays is no valid surface: " + defects.front().sentence,
          defects};
}

}  // namespace

TrimmedSurface trim(const TriangleMesh& surface, std::span<const TrimLoop> loops, const TrimOptions& options,
                    RunContext context, int threads) {
  requireSmoothing(options.smooth);
  if (loops.empty()) throw Error(ErrorCode::kInvalidArgument, "there is no loop to trim along");
  context.enter(Stage::kChecking, 0, 0.4, 0);
  const TriangleMesh whole = prepared(surface, options.precision, threads);
  const SurfaceFacts facts = requireSurface(whole, context, threads);
  std::vector<TrimLoop> smooth;
  for (const TrimLoop& loop : loops) smooth.push_back(trimming::smoothed(loop, true, options.smooth));
  const Ground ground(whole, threads);
  std::optional<Error> failure;
  for (std::size_t i = 0; i < kFloatSteps.size(); ++i) {
    context.enter(Stage::kJoining, 0.4 + 0.1 * static_cast<double>(i), 0.5 + 0.1 * static_cast<double>(i), 0);
    try {
      Attempt made = attempt(ground, smooth, options, kFloatSteps[i] * ground.floatStep, context, threads);
      made.result.facts.input = facts;
      if (made.defects.empty()) return std::move(made.result);
      failure = notValid(made.defects);
      if (made.isOwn) break;
    } catch (const trimming::TooNarrow& narrow) {
      failure = tooNarrow(narrow);
    }
  }
  failure->setInput(facts);
  throw *failure;
}

struct SurfacePaths::Impl {
  explicit Impl(const TriangleMesh& s, int threads) : surface(weld(s, threads)) {
    (void)requireSurface(surface, {}, threads);
    ground = std::make_unique<Ground>(surface, threads);
  }
  TriangleMesh surface;
  std::unique_ptr<Ground> ground;
};

SurfacePaths::SurfacePaths(const TriangleMesh& surface, int threads)
    : impl_(std::make_unique<Impl>(surface, threads)) {}
SurfacePaths::~SurfacePaths() = default;
SurfacePaths::SurfacePaths(SurfacePaths&&) noexcept = default;
SurfacePaths& SurfacePaths::operator=(SurfacePaths&&) noexcept = default;

TrimLoop SurfacePaths::path(std::span<const Vec3> points, bool closed, int smooth) const {
  requireSmoothing(smooth);
  const TrimLoop through = trimming::smoothed(points, closed, smooth);
  for (std::size_t i = 0;; ++i) {
    try {
      PathCutter cutter(*impl_->ground, kFloatSteps[i] * impl_->ground->floatStep);
      TrimLoop path;
      for (const VertexId v : cutter.cut(through, closed).vertices) path.push_back(cutter.surface().at(v));
      return path;
    } catch (const trimming::TooNarrow& narrow) {
      if (i + 1 == kFloatSteps.size()) throw tooNarrow(narrow);
    }
  }
}

}  // namespace thicken
