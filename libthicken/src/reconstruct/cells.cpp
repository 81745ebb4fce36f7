// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "field/uniform_grid.h"
#include "mesh/bounds.h"
#include "reconstruct/reconstruct.h"
#include "thicken/error.h"

namespace thicken {

namespace {

// Refuses what would not fit before any of it is taken, with the width that would.
void requireMemory(double area, double r, double width, const RunContext& context) {
  const std::size_t bytes = fieldBytes(area, width), limit = context.memoryLimit();
  if (limit == 0) return;
  const double fits = width * std::sqrt(double(bytes) / double(limit)) * 1.01;
  context.reserve(
      bytes, fits < r / 2 ? fmt::format("a cell width of {:.4g} mm would fit", fits)
                          : std::string("no cell width below half the thickness would fit; thicken a part of "
                                        "the surface at a time, or ask for a larger thickness"));
}

void requireCells(const TriangleMesh& surface, double r, double width) {
  const Bounds b = boundsOf(surface);
  const double longest = (b.high - b.low).maxCoeff() + 2 * r + 8 * width;
  if (longest / width < UniformGrid::kMostCells) return;
  throw Error(
      ErrorCode::kNoSolid,
      fmt::format("cells of {:.4g} mm would be more than {} in a row, and the thickness of {:.4g} mm asks "
                  "for cells below its half (Remark 1 of the paper); use the method sweep, or ask for a "
                  "larger thickness",
                  width, UniformGrid::kMostCells, r));
}

}  // namespace

bool hasRoomForField(double area, double width, const RunContext& context) {
  return context.memoryLimit() == 0 || fieldBytes(area, width) <= context.memoryLimit();
}

void requireRoomForField(const TriangleMesh& surface, double area, double r, double width,
                         const RunContext& context) {
  requireCells(surface, r, width);
  requireMemory(area, r, width, context);
}

double cellWidth(const TriangleMesh& surface, double area, const Options& options, double mostCells) {
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
  // r/6 is round to within 0.2 % nearly everywhere; coarser where that would take very many cells. A
  // tolerance that asks for finer ones may have up to four times as many; none helps with one that is out of
  // reach.
  const double usual = r / 6, wanted = std::sqrt(3 * options.tolerance.value_or(r) * r);
  const double finest = wanted >= r / 20 ? std::min(wanted, usual) : usual;
  const double byArea = std::sqrt(area / mostCells) * std::max(finest / usual, 0.5);
  return std::clamp(byArea, finest, r / 2.2);
}

std::size_t fieldBytes(double area, double width) {
  // Measured: what a crossing costs in all its forms, with a margin; and crossings per w² of shell,
  // the mean of |n_x| + |n_y| + |n_z| with another for what the shell is larger than S.
  constexpr double kPerCrossing = 1500;
  constexpr double kCrossings = 1.5 * 1.25;
  return static_cast<std::size_t>(std::min(1e18, kPerCrossing * kCrossings * area / (width * width)));
}

}  // namespace thicken
