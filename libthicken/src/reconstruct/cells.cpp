// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/cells.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "field/uniform_grid.h"
#include "mesh/bounds.h"
#include "mesh/normals.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

using field::UniformGrid;
using job::Job;
using mesh::Bounds;
using mesh::boundsOf;

namespace {

// The least width of cells that fit, given that cells of `width` make so many crossings; infinite: none.
double widthThatFits(std::size_t crossings, std::size_t held, double width, std::size_t limit) {
  const std::size_t fixed = held + leanBytes(0);
  if (limit <= fixed) return std::numeric_limits<double>::infinity();
  return width * std::sqrt(double(leanBytes(crossings) - leanBytes(0)) / double(limit - fixed)) * 1.01;
}

// Refuses cells that would not fit before any memory is taken. The sentence has a width that would.
void requireMemory(std::size_t crossings, std::size_t held, double r, double width,
                   const RunContext& context) {
  const std::size_t limit = context.memoryLimit();
  if (limit == 0) return;
  const double fits = widthThatFits(crossings, held, width, limit);
  context.reserve(held + leanBytes(crossings),
                  fits < r / 2
                      ? fmt::format("a cell width of {:.4g} mm would fit", fits)
                      : std::string("no cell width below half the thickness would fit; thicken a part of "
                                    "the surface at a time, or ask for a larger thickness"));
}

}  // namespace

bool hasRoomForField(const Job& job, std::size_t crossings) {
  const std::size_t limit = job.context.memoryLimit();
  return limit == 0 || heldBytes(job.surface) + leanBytes(crossings) <= limit;
}

void requireCells(const Job& job, double width) {
  const Bounds b = boundsOf(job.surface);
  const double longest = (b.high - b.low).maxCoeff() + 2 * job.thickness.most() + 8 * width;
  if (longest / width < UniformGrid::kMostCells) return;
  throw Error(
      ErrorCode::kNoSolid,
      fmt::format("cells of {:.4g} mm would be more than {} in a row, and the thickness of {:.4g} mm asks "
                  "for cells below its half (Remark 1 of the paper); use the method sweep, or ask for a "
                  "larger thickness",
                  width, UniformGrid::kMostCells, job.thickness.least()));
}

WorkingSet requireRoomForField(const Job& job, std::size_t crossings, double width) {
  requireCells(job, width);
  const std::size_t held = heldBytes(job.surface);
  requireMemory(crossings, held, job.thickness.least(), width, job.context);
  return workingSetFor(crossings, held, job.context);
}

double widthWithRoom(const Job& job, std::size_t crossings, double width) {
  const Options& options = job.options;
  if (options.cell || options.resolution || options.tolerance || hasRoomForField(job, crossings))
    return width;
  return widthThatFits(crossings, heldBytes(job.surface), width, job.context.memoryLimit());
}

double cellWidth(const Job& job, double area, double mostCells) {
  const Options& options = job.options;
  const double r = job.thickness.least();
  if (options.cell) return *options.cell;
  const Bounds b = boundsOf(job.surface);
  const double longest = (b.high - b.low).maxCoeff() + 2 * job.thickness.most();
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
  // r/6 is round to within 0.2 % nearly everywhere, and r/3.25 within 0.6 %, which is enough beside a sweep
  // that is left within 1 %; coarser where that would take very many cells. A tolerance that asks for finer
  // ones may have up to four times as many; none helps with one that is out of reach.
  const bool isFine = options.tolerance || options.method == Method::kReconstruct;
  const double usual = r / (isFine ? 6 : 3.25), wanted = std::sqrt(3 * options.tolerance.value_or(r) * r);
  const double finest = wanted >= r / 20 ? std::min(wanted, usual) : usual;
  const double byArea = std::sqrt(area / mostCells) * std::max(finest / usual, 0.5);
  return std::clamp(byArea, finest, r / 2.2);
}

std::size_t mostCrossings(double area, double width) {
  // Per w² of shell the mean of |n_x| + |n_y| + |n_z|, with a margin for what the shell is larger than S.
  constexpr double kCrossings = 1.5 * 1.25;
  return static_cast<std::size_t>(std::min(1e15, kCrossings * area / (width * width)));
}

double shellShadows(const Job& job) {
  const TriangleMesh& surface = job.surface;
  // A triangle crosses as many lines of the grid as its shadows along the axes are large. The shell's is that
  // of S with its vertices moved along their normals, less what turns over, which other parts of S cut off.
  const auto normal =
      mesh::vertexNormals(surface.positions, surface.triangles,
                          mesh::faceNormals(surface.positions, surface.triangles, job.threads), job.threads);
  double shadows = 0;
  for (const Triangle& t : surface.triangles) {
    std::array<Vec3, 3> p, q;
    for (int k = 0; k < 3; ++k) {
      p[k] = surface.positions[t[k]];
      q[k] = p[k] - job.thickness.at(t[k]) * normal[t[k]];
    }
    const Vec3 area = (q[1] - q[0]).cross(q[2] - q[0]) / 2;
    if (area.dot((p[1] - p[0]).cross(p[2] - p[0])) > 0) shadows += area.cwiseAbs().sum();
  }
  return shadows;
}

std::size_t mostShellCrossings(double shadows, double width) {
  constexpr double kMargin = 1.1;
  return static_cast<std::size_t>(std::min(1e15, kMargin * shadows / (width * width)));
}

std::size_t heldBytes(const TriangleMesh& surface) {
  // Measured, with a margin: what a second thread holds for itself, 2 MiB, is part of the base.
  constexpr std::size_t kPerTriangle = 900, kBase = std::size_t{13} << 20;
  return kBase + kPerTriangle * surface.triangles.size();
}

}  // namespace thicken::reconstruct
