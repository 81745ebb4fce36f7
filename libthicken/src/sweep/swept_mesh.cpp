// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/swept_mesh.h"

#include <numeric>

#include "mesh/float_lattice.h"
#include "parallel/parallel_for.h"

namespace thicken::sweep {

using job::Job;
using mesh::kNone;
using mesh::RimEdge;
using parallel::parallelFor;

namespace {

// Adds one copy of every vertex, `sign`·r·m away, and the copied triangles. Behind S they are
// reversed, so that they face away from the solid.
VertexId addShell(SweptMesh& mesh, const Job& job, std::span<const SweepDirection> direction, double sign) {
  const TriangleMesh& surface = job.surface;
  constexpr std::size_t kGrain = 8192;
  const std::size_t firstCopy = mesh.copies.size(), firstTriangle = mesh.triangles.size();
  const auto first = static_cast<VertexId>(mesh.surfaceVertices + firstCopy);
  mesh.copies.resize(firstCopy + surface.positions.size());
  mesh.positions.insert(mesh.positions.end(), surface.positions.begin(), surface.positions.end());
  parallelFor(surface.positions.size(), job.threads, RunContext(), kGrain, [&](std::size_t v) {
    Copy& c = mesh.copies[firstCopy + v];
    c.base = static_cast<VertexId>(v);
    c.offset = sign * job.thickness.at(c.base) * direction[v].m;
    c.length = c.offset.norm();
    c.safety = direction[v].safety;
  });
  mesh.triangles.resize(firstTriangle + surface.triangles.size());
  parallelFor(surface.triangles.size(), job.threads, RunContext(), kGrain, [&](std::size_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    mesh.triangles[firstTriangle + t] =
        sign < 0 ? Triangle{first + c, first + b, first + a} : Triangle{first + a, first + b, first + c};
  });
  mesh.region.insert(mesh.region.end(), surface.triangles.size(), Region::kShell);
  const std::size_t own = mesh.above.size();
  mesh.above.resize(own + surface.triangles.size());
  std::iota(mesh.above.begin() + static_cast<std::ptrdiff_t>(own), mesh.above.end(), TriangleId{0});
  return first;
}

// Two triangles below a rim edge, between the vertices `upper + v` and `lower + v`; seen from
// outside the upper edge runs against the rim.
void addWall(SweptMesh& mesh, const RimEdge& e, VertexId upper, VertexId lower) {
  const VertexId a = upper + e.from, b = upper + e.to, aLow = lower + e.from, bLow = lower + e.to;
  // The diagonal starts at the end of lower id, so that it does not depend on the rim's direction.
  if (e.from < e.to) {
    mesh.triangles.push_back({b, a, bLow});
    mesh.triangles.push_back({a, aLow, bLow});
  } else {
    mesh.triangles.push_back({b, a, aLow});
    mesh.triangles.push_back({b, aLow, bLow});
  }
  mesh.region.insert(mesh.region.end(), 2, Region::kWall);
  mesh.above.insert(mesh.above.end(), 2, kNone);
}

}  // namespace

void SweptMesh::place(std::size_t copy) {
  const Copy& c = copies[copy];
  positions[vertexOf(copy)] = mesh::roundToFloat(positions[c.base] + c.depth * c.offset);
}

void SweptMesh::remove(std::span<const std::uint8_t> removed) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < removed.size(); ++t) {
    if (removed[t]) continue;
    triangles[kept] = triangles[t];
    above[kept] = above[t];
    fixed[kept] = fixed[t];
    region[kept++] = region[t];
  }
  triangles.resize(kept);
  above.resize(kept);
  fixed.resize(kept);
  region.resize(kept);
}

SweptMesh sweepMesh(const Job& job, std::span<const std::vector<SweepDirection>> direction,
                    const mesh::Rim& rim) {
  const TriangleMesh& surface = job.surface;
  SweptMesh mesh;
  mesh.thickness = job.thickness;
  mesh.surfaceVertices = surface.positions.size();
  mesh.surfaceTriangles = surface.triangles.size();
  mesh.above.assign(surface.triangles.size(), kNone);
  mesh.shells = direction.size();
  const std::size_t shells = mesh.shells, walls = 2 * shells * rim.edges.size();
  mesh.copies.reserve(shells * surface.positions.size());
  mesh.positions.reserve((1 + shells) * surface.positions.size());
  mesh.triangles.reserve((1 + shells) * surface.triangles.size() + walls);
  mesh.region.reserve((1 + shells) * surface.triangles.size() + walls);
  mesh.positions = surface.positions;  // with room for all of it
  mesh.triangles = surface.triangles;
  mesh.region.assign(surface.triangles.size(), Region::kOriginal);
  const VertexId behind = addShell(mesh, job, direction[0], -1);
  for (const RimEdge& e : rim.edges) addWall(mesh, e, 0, behind);
  if (mesh.shells == 2) {
    const VertexId before = addShell(mesh, job, direction[1], 1);
    for (const RimEdge& e : rim.edges) addWall(mesh, e, before, 0);
  }
  mesh.fixed.assign(mesh.triangles.size(), 0);
  std::fill_n(mesh.fixed.begin(), mesh.surfaceTriangles, std::uint8_t{1});
  return mesh;
}

}  // namespace thicken::sweep
