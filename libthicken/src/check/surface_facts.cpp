// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/surface_facts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "mesh/topology.h"
#include "mesh/union_find.h"

namespace thicken::checking {
namespace {

// Connected sets of rim edges: on a manifold surface these are its closed boundary loops.
std::size_t loopsOf(std::size_t vertexCount, const std::vector<Edge>& rim) {
  mesh::UnionFind vertices(vertexCount);
  std::vector<std::uint8_t> onRim(vertexCount, 0);
  for (const Edge& e : rim) {
    vertices.join(e[0], e[1]);
    onRim[e[0]] = onRim[e[1]] = 1;
  }
  std::size_t loops = 0;
  for (VertexId v = 0; v < vertexCount; ++v) loops += onRim[v] != 0 && vertices.root(v) == v;
  return loops;
}

}  // namespace

bool isFinite(const Vec3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  for (int k = 0; k < 3; ++k)
    if (!(std::abs(p[k]) <= kLargest)) return false;
  return true;
}

void addSizes(const TriangleMesh& mesh, SurfaceFacts& facts) {
  Eigen::AlignedBox3d box;
  double edges = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    facts.area += 0.5 * (b - a).cross(c - a).norm();
    edges += (b - a).norm() + (c - b).norm() + (a - c).norm();
    for (const Vec3* p : {&a, &b, &c}) box.extend(*p);
  }
  facts.diagonal = box.diagonal().norm();
  facts.meanEdge = edges / (3.0 * static_cast<double>(mesh.triangles.size()));
}

SurfaceFacts factsOf(const TriangleMesh& mesh, const BadJoints& joints, bool finite, int threads) {
  SurfaceFacts facts;
  facts.triangles = mesh.triangles.size();
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t) used[v] = 1;
  for (const std::uint8_t u : used) facts.vertices += u;
  if (mesh.triangles.empty()) return facts;
  facts.rims = loopsOf(mesh.positions.size(), joints.rim);
  facts.components = mesh::componentsOf(mesh.positions.size(), mesh.triangles, threads).count;
  facts.closed = joints.rim.empty() && joints.nonManifoldEdges.empty();
  if (finite) addSizes(mesh, facts);
  return facts;
}

}  // namespace thicken::checking
