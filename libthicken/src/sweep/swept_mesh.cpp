// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/swept_mesh.h"

#include "mesh/float_lattice.h"

namespace thicken {

namespace {

// Adds one copy of every vertex, `sign`·r·m away, and the copied triangles. Behind S they are
// reversed, so that they face away from the solid.
VertexId addShell(SweptMesh& mesh, const TriangleMesh& surface, std::span<const SweepDirection> direction,
                  double thickness, double sign) {
  const auto first = static_cast<VertexId>(mesh.surfaceVertices + mesh.copies.size());
  for (VertexId v = 0; v < surface.positions.size(); ++v) {
    Copy c;
    c.base = v;
    c.offset = sign * thickness * direction[v].m;
    c.length = c.offset.norm();
    c.safety = direction[v].safety;
    mesh.copies.push_back(c);
    mesh.positions.push_back(surface.positions[v]);
  }
  for (const auto& [a, b, c] : surface.triangles) {
    mesh.triangles.push_back(sign < 0 ? Triangle{first + c, first + b, first + a}
                                      : Triangle{first + a, first + b, first + c});
    mesh.region.push_back(Region::kShell);
  }
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
}

}  // namespace

void SweptMesh::place(std::size_t copy) {
  const Copy& c = copies[copy];
  positions[vertexOf(copy)] = roundToFloat(positions[c.base] + c.depth * c.offset);
}

SweptMesh sweepMesh(const TriangleMesh& surface, std::span<const SweepDirection> direction, const Rim& rim,
                    double thickness, Side side) {
  SweptMesh mesh;
  mesh.surfaceVertices = surface.positions.size();
  mesh.surfaceTriangles = surface.triangles.size();
  mesh.thickness = thickness;
  mesh.positions = surface.positions;
  mesh.triangles = surface.triangles;
  mesh.region.assign(surface.triangles.size(), Region::kOriginal);
  const std::size_t shells = side == Side::kBoth ? 2 : 1, walls = 2 * shells * rim.edges.size();
  mesh.copies.reserve(shells * surface.positions.size());
  mesh.positions.reserve((1 + shells) * surface.positions.size());
  mesh.triangles.reserve((1 + shells) * surface.triangles.size() + walls);
  mesh.region.reserve((1 + shells) * surface.triangles.size() + walls);
  const VertexId behind = addShell(mesh, surface, direction, thickness, -1);
  for (const RimEdge& e : rim.edges) addWall(mesh, e, 0, behind);
  if (side == Side::kBoth) {
    const VertexId before = addShell(mesh, surface, direction, thickness, 1);
    for (const RimEdge& e : rim.edges) addWall(mesh, e, before, 0);
  }
  mesh.fixed.assign(mesh.triangles.size(), 0);
  std::fill_n(mesh.fixed.begin(), mesh.surfaceTriangles, std::uint8_t{1});
  return mesh;
}

}  // namespace thicken
