// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A closed manifold triangle mesh whose edges can be collapsed and turned. Triangles and vertices keep their
// ids. A triangle that is gone stays in the list, without extent.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::mesh {

class LinkedMesh {
 public:
  /// `triangles`, of so many vertices, must outlive this.
  LinkedMesh(std::size_t vertices, std::vector<Triangle>& triangles, int threads);

  /// Whether each edge has one triangle on either side, and each vertex one fan of triangles. If it is false,
  /// no other function may be called.
  [[nodiscard]] bool isClosedManifold() const;

  [[nodiscard]] bool isGone(TriangleId t) const { return gone_[t] != 0; }
  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  [[nodiscard]] TriangleId neighbour(TriangleId t, int edge) const { return neighbour_[t][edge]; }
  [[nodiscard]] int cornerOf(TriangleId t, VertexId v) const {
    const Triangle& c = triangles_[t];
    return c[0] == v ? 0 : c[1] == v ? 1 : 2;
  }

  /// The triangles around a vertex in order, into `star`.
  void starOf(VertexId v, std::vector<TriangleId>& star) const;

  /// Whether the mesh stays manifold, and no part of it vanishes, when the edge between two vertices with
  /// these stars is collapsed (the link condition).
  [[nodiscard]] bool canCollapse(VertexId keep, VertexId go, const std::vector<TriangleId>& starOfKeep,
                                 const std::vector<TriangleId>& starOfGo);

  /// Collapses an edge: its two triangles are gone, and the others of `starOfGo` have `keep` for `go`.
  void collapse(VertexId keep, VertexId go, const std::vector<TriangleId>& starOfGo);

  /// What the two triangles on either side of the edge from corner `edge` of `t` become when it is turned to
  /// join their other corners: that of `t` first. That corner is the third of both.
  [[nodiscard]] std::array<Triangle, 2> turned(TriangleId t, int edge) const;
  /// Whether the mesh stays manifold when that edge is turned: no such edge is there yet.
  [[nodiscard]] bool canTurn(TriangleId t, int edge) const;
  void turn(TriangleId t, int edge);

 private:
  void replaceNeighbour(TriangleId of, TriangleId from, TriangleId to);
  [[nodiscard]] std::size_t valence(VertexId v, std::size_t most) const;

  std::vector<Triangle>& triangles_;
  std::vector<std::array<TriangleId, 3>> neighbour_;  // across the edge from corner k to corner k + 1
  std::vector<TriangleId> any_;                       // per vertex: a triangle around it
  std::vector<std::uint8_t> gone_;
  std::vector<VertexId> link_;  // scratch
};

}  // namespace thicken::mesh
