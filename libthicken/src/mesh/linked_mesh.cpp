// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/linked_mesh.h"

#include <algorithm>

#include "mesh/topology.h"

namespace thicken::mesh {

LinkedMesh::LinkedMesh(std::size_t vertices, std::vector<Triangle>& triangles, int threads)
    : triangles_(triangles),
      neighbour_(neighbours(vertices, triangles, threads)),
      any_(vertices, kNone),
      gone_(triangles.size(), 0) {
  for (TriangleId t = 0; t < triangles.size(); ++t)
    for (const VertexId v : triangles[t]) any_[v] = t;
}

bool LinkedMesh::isClosedManifold() const {
  std::vector<std::uint32_t> around(any_.size(), 0);
  for (TriangleId t = 0; t < neighbour_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const TriangleId n = neighbour_[t][k];
      if (n == kNone || n == t) return false;
      if (std::ranges::count(neighbour_[n], t) != std::ranges::count(neighbour_[t], n)) return false;
      ++around[triangles_[t][k]];
    }
  for (VertexId v = 0; v < around.size(); ++v)
    if (valence(v, around[v]) != around[v]) return false;
  return true;
}

std::size_t LinkedMesh::valence(VertexId v, std::size_t most) const {
  if (any_[v] == kNone) return 0;
  std::size_t count = 0;
  TriangleId t = any_[v];
  do {
    t = neighbour_[t][cornerOf(t, v)];
    ++count;
  } while (t != any_[v] && count <= most);
  return count;
}

void LinkedMesh::starOf(VertexId v, std::vector<TriangleId>& star) const {
  star.clear();
  TriangleId t = any_[v];
  do {
    star.push_back(t);
    t = neighbour_[t][cornerOf(t, v)];
  } while (t != any_[v]);
}

bool LinkedMesh::canCollapse(VertexId keep, VertexId go, const std::vector<TriangleId>& starOfKeep,
                             const std::vector<TriangleId>& starOfGo) {
  link_.clear();
  for (const TriangleId t : starOfKeep) link_.push_back(triangles_[t][(cornerOf(t, keep) + 1) % 3]);
  int common = 0;
  for (const TriangleId t : starOfGo) {
    const VertexId ring = triangles_[t][(cornerOf(t, go) + 1) % 3];
    if (std::ranges::find(link_, ring) == link_.end()) continue;
    // With fewer triangles around it the third corner would be left with two.
    constexpr std::size_t kLeast = 4;
    if (++common > 2 || valence(ring, kLeast) < kLeast) return false;
  }
  return common == 2;
}

void LinkedMesh::replaceNeighbour(TriangleId of, TriangleId from, TriangleId to) {
  *std::ranges::find(neighbour_[of], from) = to;
}

void LinkedMesh::collapse(VertexId keep, VertexId go, const std::vector<TriangleId>& starOfGo) {
  std::array<TriangleId, 2> gone{};
  std::size_t count = 0;
  for (const TriangleId t : starOfGo) {
    Triangle& corners = triangles_[t];
    if (std::ranges::find(corners, keep) == corners.end())
      corners[cornerOf(t, go)] = keep;
    else
      gone[count++] = t;
  }
  for (const TriangleId t : gone) {
    const Triangle& corners = triangles_[t];
    const int k = cornerOf(t, keep);
    const int edge = corners[(k + 1) % 3] == go ? k : (k + 2) % 3;  // that is collapsed
    const TriangleId first = neighbour_[t][(edge + 1) % 3], second = neighbour_[t][(edge + 2) % 3];
    const VertexId third = corners[(edge + 2) % 3];
    replaceNeighbour(first, t, second);
    replaceNeighbour(second, t, first);
    any_[keep] = any_[third] = first;
    triangles_[t] = {keep, keep, keep};
    gone_[t] = 1;
  }
  any_[go] = kNone;
}

std::array<Triangle, 2> LinkedMesh::turned(TriangleId t, int edge) const {
  const Triangle& own = triangles_[t];
  const TriangleId other = neighbour_[t][edge];
  const VertexId from = own[edge], to = own[(edge + 1) % 3], apex = own[(edge + 2) % 3];
  const VertexId far = triangles_[other][(cornerOf(other, from) + 1) % 3];
  return {Triangle{from, far, apex}, Triangle{far, to, apex}};
}

bool LinkedMesh::canTurn(TriangleId t, int edge) const {
  const std::array<Triangle, 2> after = turned(t, edge);
  const auto [from, far, apex] = after[0];
  TriangleId around = any_[apex];
  do {
    if (std::ranges::find(triangles_[around], far) != triangles_[around].end()) return false;
    around = neighbour_[around][cornerOf(around, apex)];
  } while (around != any_[apex]);
  constexpr std::size_t kLeast = 4;  // with fewer triangles an end of the edge would be left with two
  return valence(from, kLeast) >= kLeast && valence(after[1][1], kLeast) >= kLeast;
}

void LinkedMesh::turn(TriangleId t, int edge) {
  const TriangleId other = neighbour_[t][edge];
  const std::array<Triangle, 2> after = turned(t, edge);
  const int k = cornerOf(other, after[0][0]);
  const TriangleId beforeApex = neighbour_[t][(edge + 2) % 3], afterTo = neighbour_[t][(edge + 1) % 3];
  const TriangleId afterFrom = neighbour_[other][k], beforeTo = neighbour_[other][(k + 1) % 3];
  replaceNeighbour(afterTo, t, other);
  replaceNeighbour(afterFrom, other, t);
  triangles_[t] = after[0];
  triangles_[other] = after[1];
  neighbour_[t] = {afterFrom, other, beforeApex};
  neighbour_[other] = {beforeTo, afterTo, t};
  any_[after[0][0]] = t;
  any_[after[1][1]] = other;
}

}  // namespace thicken::mesh
