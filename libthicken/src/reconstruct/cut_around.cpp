// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/cut_around.h"

#include <algorithm>

namespace thicken::reconstruct {

void cutAround(const TriangleMesh& mesh, std::span<const TriangleId> triangles,
               std::span<const std::uint8_t> openable, int rings, std::vector<std::uint8_t>& keep) {
  std::vector<std::uint8_t> near(mesh.positions.size(), 0);
  const auto reach = [&](TriangleId t) {
    for (const VertexId v : mesh.triangles[t]) near[v] = 1;
  };
  for (const TriangleId t : triangles) {
    if (openable[t]) keep[t] = 0;
    reach(t);
  }
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<TriangleId> next;
    for (TriangleId t = 0; t < keep.size(); ++t)
      if (keep[t] && openable[t] &&
          std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                      [&](VertexId v) { return near[v]; }))
        next.push_back(t);
    for (const TriangleId t : next) {
      keep[t] = 0;
      reach(t);
    }
  }
}

}  // namespace thicken::reconstruct
