// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Connectivity of a triangle mesh, as flat arrays: which triangles use an edge, which edges form
// the rim, which triangles surround a vertex.
#pragma once

#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::mesh {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Triangles around each vertex: those of v are `triangles[offset[v]] … triangles[offset[v + 1] − 1]`,
/// ascending.
struct VertexTriangles {
  std::vector<std::uint32_t> offset;
  std::vector<TriangleId> triangles;
  [[nodiscard]] std::span<const TriangleId> of(VertexId v) const {
    return std::span(triangles).subspan(offset[v], offset[v + 1] - offset[v]);
  }
};
[[nodiscard]] VertexTriangles vertexTriangles(std::size_t vertexCount, std::span<const Triangle> triangles,
                                              int threads = 1);

/// Neighbour of each triangle across its edge k (from corner k to corner k + 1): the triangle that
/// uses the edge in the other direction, or kNone on the rim. Requires an edge-manifold, oriented mesh.
[[nodiscard]] std::vector<std::array<TriangleId, 3>> neighbours(std::size_t vertexCount,
                                                                std::span<const Triangle> triangles,
                                                                int threads = 1);

/// One use of an edge by a triangle without an opposite use, in the triangle's direction.
struct RimEdge {
  VertexId from, to;
  TriangleId triangle;
};
/// All rim edges in rim order, loop after loop (each loop starts at its smallest vertex, loops by
/// that vertex); `loopStart` has one entry a loop and the total count at its end. Requires a valid surface.
struct Rim {
  std::vector<RimEdge> edges;
  std::vector<std::uint32_t> loopStart;
  [[nodiscard]] std::size_t loops() const { return loopStart.size() - 1; }
};
[[nodiscard]] Rim rimOf(std::size_t vertexCount, std::span<const Triangle> triangles, int threads = 1);

/// Component number of each triangle (connected through shared vertices), numbered by first triangle.
struct Components {
  std::vector<std::uint32_t> ofTriangle;
  std::uint32_t count = 0;
};
[[nodiscard]] Components componentsOf(std::size_t vertexCount, std::span<const Triangle> triangles,
                                      int threads = 1);

}  // namespace thicken::mesh
