// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/fans.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "mesh/union_find.h"

namespace thicken::repairing {

std::vector<std::vector<TriangleId>> fansAt(const Workpiece& piece, const VertexTriangles& around,
                                            VertexId v) {
  struct Spoke {
    VertexId end;
    std::uint32_t index;
  };
  std::vector<TriangleId> triangles;
  std::vector<Spoke> spokes;
  for (const TriangleId t : around.of(v)) {
    if (piece.present[t] == 0) continue;
    for (const VertexId w : piece.mesh.triangles[t])
      if (w != v) spokes.push_back({w, static_cast<std::uint32_t>(triangles.size())});
    triangles.push_back(t);
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) { return a.end < b.end; });
  UnionFind groups(triangles.size());
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

void openPinchedVertices(Workpiece& piece, const VertexTriangles& around) {
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
