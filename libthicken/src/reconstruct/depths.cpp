// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/depths.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/normals.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"

namespace thicken::reconstruct {

using job::Job;
using mesh::kNone;
using sweep::SweepResult;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

// How deep the solid is below each vertex: along the normal to where the field ends. There the closest point
// may be on the rim. If the rim is about as far as the way is long, the wall ends there. A rim that is nearer
// is that of another part, beyond the end of the field. `known`: the depth of vertices that need not be
// looked at; else infinite. Empty: none is known.
std::vector<double> fieldDepths(const Job& job, std::vector<double> known = {}) {
  const TriangleMesh& surface = job.surface;
  const auto normal =
      mesh::vertexNormals(surface.positions, surface.triangles,
                          mesh::faceNormals(surface.positions, surface.triangles, job.threads), job.threads);
  std::vector<double> depth = std::move(known);
  depth.resize(surface.positions.size(), kUnknown);
  constexpr int kSteps = 5;
  constexpr double kOwnRim = 0.9;
  parallel::parallelFor(depth.size(), job.threads, job.context, 128, [&](std::size_t v) {
    if (depth[v] != kUnknown) return;
    const double r = job.thickness.at(static_cast<VertexId>(v));
    double good = 0, bad = r;
    for (int i = 0; i < kSteps; ++i) {
      const double h = i == 0 ? 0.95 * r : (good + bad) / 2;
      const Vec3 p = surface.positions[v] - h * normal[v];
      const auto c = job.tree.closest(p);
      const bool inside =
          c->onRim ? c->distance >= kOwnRim * h : insideThickened(p, *c, job.thickness.at(*c));
      (inside ? good : bad) = h;
      if (i == 0 && inside) break;
    }
    depth[v] = good >= 0.95 * r ? r : good;
  });
  return depth;
}

}  // namespace

std::vector<double> depthsOf(const Job& job, const SweepResult& swept, std::span<const std::uint8_t> keep) {
  std::vector<double> depth = fieldDepths(job);
  for (std::size_t t = job.surface.triangles.size(); t < keep.size(); ++t) {
    if (!keep[t] || swept.region[t] != Region::kShell) continue;
    for (const VertexId v : swept.mesh.triangles[t]) {
      if (swept.base[v] == kNone) continue;
      double& at = depth[swept.base[v]];
      at = std::min(at, swept.distance[v]);
    }
  }
  return depth;
}

std::vector<double> depthsOf(const Job& job, const Reconstruction& made) {
  std::vector<double> depth = fieldDepths(job);
  for (TriangleId t = 0; t < made.left.size(); ++t) {
    if (!made.left[t]) continue;
    for (const VertexId v : made.mesh.triangles[t]) {
      if (made.base[v] == kNone) continue;
      double& at = depth[made.base[v]];
      at = std::min(at, job.tree.distance(made.mesh.positions[v]));
    }
  }
  return depth;
}

std::vector<double> depthsOf(const Job& job, const Reconstruction& made, const SweepResult& swept) {
  std::vector<std::uint8_t> isThere(swept.mesh.positions.size(), 0);
  for (const VertexId v : made.origin)
    if (v != kNone) isThere[v] = 1;
  std::vector<double> depth(job.surface.positions.size(), kUnknown);
  std::vector<std::uint8_t> isGone(depth.size(), 0);
  for (auto v = static_cast<VertexId>(depth.size()); v < isThere.size(); ++v) {
    if (swept.base[v] == kNone) continue;
    if (isThere[v])
      depth[swept.base[v]] = std::min(depth[swept.base[v]], swept.distance[v]);
    else
      isGone[swept.base[v]] = 1;
  }
  for (std::size_t v = 0; v < depth.size(); ++v)
    if (isGone[v]) depth[v] = kUnknown;
  return fieldDepths(job, std::move(depth));
}

}  // namespace thicken::reconstruct
