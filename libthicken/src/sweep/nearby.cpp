// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/nearby.h"

#include <algorithm>

#include "parallel/parallel_for.h"

namespace thicken::sweep {

namespace {

std::vector<TriangleId> trianglesAtVertices(const SweptMesh& mesh) {
  std::vector<TriangleId> at(mesh.surfaceVertices, 0);
  for (TriangleId t = 0; t < mesh.surfaceTriangles; ++t)
    for (const VertexId v : mesh.triangles[t]) at[v] = t;
  return at;
}

}  // namespace

std::vector<TriangleId> trianglesAtCopies(const SweptMesh& mesh) {
  const std::vector<TriangleId> atVertex = trianglesAtVertices(mesh);
  std::vector<TriangleId> at;
  at.reserve(mesh.copies.size());
  for (const Copy& c : mesh.copies) at.push_back(atVertex[c.base]);
  return at;
}

std::vector<TriangleId> trianglesAbove(std::span<const TriangleId> shell, const SweptMesh& mesh,
                                       int threads) {
  const std::vector<TriangleId> atVertex = trianglesAtVertices(mesh);
  std::vector<TriangleId> above(shell.size());
  parallel::parallelFor(shell.size(), threads, RunContext(), 4096, [&](std::size_t i) {
    const VertexId first = mesh.triangles[shell[i]][0];
    above[i] = mesh.above[shell[i]];
    if (above[i] == mesh::kNone) above[i] = atVertex[mesh.isCopy(first) ? mesh.copyOf(first).base : first];
  });
  return above;
}

}  // namespace thicken::sweep
