// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/shell_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "bvh/spatial_order.h"
#include "measure/measure.h"
#include "measure/offset_error.h"
#include "measure/shell_samples.h"
#include "mesh/half_edges.h"
#include "mesh/normals.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "reconstruct/cells.h"

namespace thicken::reconstruct {

using bvh::SpatialOrder;
using job::Job;
using measure::areaOf;
using sweep::SweepResult;

namespace {

// Error that a contour with cells of `width` has nearly everywhere (99 % of its area), mm: measured over
// spheres, tori and the open surfaces of the test corpus, at widths from r/2.2 to r/12.
double contourError(double width, double r) {
  constexpr double kCellError = 0.06;
  return kCellError * width * width / r;
}

// How far a triangle of the sweep's shell may be off for it to stay, mm.
double errorToLeave(const Job& job) {
  // A resin printer draws 25 to 50 µm, which is 1 % of a wall of some millimetres.
  constexpr double kDrawn = 0.01;
  return job.options.tolerance ? *job.options.tolerance / 2 : kDrawn * job.thickness.least();
}

double longestEdge(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
  return std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
}

// Whether Definition 2 ends the solid within `reach` mm of a point `p` whose closest point on S is `c`,
// short of the thickness: halfway to another sheet.
bool endsHalfway(const Job& job, const Vec3& p, const ClosestPoint& c, double reach) {
  if (!(c.distance > 0)) return false;
  // Not as far as S: behind it everything is outside.
  const Vec3 step = std::min(reach / c.distance, 0.5) * (p - c.point);
  const bool isInside = insideThickened(p, c, job.thickness.at(c));
  const auto differs = [&](const Vec3& q) {
    const ClosestPoint near = *job.tree.closest(q);
    return insideThickened(q, near, job.thickness.at(near)) != isInside;
  };
  return differs(p + step) || differs(p - step);
}

// The error of each vertex of the shell, mm; 0 for S's own.
template <class ErrorOf>
std::vector<double> errorsAtVertices(const Job& job, const SweepResult& swept, ErrorOf errorOf) {
  std::vector<double> error(swept.mesh.positions.size(), 0);
  SpatialOrder(swept.nearest, job.tree, job.threads)
      .query(
          job.tree, 1, job.threads, job.context,
          [&](std::uint32_t v, std::size_t, ClosestPointTree::Query& query) {
            query.point = swept.mesh.positions[v];
            query.hint = swept.nearest[v];
            return swept.distance[v] > 0;
          },
          [&](std::uint32_t v, std::size_t, const Vec3& at, const ClosestPoint& c) {
            error[v] = errorOf(at, c);
          });
  return error;
}

// How far each triangle of the sweep's shell is off, mm (of a share of the thickness: as much as the same
// share of the least thickness is): the most at its middle and in the middles of its corner pieces; 0 for
// others. An error that one corner has alone counts as far as it reaches.
std::vector<double> shellErrors(const Job& job, const SweepResult& swept) {
  const TriangleMesh& surface = job.surface;
  const int threads = job.threads;
  const auto normal = mesh::faceNormals(surface.positions, surface.triangles, threads);
  const auto around = mesh::vertexTriangles(surface.positions.size(), surface.triangles, threads);
  const measure::OffsetError error(job, normal, around, measure::joinOf(job.options));
  const std::vector<Vec3>& p = swept.mesh.positions;
  const double enough = errorToLeave(job);
  // What is nearest to the rim is wall, which may lean (Remark 4).
  const auto errorOf = [&](const Vec3& at, const ClosestPoint& c) {
    const double scale = job.options.tolerance ? 1 : job.thickness.least() / job.thickness.at(c);
    const double off = c.onRim ? 0 : scale * error.at(at, c).mm;
    return off < -enough && endsHalfway(job, at, c, enough / scale) ? 0 : std::abs(off);
  };
  const std::vector<double> atVertex = errorsAtVertices(job, swept, errorOf);
  // Within a triangle with the longest edge e the square of the distance to S is not less than the mean of
  // its corners' by more than e²/3, so that its middle need not be looked at where that is a quarter of what
  // is left.
  const double small = 1.5 * enough * job.thickness.least();  // mm²
  std::vector<double> most(swept.mesh.triangles.size(), 0);
  std::vector<TriangleId> large, near;
  for (TriangleId t = 0; t < most.size(); ++t) {
    if (swept.region[t] != Region::kShell) continue;
    const auto& [a, b, c] = swept.mesh.triangles[t];
    const double mean = (atVertex[a] + atVertex[b] + atVertex[c]) / 3;
    most[t] = std::max(mean, std::max({atVertex[a], atVertex[b], atVertex[c]}) / 2);
    const double longest = longestEdge(swept.mesh, t);
    if (longest * longest <= small) continue;
    large.push_back(t);
    near.push_back(swept.nearest[a]);
  }
  const auto sample = [&](TriangleId t, std::size_t k) {
    const auto& [a, b, c] = swept.mesh.triangles[t];
    const auto& w = measure::kShellSamples[k];
    return Vec3(w[0] * p[a] + w[1] * p[b] + w[2] * p[c]);
  };
  SpatialOrder(near, job.tree, threads)
      .query(
          job.tree, 1, threads, job.context,
          [&](std::uint32_t i, std::size_t, ClosestPointTree::Query& query) {
            query.point = sample(large[i], 0);
            query.hint = near[i];
            return true;
          },
          [&](std::uint32_t i, std::size_t, const Vec3& at, const ClosestPoint& c) {
            const Triangle& t = swept.mesh.triangles[large[i]];
            const double corner = std::max({atVertex[t[0]], atVertex[t[1]], atVertex[t[2]]});
            double& own = most[large[i]] = std::max(errorOf(at, c), corner / 2);
            for (std::size_t k = 1; k < measure::kMostShellSamples && 2 * own > enough && own <= enough;
                 ++k) {
              const Vec3 more = sample(large[i], k);
              own = std::max(own, errorOf(more, *job.tree.closest(more)));
            }
          });
  return most;
}

// Cells along an edge of a triangle beside a contour: its rim is divided by cells, and a fan of so many
// slivers costs exact tests by their square.
constexpr double kMostAlongEdge = 400;

// All that is off by more than `error` mm, to be contoured.
ShellPlan planFor(const Job& job, const SweepResult& swept, std::span<const double> errors, double error) {
  ShellPlan plan;
  const double longest = kMostAlongEdge * job.thickness.least() / 2.2;
  for (TriangleId t = 0; t < errors.size(); ++t)
    plan.keep.push_back(errors[t] <= error || longestEdge(swept.mesh, t) > longest);
  plan.area = openArea(swept, plan.keep);
  if (plan.keepsAll()) return plan;
  plan.width = cellWidth(job, plan.area, kManyBesideSweep);
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

// Cells that the contour passes, and those that the rim beside it is divided by: scattered large triangles
// have much of that.
double cellsOf(const TriangleMesh& mesh, const ShellPlan& plan) {
  if (plan.keepsAll()) return 0;
  const mesh::HalfEdges edges(mesh.positions.size(), mesh.triangles, plan.keep);
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

double mostShort(const Job& job) {
  const Options& options = job.options;
  const double area = areaOf(job.surface);
  if (options.tolerance || options.cell || options.resolution) return 1;
  const double width = cellWidth(job, area);
  const std::size_t crossings = mostCrossings(area, width);
  // A crossing is a quad, and there are 1.5 of them for each square of a cell, in the mean of all directions.
  const bool isLeaner = 3 * area / (width * width) < static_cast<double>(job.surface.triangles.size());
  return isLeaner && hasRoomForField(job, crossings) ? 0.5 : 1;
}

ShellPlan planShell(const Job& job, const SweepResult& swept) {
  const std::vector<double> errors = shellErrors(job, swept);
  ShellPlan plan = planFor(job, swept, errors, errorToLeave(job));
  if (plan.keepsAll()) return plan;
  // Wider cells are no better than a sweep that is off by as much.
  const double error = contourError(plan.width, job.thickness.least());
  if (error > errorToLeave(job)) plan = planFor(job, swept, errors, error);
  // A thickness far below the extent of the surface would take any number of cells. The widest ones go
  // farthest.
  const double width = plan.width;
  for (double area = std::min(plan.area, kManyBesideSweep * width * width);
       cellsOf(swept.mesh, plan) > kManyBesideSweep; area /= 2) {
    plan = planFor(job, swept, errors, affordableError(swept.mesh, errors, area));
    plan.width = width;
  }
  return plan;
}

}  // namespace thicken::reconstruct
