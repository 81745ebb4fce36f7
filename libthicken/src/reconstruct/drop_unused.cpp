// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/drop_unused.h"

#include <numeric>
#include <utility>

#include "mesh/topology.h"

namespace thicken::reconstruct {

using mesh::kNone;

void dropUnused(Reconstruction& made, std::size_t surfaceVertices) {
  TriangleMesh& mesh = made.mesh;
  std::vector<VertexId> to(mesh.positions.size(), kNone);
  auto count = static_cast<VertexId>(surfaceVertices);
  std::iota(to.begin(), to.begin() + count, VertexId{0});
  for (Triangle& t : mesh.triangles)
    for (VertexId& v : t) {
      if (to[v] == kNone) to[v] = count++;
      v = to[v];
    }
  std::vector<Vec3> positions(count);
  std::vector<VertexId> base(made.base.empty() ? 0 : count), origin(made.origin.empty() ? 0 : count);
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == kNone) continue;
    positions[to[v]] = mesh.positions[v];
    if (!base.empty()) base[to[v]] = made.base[v];
    if (!origin.empty()) origin[to[v]] = made.origin[v];
  }
  mesh.positions = std::move(positions);
  made.base = std::move(base);
  made.origin = std::move(origin);
  std::erase_if(made.ends, [&](const WallEnd& end) { return to[end.vertex] == kNone; });
  for (WallEnd& end : made.ends) end.vertex = to[end.vertex];
}

}  // namespace thicken::reconstruct
