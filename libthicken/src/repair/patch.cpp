// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "repair/fans.h"

namespace thicken::repairing {

using mesh::kNone;
using mesh::VertexTriangles;

namespace {

// Holes of a shell grow this far before they are given up, and one edge more.
constexpr int kEdges = 6;

// Whether each vertex is within `kEdges` edges of a seed, across triangles that are gone, too: what lies
// around a hole belongs together.
std::vector<std::uint8_t> verticesNear(const Workpiece& piece, const VertexTriangles& around,
                                       std::span<const VertexId> seeds) {
  std::vector<std::uint8_t> near(piece.mesh.positions.size(), 0);
  std::vector<VertexId> front(seeds.begin(), seeds.end());
  for (const VertexId v : front) near[v] = 1;
  for (int edge = 0; edge < kEdges; ++edge) {
    std::vector<VertexId> next;
    for (const VertexId v : front)
      for (const TriangleId t : around.of(v))
        for (const VertexId w : piece.mesh.triangles[t])
          if (near[w] == 0) {
            near[w] = 1;
            next.push_back(w);
          }
    front = std::move(next);
  }
  return near;
}

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, TriangleId t) {
  Eigen::AlignedBox3d box;
  for (const VertexId v : mesh.triangles[t]) box.extend(mesh.positions[v]);
  return box;
}

// The seeds, and the corners of triangles whose boxes overlap those of triangles around them: what a wall
// without room runs into may be another sheet.
std::vector<VertexId> withThoseBeside(const Workpiece& piece, const VertexTriangles& around,
                                      std::span<const VertexId> seeds) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const VertexId v : seeds)
    for (const TriangleId t : around.of(v)) boxes.push_back(boxOf(piece.mesh, t));
  std::vector<VertexId> all(seeds.begin(), seeds.end());
  Eigen::AlignedBox3d hull;
  for (const auto& box : boxes) hull.extend(box);
  for (TriangleId t = 0; t < piece.mesh.triangles.size(); ++t) {
    if (piece.present[t] == 0) continue;
    const Eigen::AlignedBox3d own = boxOf(piece.mesh, t);
    if (!own.intersects(hull)) continue;
    if (std::any_of(boxes.begin(), boxes.end(), [&](const auto& box) { return own.intersects(box); }))
      all.insert(all.end(), piece.mesh.triangles[t].begin(), piece.mesh.triangles[t].end());
  }
  return all;
}

}  // namespace

Patch patchAround(const Workpiece& piece, const VertexTriangles& around, std::span<const VertexId> seeds) {
  const std::vector<std::uint8_t> near = verticesNear(piece, around, withThoseBeside(piece, around, seeds));
  const std::size_t count = piece.mesh.triangles.size();
  Workpiece part = piece;
  for (TriangleId t = 0; t < count; ++t) {
    const Triangle& c = piece.mesh.triangles[t];
    part.present[t] &=
        static_cast<std::uint8_t>(std::all_of(c.begin(), c.end(), [&](VertexId v) { return near[v] != 0; }));
  }
  openNonManifoldVertices(part, around);  // cutting out may leave parts that touch in a point only
  const std::vector<std::uint8_t>& inside = part.present;
  std::vector<std::uint8_t> whole(piece.mesh.positions.size(), 1);
  for (TriangleId t = 0; t < count; ++t)
    if (piece.present[t] != 0 && inside[t] == 0)
      for (const VertexId v : piece.mesh.triangles[t]) whole[v] = 0;
  Patch patch;
  std::vector<VertexId> id(piece.mesh.positions.size(), kNone);
  for (TriangleId t = 0; t < count; ++t) {
    if (inside[t] == 0) continue;
    Triangle corners{};
    for (int k = 0; k < 3; ++k) {
      const VertexId v = piece.mesh.triangles[t][k];
      if (id[v] == kNone) {
        id[v] = static_cast<VertexId>(patch.mesh.positions.size());
        patch.mesh.positions.push_back(piece.mesh.positions[v]);
        patch.vertex.push_back(v);
        patch.whole.push_back(whole[v]);
      }
      corners[k] = id[v];
    }
    patch.mesh.triangles.push_back(corners);
  }
  return patch;
}

}  // namespace thicken::repairing
