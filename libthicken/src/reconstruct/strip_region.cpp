// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/strip_region.h"

#include <vector>

namespace thicken::reconstruct {

using mesh::HalfEdge;
using mesh::HalfEdges;

HalfEdges edgesAtStrip(const Assembly& assembly, int threads) {
  const std::vector<Triangle>& triangles = assembly.mesh.triangles;
  std::vector<std::uint8_t> onStrip(assembly.mesh.positions.size(), 0), beside(triangles.size(), 0);
  for (auto t = static_cast<TriangleId>(assembly.carrierTriangles); t < triangles.size(); ++t)
    if (assembly.isStrip(t))
      for (const VertexId v : triangles[t]) onStrip[v] = 1;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    beside[t] = onStrip[triangles[t][0]] + onStrip[triangles[t][1]] + onStrip[triangles[t][2]] > 1;
  return {assembly.mesh.positions.size(), triangles, beside, threads};
}

void labelStrip(Assembly& assembly, int threads) {
  const std::vector<Triangle>& triangles = assembly.mesh.triangles;
  const HalfEdges edges = edgesAtStrip(assembly, threads);
  std::vector<TriangleId> walls;
  std::vector<std::uint8_t> known(triangles.size(), 0);
  for (auto t = static_cast<TriangleId>(assembly.carrierTriangles); t < triangles.size(); ++t) {
    if (!assembly.isStrip(t)) continue;
    for (int k = 0; k < 3 && !known[t]; ++k)
      for (const HalfEdge& across : edges.uses(triangles[t][(k + 1) % 3], triangles[t][k])) {
        if (across.triangle() < assembly.carrierTriangles || assembly.isStrip(across.triangle())) continue;
        known[t] = 1;
        assembly.region[t] = assembly.region[across.triangle()];
        if (assembly.region[t] == Region::kWall) walls.push_back(t);
      }
  }
  for (std::size_t i = 0; i < walls.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Triangle& wall = triangles[walls[i]];
      for (const HalfEdge& across : edges.uses(wall[(k + 1) % 3], wall[k])) {
        const TriangleId t = across.triangle();
        if (!assembly.isStrip(t) || known[t]) continue;
        known[t] = 1;
        assembly.region[t] = Region::kWall;
        walls.push_back(t);
      }
    }
}

}  // namespace thicken::reconstruct
