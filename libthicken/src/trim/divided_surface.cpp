// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim/divided_surface.h"

#include <algorithm>

#include "exact/predicates.h"

namespace thicken::trimming {

using mesh::kNone;

TooNarrow::TooNarrow(const Vec3& at) : std::runtime_error("too narrow"), place(at) {}

DividedSurface::DividedSurface(const TriangleMesh& surface, int threads)
    : positions_(surface.positions),
      triangles_(surface.triangles),
      across_(mesh::neighbours(surface.positions.size(), surface.triangles, threads)),
      triangleAt_(surface.positions.size(), kNone),
      originals_(surface.triangles.size()) {
  for (TriangleId t = 0; t < triangles_.size(); ++t)
    for (const VertexId v : triangles_[t]) triangleAt_[v] = t;
}

EdgeOf DividedSurface::twin(const EdgeOf& e) const {
  const TriangleId other = across(e);
  if (other == kNone) return {};
  const auto& corners = triangles_[other];
  const auto found = std::find(corners.begin(), corners.end(), to(e));
  return {other, static_cast<int>(found - corners.begin())};
}

TriangleId DividedSurface::originOf(TriangleId t) const {
  return t < originals_ ? t : originOfAdded_[t - originals_];
}

std::vector<TriangleId> DividedSurface::piecesOf(TriangleId original) const {
  const auto found = pieces_.find(original);
  return found == pieces_.end() ? std::vector<TriangleId>{original} : found->second.pieces;
}

std::vector<EdgeOf> DividedSurface::linkOf(VertexId v) const {
  const auto cornerOf = [&](TriangleId t) {
    const auto& corners = triangles_[t];
    return static_cast<int>(std::find(corners.begin(), corners.end(), v) - corners.begin());
  };
  std::vector<EdgeOf> link;
  const TriangleId first = triangleAt_[v];
  TriangleId t = first;
  do {  // counter-clockwise, across the edge that arrives at v
    const int k = cornerOf(t);
    link.push_back({t, (k + 1) % 3});
    t = across_[t][(k + 2) % 3];
  } while (t != kNone && t != first);
  if (t == first) return link;
  for (t = across_[first][cornerOf(first)]; t != kNone;) {  // from the first one the other way, to the rim
    const int k = cornerOf(t);
    link.push_back({t, (k + 1) % 3});
    t = across_[t][k];
  }
  return link;
}

EdgeOf DividedSurface::edgeBetween(VertexId a, VertexId b) const {
  for (const EdgeOf& e : linkOf(a)) {
    if (from(e) == b) return {e.triangle, (e.corner + 2) % 3};
    if (to(e) == b) return {e.triangle, (e.corner + 1) % 3};
  }
  return {};
}

VertexId DividedSurface::addVertex(const Vec3& p, TriangleId t) {
  positions_.push_back(p);
  triangleAt_.push_back(t);
  return static_cast<VertexId>(positions_.size() - 1);
}

// A copy of `t`, whose corners and neighbours are still to be set.
TriangleId DividedSurface::addPieceOf(TriangleId t) {
  const auto added = static_cast<TriangleId>(triangles_.size());
  const TriangleId origin = originOf(t);
  const auto [whole, fresh] = pieces_.try_emplace(origin);
  if (fresh) {
    const auto& [a, b, c] = triangles_[t];
    whole->second = {exact::normal(positions_[a], positions_[b], positions_[c]), {origin}};
  }
  whole->second.pieces.push_back(added);
  originOfAdded_.push_back(origin);
  triangles_.push_back(triangles_[t]);
  across_.push_back(across_[t]);
  return added;
}

void DividedSurface::relink(TriangleId neighbour, TriangleId before, TriangleId now) {
  if (neighbour == kNone) return;
  auto& around = across_[neighbour];
  *std::find(around.begin(), around.end(), before) = now;
}

void DividedSurface::requireArea(TriangleId t) const {
  const auto& [a, b, c] = triangles_[t];
  const Vec3 normal = exact::normal(positions_[a], positions_[b], positions_[c]);
  if (!(normal.dot(pieces_.at(originOf(t)).normal) > 0)) throw TooNarrow(positions_[c]);
}

VertexId DividedSurface::divideTriangle(TriangleId t, const Vec3& p) {
  const auto [a, b, c] = triangles_[t];
  const auto [ab, bc, ca] = across_[t];
  const VertexId v = addVertex(p, t);
  const TriangleId second = addPieceOf(t), third = addPieceOf(t);
  triangles_[t] = {a, b, v};
  triangles_[second] = {b, c, v};
  triangles_[third] = {c, a, v};
  across_[t] = {ab, second, third};
  across_[second] = {bc, third, t};
  across_[third] = {ca, t, second};
  relink(bc, t, second);
  relink(ca, t, third);
  triangleAt_[c] = second;
  for (const TriangleId piece : {t, second, third}) requireArea(piece);
  return v;
}

VertexId DividedSurface::divideEdge(const EdgeOf& e, const Vec3& p) {
  const TriangleId t = e.triangle, u = across(e);
  const EdgeOf back = twin(e);
  const VertexId a = from(e), b = to(e), c = opposite(e);
  const TriangleId bc = across_[t][(e.corner + 1) % 3], ca = across_[t][(e.corner + 2) % 3];
  const VertexId v = addVertex(p, t);
  const TriangleId beyond = addPieceOf(t);  // at b, as t stays at a
  triangles_[t] = {a, v, c};
  triangles_[beyond] = {v, b, c};
  across_[t] = {kNone, beyond, ca};
  across_[beyond] = {kNone, bc, t};
  relink(bc, t, beyond);
  triangleAt_[a] = t;
  triangleAt_[b] = beyond;
  if (u != kNone) {
    const VertexId d = opposite(back);
    const TriangleId ad = across_[u][(back.corner + 1) % 3], db = across_[u][(back.corner + 2) % 3];
    const TriangleId other = addPieceOf(u);  // at a, as u stays at b
    triangles_[u] = {b, v, d};
    triangles_[other] = {v, a, d};
    across_[u] = {beyond, other, db};
    across_[other] = {t, ad, u};
    relink(ad, u, other);
    across_[t][0] = other;
    across_[beyond][0] = u;
    requireArea(u);
    requireArea(other);
  }
  requireArea(t);
  requireArea(beyond);
  return v;
}

}  // namespace thicken::trimming
