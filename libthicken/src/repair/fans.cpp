// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/fans.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "mesh/union_find.h"
#include "repair/sheets.h"

namespace thicken::repairing {

using mesh::VertexTriangles;

std::vector<std::vector<TriangleId>> fansAt(const Workpiece& piece, const VertexTriangles& around, VertexId v,
                                            std::span<const std::uint8_t> lost) {
  struct Spoke {
    VertexId end;
    std::uint32_t index;
  };
  std::vector<TriangleId> triangles;
  std::vector<Spoke> spokes;
  for (const TriangleId t : around.of(v)) {
    if (piece.present[t] == 0) continue;
    const Triangle& c = piece.mesh.triangles[t];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const VertexId a = c[k], b = c[(k + 1) % 3];
      if ((a != v && b != v) || (!lost.empty() && lost[3 * t + k] != 0)) continue;
      spokes.push_back({a == v ? b : a, static_cast<std::uint32_t>(triangles.size())});
    }
    triangles.push_back(t);
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.end < b.end; });
  mesh::UnionFind groups(triangles.size());
  for (std::size_t i = 1; i < spokes.size(); ++i)
    if (spokes[i].end == spokes[i - 1].end) groups.join(spokes[i].index, spokes[i - 1].index);
  std::vector<std::vector<TriangleId>> fans;
  std::vector<std::size_t> number(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t root = groups.root(i);  // the smallest member: it has its number already
    if (root == i) {
      number[i] = fans.size();
      fans.emplace_back();
    }
    fans[number[root]].push_back(triangles[i]);
  }
  return fans;
}

void giveUpNonManifold(const Workpiece& piece, const VertexTriangles& around, std::span<const double> areaAt,
                       GivenUp& given) {
  for (VertexId v = 0; v + 1 < around.offset.size(); ++v) {
    const auto fans = fansAt(piece, around, v, given.edge);
    if (fans.size() < 2) continue;
    std::vector<std::pair<double, double>> size(fans.size(), {0, 0});
    for (std::size_t f = 0; f < fans.size(); ++f)
      for (const TriangleId t : fans[f]) {
        size[f].first = std::max(size[f].first, areaAt[t]);
        size[f].second += piece.area(t);
      }
    const auto kept = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    for (std::size_t f = 0; f < fans.size(); ++f)
      for (const TriangleId t : fans[f]) {
        const Triangle& c = piece.mesh.triangles[t];
        if (f != kept) given.corner[3 * t + (std::find(c.begin(), c.end(), v) - c.begin())] = 1;
      }
  }
}

bool cutNonManifoldVertices(Workpiece& piece) {
  const std::size_t slots = 3 * piece.mesh.triangles.size();
  GivenUp given{std::vector<std::uint8_t>(slots, 0), std::vector<std::uint8_t>(slots, 0)};
  const VertexTriangles around = mesh::vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  giveUpNonManifold(piece, around, sheetsOf(piece).areaAt, given);
  const bool any =
      std::any_of(given.corner.begin(), given.corner.end(), [](std::uint8_t c) { return c != 0; });
  if (any) retreat(piece, given, RepairKind::kNonManifoldVertex);
  return any;
}

void openNonManifoldVertices(Workpiece& piece, const VertexTriangles& around) {
  std::vector<VertexId> open(piece.mesh.positions.size());
  std::iota(open.rbegin(), open.rend(), 0u);
  while (!open.empty()) {
    const VertexId v = open.back();
    open.pop_back();
    const auto fans = fansAt(piece, around, v);
    if (fans.size() < 2) continue;
    std::vector<double> area(fans.size(), 0);
    for (std::size_t f = 0; f < fans.size(); ++f)
      for (const TriangleId t : fans[f]) area[f] += piece.area(t);
    const auto kept = std::max_element(area.begin(), area.end()) - area.begin();
    for (std::size_t f = 0; f < fans.size(); ++f) {
      if (f == static_cast<std::size_t>(kept)) continue;
      for (const TriangleId t : fans[f]) {
        piece.remove(t, RepairKind::kNonManifoldVertex);
        for (const VertexId w : piece.mesh.triangles[t])
          if (w != v) open.push_back(w);
      }
    }
  }
}

}  // namespace thicken::repairing
