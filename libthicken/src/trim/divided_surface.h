// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A surface whose triangles are divided at new vertices, one after the other. Vertices never move, and
// triangles that nothing divides keep their ids and corners.
#pragma once

#include <array>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "mesh/topology.h"
#include "thicken/mesh.h"

namespace thicken::trimming {

/// A piece of a triangle has no area once its corners are rounded, or faces the other way.
struct TooNarrow : std::runtime_error {
  explicit TooNarrow(const Vec3& at);
  Vec3 place;
};

/// Edge `corner` of a triangle leads from that corner to the next.
struct EdgeOf {
  TriangleId triangle = mesh::kNone;
  int corner = 0;
};

class DividedSurface {
 public:
  /// `surface` has to be manifold, oriented and without degenerate triangles.
  DividedSurface(const TriangleMesh& surface, int threads);

  [[nodiscard]] const Vec3& at(VertexId v) const { return positions_[v]; }
  [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] TriangleId across(const EdgeOf& e) const { return across_[e.triangle][e.corner]; }
  [[nodiscard]] VertexId from(const EdgeOf& e) const { return triangles_[e.triangle][e.corner]; }
  [[nodiscard]] VertexId to(const EdgeOf& e) const { return triangles_[e.triangle][(e.corner + 1) % 3]; }
  [[nodiscard]] VertexId opposite(const EdgeOf& e) const {
    return triangles_[e.triangle][(e.corner + 2) % 3];
  }
  /// The same edge, of the triangle across; none on the rim.
  [[nodiscard]] EdgeOf twin(const EdgeOf& e) const;

  /// The triangle of the surface that `t` is, or is a piece of.
  [[nodiscard]] TriangleId originOf(TriangleId t) const;
  /// The pieces of a triangle of the surface: itself where nothing divides it.
  [[nodiscard]] std::vector<TriangleId> piecesOf(TriangleId original) const;
  [[nodiscard]] bool isDivided(TriangleId original) const { return pieces_.count(original) != 0; }

  /// For every triangle around `v` the edge opposite to `v`.
  [[nodiscard]] std::vector<EdgeOf> linkOf(VertexId v) const;
  /// The edge between two vertices, in either direction; none where there is none.
  [[nodiscard]] EdgeOf edgeBetween(VertexId a, VertexId b) const;

  /// Divide a triangle in three, and the triangles at an edge in two each, at a new vertex. Throw TooNarrow,
  /// and must not be used after that.
  VertexId divideTriangle(TriangleId t, const Vec3& p);
  VertexId divideEdge(const EdgeOf& e, const Vec3& p);

 private:
  VertexId addVertex(const Vec3& p, TriangleId t);
  TriangleId addPieceOf(TriangleId t);
  void relink(TriangleId neighbour, TriangleId before, TriangleId now);
  void requireArea(TriangleId t) const;

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<TriangleId, 3>> across_;
  std::vector<TriangleId> triangleAt_;  // of each vertex, one triangle
  std::size_t originals_;
  std::vector<TriangleId> originOfAdded_;
  struct Whole {
    Vec3 normal;
    std::vector<TriangleId> pieces;
  };
  std::unordered_map<TriangleId, Whole> pieces_;  // of divided triangles
};

}  // namespace thicken::trimming
