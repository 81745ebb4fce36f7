// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "thicken/error.h"

namespace thicken::pipeline {

namespace {

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ErrorCode::kInvalidArgument, sentence);
}

void requirePositive(double x, const char* what) {
  if (!std::isfinite(x) || x <= 0)
    refuse(fmt::format("the {} must be a positive number of millimetres, not {}", what, x));
}

// The least and the most of the thickness, mm; at the rim it may be the less by what is rounded off.
std::pair<double, double> thicknessRange(const Options& options) {
  double least = 1, most = 1;
  if (!options.thicknessMap.empty()) {
    const auto [low, high] = std::minmax_element(options.thicknessMap.begin(), options.thicknessMap.end());
    least = *low;
    most = *high;
  }
  least *= options.thickness;
  most *= options.thickness;
  if (options.rimThickness) {
    least = std::min(least, *options.rimThickness);
    most = std::max(most, *options.rimThickness);
  }
  return {least - options.rimRound.value_or(0), most};
}

void requireThickness(const Options& options) {
  requirePositive(options.thickness, "thickness");
  for (std::size_t v = 0; v < options.thicknessMap.size(); ++v)
    if (const double factor = options.thicknessMap[v]; !std::isfinite(factor) || factor <= 0)
      refuse(fmt::format("the factors of the thickness must be positive numbers, and that of vertex {} is {}",
                         v, factor));
}

void requireRimProfile(const Options& options) {
  if (options.rimThickness.has_value() != options.rimWidth.has_value())
    refuse(
        "a thickness of the rim and the width over which the solid becomes as thick elsewhere belong "
        "together: "
        "give both or neither");
  if (options.rimThickness) requirePositive(*options.rimThickness, "thickness of the rim");
  if (options.rimWidth) requirePositive(*options.rimWidth, "width of the rim");
  if (!options.rimRound) return;
  requirePositive(*options.rimRound, "radius of the rim");
  if (const double left = thicknessRange(options).first; left <= 0)
    refuse(
        fmt::format("the radius of the rim must be less than the thickness there, {:.6g} mm, not {:.6g} mm",
                    left + *options.rimRound, *options.rimRound));
}

double largestCoordinate(const TriangleMesh& surface) {
  double most = 0;
  for (const Vec3& p : surface.positions) most = std::max(most, p.cwiseAbs().maxCoeff());
  return most;
}

}  // namespace

void requireValid(const Options& options) {
  requireThickness(options);
  requireRimProfile(options);
  if (!std::isfinite(options.gap) || options.gap < 0)
    refuse(fmt::format("the gap must be 0 or a positive number of millimetres, not {}", options.gap));
  if (options.gap > 0 && options.side == Side::kBoth)
    refuse("a gap is on one side of the surface, and so is the solid: ask for one side");
  const int given = options.cell.has_value() + options.resolution.has_value() + options.tolerance.has_value();
  if (given > 1) refuse("give only one of cell, resolution and tolerance");
  if (options.cell) requirePositive(*options.cell, "cell width");
  const double thinnest = thicknessRange(options).first;
  if (options.cell && *options.cell >= thinnest / 2)
    refuse(fmt::format(
        "the cell width must be less than half the thickness, {:.6g} mm, so that the surface and the shell "
        "do not share a cell (Remark 1 of the paper), not {:.6g} mm",
        thinnest / 2, *options.cell));
  if (options.resolution && (*options.resolution < 4 || *options.resolution > 65536))
    refuse(fmt::format("the resolution must be from 4 to 65536 cells, not {}", *options.resolution));
  if (options.tolerance) requirePositive(*options.tolerance, "tolerance");
  if (options.smooth && (*options.smooth < 0 || *options.smooth > 100))
    refuse(fmt::format("the rounds of smoothing must be from 0 to 100, not {}", *options.smooth));
  if (options.threads < 0)
    refuse(fmt::format("the number of threads must not be negative, and is {}", options.threads));
  if (options.method == Method::kReconstruct && options.side == Side::kBoth)
    refuse("the method reconstruct thickens to one side; use auto or sweep for both sides");
  if (options.join == Join::kMitre && (options.tolerance || options.method == Method::kReconstruct))
    refuse(
        "mitred joins are farther from the surface than the thickness; a tolerance and the method "
        "reconstruct "
        "are for round ones: leave out the join, or ask for round");
  if (options.strict && !options.repair) refuse("strict judges what a repair made; ask for the repair, too");
  if (options.weld && !options.repair)
    refuse("a distance to weld corners over is part of a repair; ask for the repair, too");
  if ((options.bridge || options.fillHoles) && !options.repair)
    refuse("strips across gaps and patches in holes are part of a repair; ask for the repair, too");
  for (const auto& [length, what] : {std::pair{options.bridge, "the width of gaps to bridge"},
                                     std::pair{options.fillHoles, "the length of the rims of holes to fill"}})
    if (length && (!std::isfinite(*length) || *length <= 0))
      refuse(fmt::format("{} must be a positive number of millimetres, not {}", what, *length));
  if (options.weld && (!std::isfinite(*options.weld) || *options.weld < 0))
    refuse(
        fmt::format("the distance to weld corners over must be 0 or a positive number of millimetres, not {}",
                    *options.weld));
}

