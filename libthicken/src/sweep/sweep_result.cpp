// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/sweep_result.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "bvh/distance_tree.h"
#include "bvh/spatial_order.h"
#include "measure/measure.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"
#include "sweep/nearby.h"

namespace thicken::sweep {

using bvh::DistanceTree;
using job::Job;
using parallel::parallelFor;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// What is nearest to every copy, and how far it is: infinitely far for copies that were dropped.
struct Nearest {
  std::vector<double> distance;
  std::vector<TriangleId> triangle;
};

Nearest nearestToCopies(const SweptMesh& mesh, const Job& job) {
  Nearest nearest{std::vector<double>(mesh.copies.size(), kInfinite), trianglesAtCopies(mesh)};
  bvh::SpatialOrder(nearest.triangle, job.tree, job.threads)
      .query(
          job.tree, 1, job.threads, job.context,
          [&](std::uint32_t i, std::size_t, ClosestPointTree::Query& query) {
            query.point = mesh.positions[mesh.vertexOf(i)];
            query.hint = nearest.triangle[i];
            return !mesh.copies[i].dropped;
          },
          [&](std::uint32_t i, std::size_t, const Vec3&, const ClosestPoint& c) {
            nearest.distance[i] = c.distance;
            nearest.triangle[i] = c.triangle;
          });
  return nearest;
}

// Depth below each vertex of S: the distance of its copy from S, of two copies the lesser; without a
// copy the distance to the shell.
std::vector<double> depthsOf(const SweptMesh& mesh, std::span<const double> distance) {
  std::vector<double> depth(mesh.surfaceVertices, kInfinite);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    double& d = depth[mesh.copies[i].base];
    d = std::min(d, distance[i]);
  }
  if (std::none_of(mesh.copies.begin(), mesh.copies.end(), [](const Copy& c) { return c.dropped; }))
    return depth;
  const DistanceTree shell(mesh.positions, std::span(mesh.triangles).subspan(mesh.surfaceTriangles));
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (depth[v] == kInfinite) {
      DistanceTree::Hit hit{{Vec3::Zero(), kInfinite, Feature::kFace, 0}, mesh::kNone};
      shell.nearest(mesh.positions[v], hit);
      depth[v] = std::sqrt(hit.closest.squaredDistance);
    }
  return depth;
}

}  // namespace

SweepResult resultOf(const SweptMesh& mesh, const Job& job) {
  constexpr std::size_t kGrain = 8192;
  SweepResult result;
  const Nearest nearest = nearestToCopies(mesh, job);
  result.depth = depthsOf(mesh, nearest.distance);
  std::vector<VertexId> to(mesh.positions.size()), from;
  from.reserve(to.size());
  for (VertexId v = 0; v < mesh.positions.size(); ++v) {
    to[v] = static_cast<VertexId>(from.size());
    if (!mesh.isCopy(v) || !mesh.copyOf(v).dropped) from.push_back(v);
  }
  result.droppedCopies = to.size() - from.size();
  result.mesh.positions.resize(from.size());
  result.base.resize(from.size());
  result.distance.resize(from.size());
  result.nearest.resize(from.size());
  parallelFor(from.size(), job.threads, job.context, kGrain, [&](std::size_t i) {
    const VertexId v = from[i];
    result.mesh.positions[i] = mesh.positions[v];
    result.base[i] = mesh.isCopy(v) ? mesh.copyOf(v).base : v;
    if (!mesh.isCopy(v)) return;
    result.distance[i] = nearest.distance[v - mesh.surfaceVertices];
    result.nearest[i] = nearest.triangle[v - mesh.surfaceVertices];
  });
  const std::size_t first =
      job.options.side == Side::kBoth ? mesh.surfaceTriangles : 0;  // S lies inside then
  result.mesh.triangles.resize(mesh.triangles.size() - first);
  result.region.assign(mesh.region.begin() + static_cast<std::ptrdiff_t>(first), mesh.region.end());
  parallelFor(result.mesh.triangles.size(), job.threads, job.context, kGrain, [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[first + i];
    result.mesh.triangles[i] = {to[a], to[b], to[c]};
  });
  return result;
}

}  // namespace thicken::sweep
