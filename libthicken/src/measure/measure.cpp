// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bvh/spatial_order.h"
#include "measure/shell_samples.h"
#include "mesh/parallel_sort.h"
#include "mesh/topology.h"
#include "parallel_for.h"

namespace thicken {

namespace {

struct Sample {
  double error = -1;  // relative; negative: on the wall
  double weight = 0;  // mm²
};

ErrorFacts summary(std::vector<Sample> samples, int threads) {
  std::erase_if(samples, [](const Sample& s) { return s.error < 0; });
  parallelSort(
      samples,
      [](const Sample& a, const Sample& b) {
        return a.error != b.error ? a.error < b.error : a.weight < b.weight;
      },
      threads);
  ErrorFacts facts;
  double total = 0;
  for (const Sample& s : samples) {
    total += s.weight;
    facts.mean += s.weight * s.error;
  }
  if (samples.empty() || total <= 0) return facts;
  facts.mean /= total;
  facts.max = samples.back().error;
  double sum = 0;
  for (const Sample& s : samples) {
    sum += s.weight;
    facts.p99 = s.error;
    if (sum >= 0.99 * total) break;
  }
  return facts;
}

ShellDistances shellDistances(const Solid& solid, const ClosestPointTree& tree, ShellDistances known,
                              const RunContext& context, int threads) {
  std::vector<std::uint8_t> onShell(solid.mesh.positions.size(), 0);
  for (std::size_t t = 0; t < solid.region.size(); ++t)
    if (solid.region[t] == Region::kShell)
      for (const VertexId v : solid.mesh.triangles[t]) onShell[v] = 1;
  const bool isKnown = !known.distance.empty();
  known.distance.resize(onShell.size());
  known.nearest.resize(onShell.size());
  parallelFor(onShell.size(), threads, context, 512, [&](std::size_t v) {
    if (!onShell[v]) {
      known.distance[v] = std::numeric_limits<double>::infinity();
    } else if (!isKnown) {
      const auto c = tree.closest(solid.mesh.positions[v]);
      known.distance[v] = c->distance;
      known.nearest[v] = c->triangle;
    }
  });
  return known;
}

// The error over the whole shell, and over the triangles whose corners are all as deep as asked.
void measureShell(Solid& solid, const ClosestPointTree& tree, const ShellDistances& known, Measure what,
                  const RunContext& context, int threads) {
  constexpr double kFull = 0.99;
  constexpr std::size_t kEnough = 25000;  // triangles that represent a shell of more
  const double r = solid.report.thickness;
  std::vector<TriangleId> shell;
  for (TriangleId t = 0; t < solid.region.size(); ++t)
    if (solid.region[t] == Region::kShell) shell.push_back(t);
  const std::size_t each = shellSamplesPerTriangle(shell.size());
  if (const std::size_t step = (shell.size() + kEnough - 1) / kEnough;
      what == Measure::kRepresentative && step > 1) {
    for (std::size_t i = 0; step * i < shell.size(); ++i) shell[i] = shell[step * i];
    shell.resize((shell.size() + step - 1) / step);
  }
  std::vector<Sample> samples(each * shell.size());
  std::vector<TriangleId> near(shell.size());
  parallelFor(shell.size(), threads, context, 4096, [&](std::size_t i) {
    const Triangle& t = solid.mesh.triangles[shell[i]];
    near[i] = known.nearest[t[0]];
    const double area = areaOf(solid.mesh.positions, t);
    for (std::size_t k = 0; k < each; ++k) samples[each * i + k].weight = area / double(each);
  });
  SpatialOrder(near, tree, threads)
      .query<kMostShellSamples>(
          tree, each, threads, context,
          [&](std::uint32_t i, std::size_t k, ClosestPointTree::Query& query) {
            const Triangle& t = solid.mesh.triangles[shell[i]];
            const auto& w = kShellSamples[k];
            query.point = w[0] * solid.mesh.positions[t[0]] + w[1] * solid.mesh.positions[t[1]] +
                          w[2] * solid.mesh.positions[t[2]];
            query.hint = near[i];
            return true;
          },
          [&](std::uint32_t i, std::size_t k, const Vec3&, const ClosestPoint& c) {
            samples[each * i + k].error = c.onRim ? -1 : std::abs(c.distance / r - 1);
          });
  std::vector<Sample> full;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const Triangle& t = solid.mesh.triangles[shell[i]];
    if (std::all_of(t.begin(), t.end(), [&](VertexId v) { return known.distance[v] >= kFull * r; }))
      full.insert(full.end(), &samples[each * i], &samples[each * i] + each);
  }
  solid.report.shellError = summary(std::move(samples), threads);
  solid.report.shellErrorFullDepth = summary(std::move(full), threads);
}

// The thinnest wall is the least distance of a shell vertex from S.
void findThinnest(Solid& solid, std::span<const double> distance) {
  const auto least = std::min_element(distance.begin(), distance.end());
  if (least == distance.end() || !std::isfinite(*least)) return;
  solid.report.thinnestWall = *least;
  solid.report.thinnestPlace = solid.mesh.positions[static_cast<std::size_t>(least - distance.begin())];
}

// Share of S's area where the solid is less than 0.9 r deep.
double thinShare(const Solid& solid, const TriangleMesh& surface) {
  constexpr double kThin = 0.9;
  double thin = 0, total = 0;
  for (const Triangle& t : surface.triangles) {
    const double area = areaOf(surface.positions, t);
    const double depth = (solid.depth[t[0]] + solid.depth[t[1]] + solid.depth[t[2]]) / 3;
    total += area;
    if (depth < kThin * solid.report.thickness) thin += area;
  }
  return total > 0 ? thin / total : 0;
}

}  // namespace

double volumeOf(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vec3 origin = mesh.positions[mesh.triangles[0][0]];
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume +=
        (mesh.positions[a] - origin).cross(mesh.positions[b] - origin).dot(mesh.positions[c] - origin) / 6;
  return volume;
}

double areaOf(std::span<const Vec3> positions, const Triangle& t) {
  return (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]).norm() / 2;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += areaOf(mesh.positions, t);
  return area;
}

void measure(Solid& solid, const TriangleMesh& surface, const ClosestPointTree& tree, ShellDistances known,
             Measure what, const RunContext& context, int threads) {
  Report& report = solid.report;
  report.triangles = solid.mesh.triangles.size();
  report.vertices = solid.mesh.positions.size();
  for (const Region region : solid.region)
    ++(region == Region::kOriginal ? report.originalTriangles
       : region == Region::kShell  ? report.shellTriangles
                                   : report.wallTriangles);
  report.components = componentsOf(solid.mesh.positions.size(), solid.mesh.triangles, threads).count;
  // Sums in the order of the triangles, so that they do not depend on the threads.
  parallelFor(2, threads, context, 1, [&](std::size_t i) {
    if (i == 0)
      report.volume = volumeOf(solid.mesh);
    else
      report.area = areaOf(solid.mesh);
  });
  known = shellDistances(solid, tree, std::move(known), context, threads);
  measureShell(solid, tree, known, what, context, threads);
  findThinnest(solid, known.distance);
  report.thinShare = thinShare(solid, surface);
}

}  // namespace thicken
