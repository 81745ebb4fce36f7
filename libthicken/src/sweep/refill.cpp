// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/refill.h"

#include "mesh/minimal_area.h"
#include "sweep/conflicts.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace thicken {

namespace {

using Loop = std::vector<VertexId>;

std::uint64_t edgeKey(VertexId a, VertexId b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}
std::uint64_t directedKey(VertexId a, VertexId b) { return (std::uint64_t{a} << 32) | b; }

bool usesDropped(const SweptMesh& mesh, const Triangle& t) {
  return std::any_of(t.begin(), t.end(), [&](VertexId v) { return mesh.isCopy(v) && mesh.copyOf(v).dropped; });
}

// The border of the removed triangles, as loops in their direction. Copies at which it touches
// itself are put into `pinched` instead.
std::vector<Loop> holeLoops(const SweptMesh& mesh, const std::vector<Triangle>& removed, std::vector<std::uint32_t>& pinched,
                            bool& open) {
  EdgeSet directed;
  for (const Triangle& t : removed)
    for (int k = 0; k < 3; ++k) directed.insert(directedKey(t[k], t[(k + 1) % 3]));
  std::vector<std::pair<VertexId, VertexId>> border;
  for (const Triangle& t : removed)
    for (int k = 0; k < 3; ++k)
      if (!directed.contains(directedKey(t[(k + 1) % 3], t[k]))) border.emplace_back(t[k], t[(k + 1) % 3]);
  std::sort(border.begin(), border.end());
  std::unordered_map<VertexId, VertexId> next;
  open = false;
  for (const auto& [a, b] : border) {
    if (next.emplace(a, b).second) continue;
    if (mesh.isCopy(a))
      pinched.push_back(static_cast<std::uint32_t>(a - mesh.surfaceVertices));
    else
      open = true;  // S itself is pinched there; nothing can be dropped for it
  }
  std::vector<Loop> loops;
  if (!pinched.empty() || open) return loops;
  for (const auto& [start, unused] : border) {
    if (!next.contains(start)) continue;
    Loop loop;
    for (VertexId v = start; next.contains(v);) {
      loop.push_back(v);
      const VertexId to = next[v];
      next.erase(v);
      v = to;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

// The label of a filled triangle: wall where it uses the rim of S itself.
Region regionOf(const SweptMesh& mesh, const Triangle& t) {
  return std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.isCopy(v); }) ? Region::kShell : Region::kWall;
}

}  // namespace

bool dropAndRefill(SweptMesh& mesh, std::vector<std::uint32_t> copies) {
  const std::vector<Copy> copiesBefore = mesh.copies;
  const auto giveUp = [&] {
    mesh.copies = copiesBefore;
    return false;
  };
  std::vector<Loop> loops;
  std::vector<Triangle> removed;
  while (!copies.empty()) {
    for (const std::uint32_t i : copies) mesh.copies[i].dropped = true;
    removed.clear();
    for (std::size_t t = mesh.surfaceTriangles; t < mesh.triangles.size(); ++t)
      if (usesDropped(mesh, mesh.triangles[t])) removed.push_back(mesh.triangles[t]);
    copies.clear();
    bool open = false;
    loops = holeLoops(mesh, removed, copies, open);
    if (open) return giveUp();
    sortUnique(copies);
  }
  EdgeSet edges;
  for (const Triangle& t : mesh.triangles)
    if (!usesDropped(mesh, t))
      for (int k = 0; k < 3; ++k) edges.insert(edgeKey(t[k], t[(k + 1) % 3]));
  std::vector<Triangle> fill;
  for (const Loop& loop : loops) {
    const auto triangles = minimalAreaTriangulation(mesh.positions, loop, edges);
    if (triangles.empty()) return giveUp();
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) edges.insert(edgeKey(t[k], t[(k + 1) % 3]));
    fill.insert(fill.end(), triangles.begin(), triangles.end());
  }
  std::size_t kept = mesh.surfaceTriangles;
  for (std::size_t t = kept; t < mesh.triangles.size(); ++t) {
    if (usesDropped(mesh, mesh.triangles[t])) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.region[kept++] = mesh.region[t];
  }
  mesh.triangles.resize(kept);
  mesh.region.resize(kept);
  for (const Triangle& t : fill) {
    mesh.triangles.push_back(t);
    mesh.region.push_back(regionOf(mesh, t));
  }
  mesh.fixed.assign(mesh.triangles.size(), 0);
  std::fill_n(mesh.fixed.begin(), mesh.surfaceTriangles, std::uint8_t{1});
  return true;
}

}  // namespace thicken
