// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/inspect.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "bvh/ray_tree.h"
#include "check/audit.h"
#include "check/nesting.h"
#include "measure/measure.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "thicken/check.h"

namespace thicken {

using bvh::RayTree;
using mesh::Components;

namespace {

// The volume that each shell encloses, of negative sign for one that faces inwards.
std::vector<double> volumesOf(const TriangleMesh& mesh, const Components& shells) {
  std::vector<double> volume(shells.count, 0);
  std::vector<Vec3> origin(shells.count);
  std::vector<std::uint8_t> begun(shells.count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::uint32_t s = shells.ofTriangle[t];
    if (!std::exchange(begun[s], std::uint8_t{1})) origin[s] = mesh.positions[a];
    volume[s] += (mesh.positions[a] - origin[s])
                     .cross(mesh.positions[b] - origin[s])
                     .dot(mesh.positions[c] - origin[s]) /
                 6;
  }
  return volume;
}

std::vector<SolidShell> shellsOf(const TriangleMesh& mesh, const Components& parts, int threads) {
  const std::vector<double> volume = volumesOf(mesh, parts);
  const std::vector<VertexId> lowest = checking::lowestVertices(mesh, parts);
  const exact::BoxTree tree(mesh.positions, mesh.triangles, threads);
  std::vector<SolidShell> shells(parts.count);
  for (const std::uint32_t s : parts.ofTriangle) ++shells[s].triangles;
  for (std::uint32_t s = 0; s < parts.count; ++s) {
    SolidShell& shell = shells[s];
    shell.volume = std::abs(volume[s]);
    const std::vector<std::uint32_t> around = checking::shellsAround(mesh, tree, parts, lowest[s], s);
    shell.cavity = around.size() % 2 == 1;
    for (const std::uint32_t other : around)
      if (shell.within == SolidShell::kNoShell || std::abs(volume[other]) < std::abs(volume[shell.within]))
        shell.within = other;
  }
  return shells;
}

}  // namespace

Inspection inspect(const TriangleMesh& solid, RunContext context, int threads) {
  const TriangleMesh mesh = weld(solid);
  Inspection result;
  checking::AuditResult audited = checking::audit(mesh, {}, Side::kNegative, context, threads);
  result.audit = audited.facts;
  result.audit.surfaceKept = true;
  result.defects = std::move(audited.defects);
  const Components parts = mesh::componentsOf(mesh.positions.size(), mesh.triangles);
  result.shellOfTriangle = parts.ofTriangle;
  if (!result.audit.passed()) return result;
  result.volume = measure::volumeOf(mesh);
  result.area = measure::areaOf(mesh);
  result.shells = shellsOf(mesh, parts, threads);
  return result;
}

namespace {

// Two sides of a wall face away from each other. Faces whose normals are within 120° meet at an edge instead,
// or lie in each other's way by chance: chosen so that every edge of 60° and more is none.
constexpr double kOpposite = 0.5;

Vec3 normalOf(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return (mesh.positions[b] - mesh.positions[a])
      .cross(mesh.positions[c] - mesh.positions[a])
      .stableNormalized();
}

}  // namespace

std::vector<double> wallThickness(const TriangleMesh& solid, RunContext context, int threads,
                                  std::span<const std::uint8_t> isEdge) {
  const TriangleMesh mesh = weld(solid);
  const RayTree tree(mesh.positions, mesh.triangles);
  std::vector<double> thickness(mesh.triangles.size(), std::numeric_limits<double>::infinity());
  parallel::parallelFor(thickness.size(), threads, context, 256, [&](std::size_t t) {
    const Triangle& corners = mesh.triangles[t];
    const Vec3& p = mesh.positions[corners[0]];
    const Vec3 u = mesh.positions[corners[1]] - p, v = mesh.positions[corners[2]] - p, normal = u.cross(v);
    const bool skipped = !isEdge.empty() && isEdge[t] != 0;
    if (skipped || normal.squaredNorm() == 0) return;
    const Vec3 inward = -normal.stableNormalized();
    const RayTree::Hit hit = tree.first(p + (u + v) / 3, inward, corners);
    if (!std::isfinite(hit.along) || inward.dot(normalOf(mesh, hit.triangle)) < kOpposite) return;
    if (isEdge.empty() || isEdge[hit.triangle] == 0) thickness[t] = hit.along;
  });
  return thickness;
}

}  // namespace thicken
