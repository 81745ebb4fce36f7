// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/conflicts.h"

#include <algorithm>

#include "exact/predicates.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::sweep {

ConflictTester::ConflictTester(const SweptMesh& mesh, const RunContext& context, int threads)
    : mesh_(mesh),
      context_(context),
      threads_(threads),
      around_(mesh::vertexTriangles(mesh.positions.size(), mesh.triangles, threads)),
      mark_(mesh.triangles.size(), 0),
      tree_(mesh.positions, mesh.triangles, threads) {}

bool ConflictTester::isFlat(TriangleId t) const {
  const auto& [a, b, c] = mesh_.triangles[t];
  return exact::collinear(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
}

std::vector<TriangleId> ConflictTester::trianglesOf(std::span<const std::uint32_t> copies) {
  std::vector<TriangleId> moved;
  for (const std::uint32_t i : copies)
    for (const TriangleId t : around_.of(mesh_.vertexOf(i))) {
      if (mark_[t]) continue;
      mark_[t] = 1;
      moved.push_back(t);
    }
  for (const TriangleId t : moved) mark_[t] = 0;
  std::sort(moved.begin(), moved.end());
  return moved;
}

Conflicts ConflictTester::all() {
  Conflicts c;
  c.pairs = tree_.meetingPairs(mesh_.positions, mesh_.triangles, mesh_.fixed, context_, threads_);
  const std::size_t first = mesh_.surfaceTriangles;
  std::vector<std::uint8_t> flat(mesh_.triangles.size() - first);
  parallel::parallelFor(flat.size(), threads_, context_, 4096,
                        [&](std::size_t i) { flat[i] = isFlat(static_cast<TriangleId>(first + i)); });
  for (std::size_t i = 0; i < flat.size(); ++i)
    if (flat[i] != 0) c.flat.push_back(static_cast<TriangleId>(first + i));
  return c;
}

Conflicts ConflictTester::after(std::span<const std::uint32_t> moved, const Conflicts& before) {
  const std::vector<TriangleId> triangles = trianglesOf(moved);
  tree_.refit(mesh_.positions, mesh_.triangles, triangles);
  Conflicts c;
  c.pairs =
      tree_.meetingPairsWith(triangles, mesh_.positions, mesh_.triangles, mesh_.fixed, context_, threads_);
  const auto stands = [&](TriangleId t) {
    return !std::binary_search(triangles.begin(), triangles.end(), t);
  };
  for (const auto& p : before.pairs)
    if (stands(p.first) && stands(p.second)) c.pairs.push_back(p);
  for (const TriangleId t : before.flat)
    if (stands(t)) c.flat.push_back(t);
  for (const TriangleId t : triangles)
    if (isFlat(t)) c.flat.push_back(t);
  return c;
}

}  // namespace thicken::sweep
