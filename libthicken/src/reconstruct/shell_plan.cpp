// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/shell_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "measure/measure.h"
#include "mesh/half_edges.h"
#include "parallel_for.h"
#include "reconstruct/reconstruct.h"

namespace thicken {

namespace {

// Error that a contour has nearly everywhere, in w²/r².
double contourError(double width, double r) {
  constexpr double kCellError = 0.06;
  return kCellError * width * width / (r * r);
}

// Error of the sweep's shell that is left as it is, in r: below it cells of the default width are no better.
double errorToLeave(const Options& options) {
  constexpr double kEnough = 0.0015;
  constexpr double kFinest = 5e-4;
  if (!options.tolerance) return kEnough;
  return std::clamp(*options.tolerance / (2 * options.thickness), kFinest, kEnough);
}

// How far each triangle of the sweep's shell is from the thickness, mm, in its corners and its middle; 0 for
// others. Where corners alone are farther than any contour is left for, the middle is not looked at.
std::vector<double> shellErrors(const SweepResult& swept, const ClosestPointTree& tree, double r,
                                const RunContext& context, int threads) {
  const double most = r * contourError(r / 2, r);
  std::vector<double> error(swept.mesh.triangles.size(), 0);
  parallelFor(error.size(), threads, context, 256, [&](std::size_t t) {
    if (swept.region[t] != Region::kShell) return;
    Vec3 middle = Vec3::Zero();
    for (const VertexId v : swept.mesh.triangles[t]) {
      error[t] = std::max(error[t], std::abs(swept.distance[v] - r));
      middle += swept.mesh.positions[v] / 3;
    }
    if (error[t] <= most) error[t] = std::max(error[t], std::abs(tree.distance(middle) - r));
  });
  return error;
}

// Cells along an edge of a triangle beside a contour: its rim is divided by cells, and a fan of so many
// slivers costs exact tests by their square.
constexpr double kMostAlongEdge = 400;

double longestEdge(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
  return std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
}

ShellPlan planFor(const TriangleMesh& surface, const SweepResult& swept, std::span<const double> errors,
                  double error, const Options& options) {
  ShellPlan plan;
  const double longest = kMostAlongEdge * options.thickness / 2.2;
  for (TriangleId t = 0; t < errors.size(); ++t) {
    plan.keep.push_back(errors[t] <= error || longestEdge(swept.mesh, t) > longest);
  }
  plan.area = openArea(swept, plan.keep);
  if (plan.keepsAll()) return plan;
  plan.width = cellWidth(surface, plan.area, options, kManyBesideSweep);
  return plan;
}

// The error that triangles of at most `area` mm² exceed: the worst are contoured, the rest is left.
double affordableError(const TriangleMesh& mesh, std::span<const double> errors, double area) {
  std::vector<std::pair<double, double>> worst;  // error, area
  for (std::size_t t = 0; t < errors.size(); ++t)
    if (errors[t] > 0) worst.emplace_back(errors[t], areaOf(mesh.positions, mesh.triangles[t]));
  std::sort(worst.begin(), worst.end(), std::greater<>());
  double sum = 0;
  for (const auto& [error, own] : worst)
    if ((sum += own) > area) return error;
  return 0;
}

// Whether the sweep is as good as a contour nearly everywhere, and never far off.
bool isNearlyAll(const ShellPlan& plan, const SweepResult& swept, std::span<const double> errors, double r) {
  constexpr double kRest = 0.005, kMostOff = 0.01;  // of the shell's area; in r
  double shell = 0;
  for (std::size_t t = 0; t < errors.size(); ++t) {
    if (errors[t] > kMostOff * r) return false;
    if (swept.region[t] == Region::kShell) shell += areaOf(swept.mesh.positions, swept.mesh.triangles[t]);
  }
  return plan.area <= kRest * shell;
}

// Cells that the contour passes, and those that the rim beside it is divided by: scattered large triangles
// have much of that.
double cellsOf(const TriangleMesh& mesh, const ShellPlan& plan) {
  if (plan.keepsAll()) return 0;
  const HalfEdges edges(mesh.positions.size(), mesh.triangles, plan.keep);
  double rim = 0;
  edges.forEachEdge([&](VertexId a, VertexId b, auto forth, auto back) {
    if (forth.size() + back.size() == 1) rim += (mesh.positions[a] - mesh.positions[b]).norm();
  });
  return plan.area / (plan.width * plan.width) + rim / plan.width;
}

}  // namespace

double openArea(const SweepResult& swept, std::span<const std::uint8_t> keep) {
  double area = 0;
  for (std::size_t t = 0; t < keep.size(); ++t)
    if (!keep[t]) area += areaOf(swept.mesh.positions, swept.mesh.triangles[t]);
  return area;
}

ShellPlan planShell(const TriangleMesh& surface, const SweepResult& swept, const ClosestPointTree& tree,
                    const Options& options, const RunContext& context, int threads) {
  const double r = options.thickness, finest = errorToLeave(options);
  const std::vector<double> errors = shellErrors(swept, tree, r, context, threads);
  ShellPlan plan = planFor(surface, swept, errors, finest * r, options);
  if (plan.keepsAll()) return plan;
  if (!options.tolerance && isNearlyAll(plan, swept, errors, r)) {
    std::fill(plan.keep.begin(), plan.keep.end(), std::uint8_t{1});
    return plan;
  }
  // Wider cells are no better than a sweep that is off by as much.
  const double error = contourError(plan.width, r);
  if (error > finest) plan = planFor(surface, swept, errors, error * r, options);
  // A thickness far below the extent of the surface would take any number of cells. The widest ones go
  // farthest.
  const double width = plan.width;
  for (double area = std::min(plan.area, kManyBesideSweep * width * width);
       cellsOf(swept.mesh, plan) > kManyBesideSweep; area /= 2) {
    plan = planFor(surface, swept, errors, affordableError(swept.mesh, errors, area), options);
    plan.width = width;
  }
  return plan;
}

}  // namespace thicken
