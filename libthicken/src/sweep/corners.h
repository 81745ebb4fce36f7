// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exact corners of a mitred shell. Where more than three planes meet at a vertex of S, their copies at depth
// r have no common point in general. A single offset vertex is then off some of them, and tilts every
// triangle around it as far as it reaches. Here the vertex gets several offset vertices instead, each in
// three of the planes, joined by edges in two of them: all triangles of S stay parallel to their copies.
// Where no such corner is clear, and where a copy must be drawn back, edges around it get a copy of their own
// nearby, so that only small triangles are off.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "sweep/direction.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

class Corners {
 public:
  /// Of the copies of `mesh`; `faceNormal`, `around`: of S, `plane`: of its triangles, for each shell. All
  /// must outlive this.
  Corners(SweptMesh& mesh, std::span<const Vec3> faceNormal, std::span<const std::vector<OffsetPlane>> plane,
          const mesh::VertexTriangles& around);
  ~Corners();

  /// Divides the copies that are off from a plane around them by more than `tolerance` · r, or cuts the
  /// corner off. Each copied triangle is a polygon that is not folded over, and no more triangles meet than
  /// before. Copies beside others that were merged, divided or dropped stay, as do those that `single` marks,
  /// per vertex of S.
  void divide(double tolerance, std::span<const std::uint8_t> single);

  /// Puts one copy, as it was before, in the place of all that vertices of S got. Returns whether the
  /// triangles around all of them were still as they had been made; nothing has changed if not.
  [[nodiscard]] bool undo(std::span<const VertexId> vertices);

  /// Cuts the triangles around copies that were drawn back from `depth`, per copy.
  void cutShort(std::span<const double> depth);

  /// Takes the copies of triangles that changed since this was asked the last time, ascending.
  [[nodiscard]] std::vector<std::uint32_t> takeChanged();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thicken::sweep
