// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The shape of a patch that closes a hole: divided to the size of what is around it, and faired.
// After Liepa, Filling Holes in Meshes, 2003.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/edge_key.h"
#include "thicken/mesh.h"

namespace thicken::repairing {

/// A patch inside a loop of vertices. Its own corners come after those of the surface.
class PatchShape {
 public:
  /// `triangles`: a triangulation of a loop. `size`: mm per vertex of the loop, the mean length of the edges
  /// there. `taken`: edges of the surface between vertices of the loop.
  PatchShape(std::vector<Vec3>& positions, std::vector<Triangle> triangles,
             const std::unordered_map<VertexId, double>& size, const mesh::EdgeSet& taken);

  /// Divides triangles that are large against `size`, at most until there are `most`, and turns edges until
  /// each is the shorter way between its triangles (Delaunay). Appends to the positions.
  void refine(std::size_t most);
  /// Moves the patch's own corners to where it goes on from the surface with the least change of bend.
  /// `beside`: per vertex of the loop those that it shares edges with outside of the patch.
  void fair(const std::unordered_map<VertexId, std::vector<VertexId>>& beside);

  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  [[nodiscard]] bool divideLarge(std::size_t most);
  void turnEdges();
  [[nodiscard]] bool turn(VertexId a, VertexId b, TriangleId t, TriangleId u);
  void mapEdges();
  [[nodiscard]] bool isOwn(VertexId v) const { return v >= firstOwn_; }

  std::vector<Vec3>& at_;
  std::vector<Triangle> triangles_;
  std::unordered_map<VertexId, double> size_;
  const mesh::EdgeSet& taken_;
  VertexId firstOwn_;
  std::unordered_map<std::uint64_t, std::array<TriangleId, 2>> edges_;  // the triangles at each edge
};

}  // namespace thicken::repairing
