// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/nesting.h"

#include <algorithm>
#include <limits>

#include "exact/predicates.h"
#include "parallel/parallel_for.h"

namespace thicken::checking {

using mesh::Components;
using mesh::HalfEdge;
using mesh::kNone;

namespace {

using exact::orientation;
using exact::orientation2;

bool lexicographicallyLess(const Vec3& p, const Vec3& q) {
  for (int k = 0; k < 3; ++k)
    if (p[k] != q[k]) return p[k] < q[k];
  return false;
}

// Order of the directions from `v` to its neighbours, all of them lexicographically above it: by the
// angle seen along z, then, within one upright half plane, by the slope. The first direction carries
// an upright plane that all of the others lie on one side of, and is an edge of their convex hull.
bool firstInFan(const Vec3& v, const Vec3& p, const Vec3& q) {
  const bool pUpright = p[0] == v[0] && p[1] == v[1], qUpright = q[0] == v[0] && q[1] == v[1];
  if (pUpright || qUpright) return !pUpright;
  const int side = orientation2(v, q, p, 2);
  if (side != 0) return side < 0;
  // the steeper one has the larger rise for the same run, along x where it runs along x
  return p[0] != v[0] ? orientation2(v, q, p, 1) > 0 : orientation2(v, q, p, 0) < 0;
}

// Sign of the area of the triangle p, q, x seen along x's axis, with x moved by (ε, ε²) in (y, z):
// never 0 unless p and q are one point in this view. So a line along x passes every edge on a side
// that both triangles at the edge agree on.
int sideOfMoved(const Vec3& p, const Vec3& q, const Vec3& x) {
  const int side = orientation2(p, q, x, 0);
  if (side != 0) return side;
  if (p[2] != q[2]) return p[2] > q[2] ? 1 : -1;
  return q[1] > p[1] ? 1 : (q[1] < p[1] ? -1 : 0);
}

// Whether the half line from `x` toward −x crosses the triangle.
bool crossesBelow(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& x) {
  const int side = sideOfMoved(a, b, x);
  if (side == 0 || sideOfMoved(b, c, x) != side || sideOfMoved(c, a, x) != side) return false;
  // the triangle's normal has the sign `side` along x
  return orientation(a, b, c, x) * side > 0;
}

}  // namespace

std::vector<VertexId> lowestVertices(const TriangleMesh& mesh, const Components& shells) {
  std::vector<VertexId> lowest(shells.count, kNone);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    VertexId& best = lowest[shells.ofTriangle[t]];
    for (const VertexId v : mesh.triangles[t])
      if (best == kNone || lexicographicallyLess(mesh.positions[v], mesh.positions[best])) best = v;
  }
  return lowest;
}

std::vector<std::uint8_t> trianglesBelow(const TriangleMesh& mesh, std::span<const VertexId> vertices,
                                         int threads) {
  std::vector<Vec3> points;
  for (const VertexId v : vertices) points.push_back(mesh.positions[v]);
  const auto lower = [](const Vec3& p, const Vec3& q) { return p[1] < q[1]; };
  std::sort(points.begin(), points.end(), lower);
  std::vector<std::uint8_t> below(mesh.triangles.size(), 0);
  parallel::parallelFor(below.size(), threads, RunContext(), 4096, [&](std::size_t t) {
    const Triangle& c = mesh.triangles[t];
    const Vec3 &p = mesh.positions[c[0]], &q = mesh.positions[c[1]], &r = mesh.positions[c[2]];
    const Vec3 low = p.cwiseMin(q).cwiseMin(r), high = p.cwiseMax(q).cwiseMax(r);
    for (auto x = std::lower_bound(points.begin(), points.end(), low, lower);
         x != points.end() && (*x)[1] <= high[1] && below[t] == 0; ++x)
      below[t] = low[0] <= (*x)[0] && low[2] <= (*x)[2] && (*x)[2] <= high[2];
  });
  return below;
}

bool facesOutward(const TriangleMesh& mesh, const mesh::HalfEdges& edges, VertexId lowest) {
  const Vec3& v = mesh.positions[lowest];
  VertexId first = kNone;
  for (const HalfEdge& e : edges.from(lowest))
    if (first == kNone || firstInFan(v, mesh.positions[e.to], mesh.positions[first])) first = e.to;
  if (first == kNone) return false;
  const auto uses = edges.uses(lowest, first), back = edges.uses(first, lowest);
  if (uses.empty() || back.empty()) return false;
  // The edge is on the convex hull of the fan, so the two triangles make a convex ridge there if they
  // face outward: either one's third corner is behind the other.
  const auto third = [&mesh](const HalfEdge& e) {
    return mesh.positions[mesh.triangles[e.triangle()][(e.corner() + 2) % 3]];
  };
  return orientation(v, mesh.positions[first], third(uses[0]), third(back[0])) < 0;
}

std::vector<std::uint32_t> shellsAround(const TriangleMesh& mesh, const exact::BoxTree& tree,
                                        const Components& shells, VertexId v, std::uint32_t ownShell) {
  const Vec3& x = mesh.positions[v];
  std::vector<std::uint32_t> crossed;  // a shell as often as the half line from x toward −x crosses it
  for (const TriangleId t : tree.near({-std::numeric_limits<double>::infinity(), x[1], x[2]}, x)) {
    const std::uint32_t shell = shells.ofTriangle[t];
    const Triangle& c = mesh.triangles[t];
    if (shell != ownShell &&
        crossesBelow(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]], x))
      crossed.push_back(shell);
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<std::uint32_t> around;
  for (std::size_t i = 0, j = 0; i < crossed.size(); i = j) {
    while (j < crossed.size() && crossed[j] == crossed[i]) ++j;
    if ((j - i) % 2 == 1) around.push_back(crossed[i]);
  }
  return around;
}

bool insideOddNumber(const TriangleMesh& mesh, const exact::BoxTree& tree, const Components& shells,
                     VertexId v, std::uint32_t ownShell) {
  return shellsAround(mesh, tree, shells, v, ownShell).size() % 2 == 1;
}

}  // namespace thicken::checking
