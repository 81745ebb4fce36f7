// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "bvh/ray_tree.h"
#include "bvh/spatial_order.h"
#include "measure/offset_error.h"
#include "measure/shell_samples.h"
#include "mesh/normals.h"
#include "mesh/parallel_sort.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"

namespace thicken::measure {

using bvh::RayTree;
using job::Job;
using mesh::faceNormals;
using parallel::parallelFor;

namespace {

constexpr std::size_t kEnough = 25000;  // triangles that represent more

struct Sample {
  double error = -1;  // relative; negative: on the wall
  double weight = 0;  // mm²
};

ErrorFacts summary(std::vector<Sample> samples, int threads) {
  std::erase_if(samples, [](const Sample& s) { return s.error < 0; });
  mesh::parallelSort(
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

ShellDistances shellDistances(const Solid& solid, const Job& job, ShellDistances known) {
  std::vector<std::uint8_t> onShell(solid.mesh.positions.size(), 0);
  for (std::size_t t = 0; t < solid.region.size(); ++t)
    if (solid.region[t] == Region::kShell)
      for (const VertexId v : solid.mesh.triangles[t]) onShell[v] = 1;
  const bool isKnown = !known.distance.empty();
  known.distance.resize(onShell.size());
  known.nearest.resize(onShell.size());
  parallelFor(onShell.size(), job.threads, job.context, 512, [&](std::size_t v) {
    if (!onShell[v]) {
      known.distance[v] = std::numeric_limits<double>::infinity();
    } else if (!isKnown) {
      const auto c = job.tree.closest(solid.mesh.positions[v]);
      known.distance[v] = c->distance;
      known.nearest[v] = c->triangle;
    }
  });
  return known;
}

// The error over the whole shell, and over the triangles whose corners are all as deep as asked.
void measureShell(Solid& solid, const Job& job, const ShellDistances& known, Measure what) {
  constexpr double kFull = 0.99;
  const TriangleMesh& surface = job.surface;
  const int threads = job.threads;
  const auto normal = faceNormals(surface.positions, surface.triangles, threads);
  const auto around = mesh::vertexTriangles(surface.positions.size(), surface.triangles, threads);
  const OffsetError error(job, normal, around, solid.report.join);
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
  parallelFor(shell.size(), threads, job.context, 4096, [&](std::size_t i) {
    const Triangle& t = solid.mesh.triangles[shell[i]];
    near[i] = known.nearest[t[0]];
    const double area = areaOf(solid.mesh.positions, t);
    for (std::size_t k = 0; k < each; ++k) samples[each * i + k].weight = area / double(each);
  });
  bvh::SpatialOrder(near, job.tree, threads)
      .query<kMostShellSamples>(
          job.tree, each, threads, job.context,
          [&](std::uint32_t i, std::size_t k, ClosestPointTree::Query& query) {
            const Triangle& t = solid.mesh.triangles[shell[i]];
            const auto& w = kShellSamples[k];
            query.point = w[0] * solid.mesh.positions[t[0]] + w[1] * solid.mesh.positions[t[1]] +
                          w[2] * solid.mesh.positions[t[2]];
            query.hint = near[i];
            return true;
          },
          [&](std::uint32_t i, std::size_t k, const Vec3& p, const ClosestPoint& c) {
            samples[each * i + k].error = c.onRim ? -1 : std::abs(error.at(p, c).mm) / job.thickness.at(c);
          });
  std::vector<Sample> full;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const Triangle& t = solid.mesh.triangles[shell[i]];
    if (std::all_of(t.begin(), t.end(), [&](VertexId v) {
          const double r = job.thickness.at(known.nearest[v], solid.mesh.positions[v]);
          return known.distance[v] >= kFull * r;
        }))
      full.insert(full.end(), &samples[each * i], &samples[each * i] + each);
  }
  solid.report.shellError = summary(std::move(samples), threads);
  solid.report.shellErrorFullDepth = summary(std::move(full), threads);
}

// What is asked for at a point.
double thicknessAt(const Job& job, const Vec3& p) {
  return job.thickness.isConstant() ? job.thickness.most() : job.thickness.at(*job.tree.closest(p));
}

// The shortest way straight through the material, from the middle of a triangle of S (on both sides, where S
// is inside: of the shell) to one that faces the other way. Near any edge there are short ways across the
// corner: they count where the edge is sharper than 60 degrees.
void findThinnestThrough(Solid& solid, const Job& job, Measure what) {
  constexpr double kFacing = -0.5;
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const auto& [positions, triangles] = solid.mesh;
  const std::vector<Vec3> normal = faceNormals(positions, triangles, job.threads);
  const RayTree tree(positions, triangles);
  const auto middleOf = [&positions = positions](const Triangle& t) {
    return Vec3((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3);
  };
  const Region outside = solid.report.side == Side::kBoth ? Region::kShell : Region::kOriginal;
  std::vector<TriangleId> from;
  for (TriangleId t = 0; t < triangles.size(); ++t)
    if (solid.region[t] == outside) from.push_back(t);
  const std::size_t step = what == Measure::kRepresentative ? (from.size() + kEnough - 1) / kEnough : 1;
  std::vector<double> through(triangles.size(), kInfinite);
  parallelFor((from.size() + step - 1) / std::max<std::size_t>(step, 1), job.threads, job.context, 256,
              [&, &triangles = triangles](std::size_t i) {
                const TriangleId t = from[step * i];
                const RayTree::Hit hit = tree.first(middleOf(triangles[t]), -normal[t], triangles[t]);
                if (hit.along < kInfinite && normal[t].dot(normal[hit.triangle]) < kFacing)
                  through[t] = hit.along;
              });
  std::vector<double> share = through;
  for (TriangleId t = 0; t < share.size(); ++t)
    if (share[t] < kInfinite) share[t] /= thicknessAt(job, middleOf(triangles[t]));
  const auto least = std::min_element(share.begin(), share.end());
  if (least == share.end() || !(*least < kInfinite)) return;
  const auto t = static_cast<std::size_t>(least - share.begin());
  solid.report.thinnestThrough = through[t];
  solid.report.thinnestThroughShare = *least;
  solid.report.thinnestThroughPlace = middleOf(triangles[t]);
}

// The thinnest wall is where the distance of a shell vertex from S is the least share of the thickness there.
// Where most of the shell is gone, because the solid ends in walls before, the least way straight through it
// counts, too.
void findThinnest(Solid& solid, const Job& job, const ShellDistances& known) {
  Report& report = solid.report;
  double shellArea = 0;
  for (std::size_t t = 0; t < solid.region.size(); ++t)
    if (solid.region[t] == Region::kShell) shellArea += areaOf(solid.mesh.positions, solid.mesh.triangles[t]);
  std::vector<double> share = known.distance;
  for (VertexId v = 0; v < share.size(); ++v)
    if (std::isfinite(share[v])) share[v] /= job.thickness.at(known.nearest[v], solid.mesh.positions[v]);
  const auto least = std::min_element(share.begin(), share.end());
  const bool hasShell = least != share.end() && std::isfinite(*least);
  if (hasShell) {
    const auto v = static_cast<std::size_t>(least - share.begin());
    report.thinnestWall = known.distance[v];
    report.thinnestShare = *least;
    report.thinnestPlace = solid.mesh.positions[v];
  }
  if (!(report.thinnestThrough > 0) || shellArea > areaOf(job.surface) / 2) return;
  if (hasShell && report.thinnestThroughShare >= *least) return;
  report.thinnestWall = report.thinnestThrough;
  report.thinnestShare = report.thinnestThroughShare;
  report.thinnestPlace = report.thinnestThroughPlace;
}

// How deep the solid is below the vertices of S, but never deeper than the solid is large: a stage may have
// told what it aimed at.
std::vector<double> depthsWithin(const Solid& solid) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : solid.mesh.positions) box.extend(p);
  const double most = box.isEmpty() ? 0 : box.diagonal().norm();
  std::vector<double> depth = solid.depth;
  for (double& d : depth) d = std::min(d, most);
  return depth;
}

// The share of a triangle's area where a value that is linear between its corners is below `limit`.
double shareBelow(std::array<double, 3> value, double limit) {
  std::sort(value.begin(), value.end());
  const auto [low, middle, high] = value;
  if (high < limit) return 1;
  if (low >= limit) return 0;
  // The corner that is alone on its side of the limit is cut off, along both edges that end there.
  if (middle >= limit) return (limit - low) / (middle - low) * ((limit - low) / (high - low));
  return 1 - (high - limit) / (high - low) * ((high - limit) / (high - middle));
}

// Share of S's area where the solid is less than 0.9 r deep.
double thinShare(const Job& job, std::vector<double> depth) {
  constexpr double kThin = 0.9;
  const TriangleMesh& surface = job.surface;
  const double r = job.thickness.most();
  for (VertexId v = 0; v < depth.size(); ++v) depth[v] *= r / job.thickness.at(v);
  double thin = 0, total = 0;
  for (const Triangle& t : surface.triangles) {
    const double area = areaOf(surface.positions, t);
    total += area;
    thin += area * shareBelow({depth[t[0]], depth[t[1]], depth[t[2]]}, kThin * r);
  }
  return total > 0 ? thin / total : 0;
}

// Bodies, and those of them that are too small to be meant. A shell around a cavity has a negative volume.
void countParts(Solid& solid, const mesh::Components& shells, double r) {
  constexpr double kSmall = 1e-3;  // of the largest
  const TriangleMesh& mesh = solid.mesh;
  std::vector<double> volume(shells.count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3& origin = mesh.positions[mesh.triangles[0][0]];
    volume[shells.ofTriangle[t]] +=
        (mesh.positions[a] - origin).cross(mesh.positions[b] - origin).dot(mesh.positions[c] - origin) / 6;
  }
  Report& report = solid.report;
  report.components = shells.count;
  if (volume.empty()) return;
  const double largest = *std::max_element(volume.begin(), volume.end());
  report.crumbVolume = std::min(std::pow(r, 3), kSmall * largest);
  for (const double v : volume) {
    report.parts += v > 0;
    report.crumbs += v > 0 && v < report.crumbVolume;
  }
}

// The vertices of a solid, to be found by their coordinates.
class VertexSearch {
 public:
  explicit VertexSearch(std::vector<Vec3> positions) : sorted_(std::move(positions)) {
    std::sort(sorted_.begin(), sorted_.end(), [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
  }
  // The distance to the nearest one: outwards from where x is the same, until x alone is farther.
  [[nodiscard]] double distance(const Vec3& p) const {
    const auto middle = std::lower_bound(sorted_.begin(), sorted_.end(), p.x(),
                                         [](const Vec3& a, double x) { return a.x() < x; });
    double least = std::numeric_limits<double>::infinity();
    for (auto at = middle; at != sorted_.end() && at->x() - p.x() < least; ++at)
      least = std::min(least, (*at - p).norm());
    for (auto at = middle; at != sorted_.begin() && p.x() - (at - 1)->x() < least; --at)
      least = std::min(least, (*(at - 1) - p).norm());
    return least;
  }

 private:
  std::vector<Vec3> sorted_;
};

// The farthest that a vertex of S, or for Side::kBoth of its rim, is from the nearest vertex of the solid.
double surfaceDeviation(const Solid& solid, const TriangleMesh& surface) {
  std::vector<VertexId> moved;  // not found under their own number
  const auto look = [&](VertexId v) {
    if (v >= solid.mesh.positions.size() || solid.mesh.positions[v] != surface.positions[v])
      moved.push_back(v);
  };
  if (solid.report.side == Side::kBoth) {
    for (const mesh::RimEdge& e : mesh::rimOf(surface.positions.size(), surface.triangles).edges)
      look(e.from);
  } else {
    for (VertexId v = 0; v < surface.positions.size(); ++v) look(v);
  }
  if (moved.empty()) return 0;
  const VertexSearch search(solid.mesh.positions);
  double most = 0;
  for (const VertexId v : moved) most = std::max(most, search.distance(surface.positions[v]));
  return most;
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

void measure(Solid& solid, const Job& job, ShellDistances known, Measure what) {
  Report& report = solid.report;
  report.triangles = solid.mesh.triangles.size();
  report.vertices = solid.mesh.positions.size();
  for (const Region region : solid.region)
    ++(region == Region::kOriginal ? report.originalTriangles
       : region == Region::kShell  ? report.shellTriangles
                                   : report.wallTriangles);
  countParts(solid, mesh::componentsOf(solid.mesh.positions.size(), solid.mesh.triangles, job.threads),
             job.thickness.least());
  // Sums in the order of the triangles, so that they do not depend on the threads.
  parallelFor(2, job.threads, job.context, 1, [&](std::size_t i) {
    if (i == 0)
      report.volume = volumeOf(solid.mesh);
    else
      report.area = areaOf(solid.mesh);
  });
  known = shellDistances(solid, job, std::move(known));
  measureShell(solid, job, known, what);
  findThinnestThrough(solid, job, what);
  findThinnest(solid, job, known);
  report.thinShare = thinShare(job, depthsWithin(solid));
  report.surfaceDeviation = surfaceDeviation(solid, job.surface);
}

}  // namespace thicken::measure