void requireMapOf(const TriangleMesh& surface, const Options& options) {
  const std::size_t values = options.thicknessMap.size();
  if (values != 0 && values != surface.positions.size())
    refuse(fmt::format("the thickness map has {} values, and the surface {} vertices", values,
                       surface.positions.size()));
}

void requireRoom(const TriangleMesh& surface, const Options& options) {
  constexpr double kFloatMax = std::numeric_limits<float>::max();
  // A mitre may reach farther than r.
  constexpr double kReach = 2;
  const double most = largestCoordinate(surface);
  const auto [thinnest, thickest] = thicknessRange(options);
  if (!(most + kReach * thickest < kFloatMax))
    throw Error(
        ErrorCode::kNotFinite,
        fmt::format(
            "coordinates as large as {:.6g} leave no room for a thickness of {:.6g} mm in single precision; "
            "scale the surface down or remove the vertices that lie far away",
            most, thickest));
  constexpr double kLeastSteps = 8;
  // Near the origin, too, floats have a least step.
  const double step = std::max<double>(std::ldexp(most, -23), std::numeric_limits<float>::denorm_min());
  if (thinnest < kLeastSteps * step)
    throw Error(
        ErrorCode::kNoSolid,
        fmt::format("at coordinates as large as {:.6g} mm single precision holds steps of {:.3g} mm, too "
                    "coarse for a "
                    "thickness of {:.6g} mm; move the surface to the origin or ask for a larger thickness",
                    most, step, thinnest));
}

double predictedCrossings(const SurfaceFacts& surface, const Options& options) {
  if (options.method == Method::kSweep || options.side == Side::kBoth) return 0;
  const bool isWhole = options.method == Method::kReconstruct || options.tolerance;
  // `auto` makes so much of the shell of it, in the mean over the test corpus.
  constexpr double kUsualShare = 0.02;
  constexpr double kMostCells = 6e5;
  const double r = options.thickness;
  double width = std::clamp(std::sqrt(surface.area / kMostCells), r / (isWhole ? 6 : 3.25), r / 2.2);
  // A tolerance takes up to four times as many cells.
  if (options.tolerance) width = std::clamp(std::sqrt(3 * *options.tolerance * r), width / 2, width);
  if (options.cell) width = *options.cell;
  if (options.resolution) width = (surface.diagonal / std::sqrt(3.0) + 2 * r) / *options.resolution;
  constexpr double kCrossings = 1.5;  // a cell: the mean of |n_x| + |n_y| + |n_z|
  const double crossings = (isWhole ? 1 : kUsualShare) * kCrossings * surface.area / (width * width);
  return crossings < 1e15 ? crossings : 0;  // else a surface that check() refuses
}

Work workFor(const SurfaceFacts& surface, const Options& options) {
  // Counted in runs over a few surfaces of the test corpus, where a unit is some 50 microseconds.
  const auto triangles = static_cast<double>(surface.triangles);
  Work work;
  work.check = 0.1 * triangles;
  work.sweep = 0.5 * triangles;
  work.contour = 0.4 * triangles + 0.2 * predictedCrossings(surface, options);
  work.audit = 0.2 * triangles;
  work.measure = 0.06 * triangles;
  work.tolerance = triangles;
  return work;
}

}  // namespace thicken::pipeline
