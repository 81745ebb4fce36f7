// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Small meshes of known properties for tests.
#pragma once

#include <cmath>
#include <utility>

#include "mesh/topology.h"
#include "thicken/mesh.h"

namespace thicken::shapes {

/// A bumpy sheet of 2 · columns · rows triangles over cells of 1 mm, facing up. Vertex (x, y) has the id
/// y · (columns + 1) + x; cell (x, y) has the triangles 2 · (y · columns + x) and the one after.
inline TriangleMesh sheet(VertexId columns, VertexId rows) {
  TriangleMesh mesh;
  for (VertexId y = 0; y <= rows; ++y)
    for (VertexId x = 0; x <= columns; ++x)
      mesh.positions.emplace_back(x, y, 0.3 * std::sin(1.7 * x) * std::cos(1.1 * y));
  for (VertexId y = 0; y < rows; ++y) {
    for (VertexId x = 0; x < columns; ++x) {
      const VertexId a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// A sheet() with all of it at one height.
inline TriangleMesh flatSheet(VertexId columns, VertexId rows, double z) {
  TriangleMesh mesh = sheet(columns, rows);
  for (Vec3& p : mesh.positions) p.z() = z;
  return mesh;
}

/// The solid between a sheet and its copy `depth` below: first the sheet, then the copy's triangles,
/// then two wall triangles for each rim edge.
inline TriangleMesh slab(const TriangleMesh& sheet, double depth) {
  TriangleMesh solid = sheet;
  const auto copies = static_cast<VertexId>(sheet.positions.size());
  for (const Vec3& p : sheet.positions) solid.positions.push_back(p - Vec3(0, 0, depth));
  for (const Triangle& t : sheet.triangles)
    solid.triangles.push_back({copies + t[0], copies + t[2], copies + t[1]});
  for (const mesh::RimEdge& e : mesh::rimOf(sheet.positions.size(), sheet.triangles).edges) {
    solid.triangles.push_back({e.to, e.from, copies + e.from});
    solid.triangles.push_back({e.to, copies + e.from, copies + e.to});
  }
  return solid;
}

inline TriangleMesh box(const Vec3& low, const Vec3& high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) ? high[0] : low[0], (i & 2) ? high[1] : low[1],
                                (i & 4) ? high[2] : low[2]);
  mesh.triangles = {{0, 3, 1}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 7, 3}, {2, 6, 7}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

inline TriangleMesh reversed(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Both meshes as one, side by side in its lists.
inline TriangleMesh together(TriangleMesh mesh, const TriangleMesh& other) {
  const auto first = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const Triangle& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  return mesh;
}

/// A flat strip closed to a ring with a half turn: one-sided.
inline TriangleMesh moebius(VertexId segments) {
  constexpr double kFullTurn = 6.28318530717958647692;
  TriangleMesh mesh;
  for (VertexId i = 0; i < segments; ++i) {
    const double turn = kFullTurn * i / segments;
    const Vec3 out(std::cos(turn), std::sin(turn), 0);
    const Vec3 across = std::cos(turn / 2) * out + std::sin(turn / 2) * Vec3(0, 0, 1);
    for (const double side : {-0.3, 0.3}) mesh.positions.push_back(out + side * across);
  }
  for (VertexId i = 0; i < segments; ++i) {
    const VertexId a = 2 * i, b = a + 1;
    const bool last = i + 1 == segments;
    const VertexId c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    mesh.triangles.push_back({a, c, d});
    mesh.triangles.push_back({a, d, b});
  }
  return mesh;
}

}  // namespace thicken::shapes
