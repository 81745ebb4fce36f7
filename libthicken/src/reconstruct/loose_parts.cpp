// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/loose_parts.h"

#include <algorithm>

#include "check/misplaced_shells.h"
#include "mesh/bounds.h"
#include "mesh/topology.h"
#include "reconstruct/drop_unused.h"

namespace thicken::reconstruct {

using checking::misplacedShells;
using mesh::Components;
using mesh::componentsOf;

namespace {

void dropParts(Assembly& assembly, const Components& parts, std::span<const std::uint8_t> drop) {
  std::size_t kept = 0, keptOfCarrier = 0;
  for (std::size_t t = 0; t < parts.ofTriangle.size(); ++t) {
    if (drop[parts.ofTriangle[t]]) continue;
    assembly.mesh.triangles[kept] = assembly.mesh.triangles[t];
    assembly.region[kept] = assembly.region[t];
    if (t < assembly.carrierTriangles)
      assembly.source[keptOfCarrier++] = assembly.source[t];
    else
      assembly.crossing[kept - keptOfCarrier] = assembly.crossing[t - assembly.carrierTriangles];
    ++kept;
  }
  assembly.mesh.triangles.resize(kept);
  assembly.region.resize(kept);
  assembly.crossing.resize(kept - keptOfCarrier);
  assembly.source.resize(keptOfCarrier);
  assembly.carrierTriangles = keptOfCarrier;
}

bool allOf(std::span<const std::uint8_t> flags) {
  return std::find(flags.begin(), flags.end(), 0) == flags.end();
}

bool anyOf(std::span<const std::uint8_t> flags) {
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
}

// Per part: whether any of it is the carrier's.
std::vector<std::uint8_t> hangingOnCarrier(const Assembly& assembly, const Components& parts) {
  std::vector<std::uint8_t> hangs(parts.count, 0);
  for (std::size_t t = 0; t < assembly.carrierTriangles; ++t) hangs[parts.ofTriangle[t]] = 1;
  return hangs;
}

}  // namespace

void dropSpecks(Assembly& assembly, double width, int threads) {
  constexpr double kSpeck = 8;  // cells
  const TriangleMesh& mesh = assembly.mesh;
  const Components parts = componentsOf(mesh.positions.size(), mesh.triangles, threads);
  const std::vector<std::uint8_t> hangs = hangingOnCarrier(assembly, parts);
  if (allOf(hangs)) return;
  std::vector<mesh::Bounds> bounds(parts.count);
  for (std::size_t t = assembly.carrierTriangles; t < parts.ofTriangle.size(); ++t) {
    if (hangs[parts.ofTriangle[t]]) continue;
    for (const VertexId v : mesh.triangles[t]) bounds[parts.ofTriangle[t]].add(mesh.positions[v]);
  }
  std::vector<std::uint8_t> drop(parts.count, 0);
  for (std::uint32_t part = 0; part < parts.count; ++part)
    drop[part] = !hangs[part] && (bounds[part].high - bounds[part].low).norm() < kSpeck * width;
  dropParts(assembly, parts, drop);
}

void dropMisplaced(Assembly& assembly, int threads) {
  const Components parts = componentsOf(assembly.mesh.positions.size(), assembly.mesh.triangles, threads);
  const std::vector<std::uint8_t> drop = misplacedShells(assembly.mesh, assembly.region, parts, threads);
  if (anyOf(drop)) dropParts(assembly, parts, drop);
}

void dropMisplaced(Reconstruction& made, std::size_t surfaceVertices, int threads) {
  const Components parts = componentsOf(made.mesh.positions.size(), made.mesh.triangles, threads);
  const std::vector<std::uint8_t> drop = misplacedShells(made.mesh, made.region, parts, threads);
  if (!anyOf(drop)) return;
  const auto erase = [&](auto& ofTriangle) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < ofTriangle.size(); ++t)
      if (!drop[parts.ofTriangle[t]]) ofTriangle[kept++] = ofTriangle[t];
    ofTriangle.resize(kept);
  };
  erase(made.mesh.triangles);
  erase(made.region);
  erase(made.openable);
  erase(made.left);
  dropUnused(made, surfaceVertices);
}

}  // namespace thicken::reconstruct
