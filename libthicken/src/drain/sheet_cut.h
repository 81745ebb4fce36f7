// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Cuts a convex outline out of a sheet: the part of a mesh that can be seen along an axis through the
// outline. The outline's corners are inserted into the triangles and its sides along them, as edges
// that both neighbours share, so that nothing has to be sewn afterwards.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#include "mesh/topology.h"
#include "thicken/mesh.h"

namespace thicken::drain {

/// Why a hole cannot be made in one way; another may do.
struct CannotCut : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// As before, and turning or shifting the outline a little will not help.
struct TooSteep : CannotCut {
  using CannotCut::CannotCut;
};

/// A right-handed frame whose third axis is the axis of the hole.
struct Frame {
  Vec3 origin, u, v, w;
  Frame(const Vec3& at, const Vec3& axis);
  /// Coordinates in the frame, mm.
  [[nodiscard]] Vec3 local(const Vec3& p) const {
    const Vec3 q = p - origin;
    return {q.dot(u), q.dot(v), q.dot(w)};
  }
  [[nodiscard]] Vec3 global(const Vec3& q) const { return origin + q[0] * u + q[1] * v + q[2] * w; }
};

/// What a cut leaves.
struct SheetCut {
  std::vector<TriangleId> replaced;          ///< triangles of the mesh that are gone
  std::vector<Triangle> around;              ///< what stands for them, outside of the outline
  std::vector<std::vector<VertexId>> sides;  ///< per side k: the vertices from corner k to corner k + 1
  double lowest = 0, highest = 0;            ///< of the outline's vertices along the axis
};

class SheetCutter {
 public:
  /// `positions` grows by the new vertices, which hold float values. `corners` are the outline in the
  /// frame's first two coordinates, counter-clockwise. `upward`: the sheet's normals have a positive
  /// component along the axis. Throws CannotCut.
  SheetCutter(std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
              const std::vector<std::array<TriangleId, 3>>& across, const Frame& frame,
              const std::vector<Vec3>& corners, bool upward);

  /// Cuts the sheet that the triangle `start`, which the outline's middle lies on, belongs to.
  [[nodiscard]] SheetCut cut(TriangleId start);

 private:
  void gather(TriangleId start, SheetCut& result);
  [[nodiscard]] bool touchesOutline(const Triangle& t) const;
  const Vec3& at(VertexId v);
  [[nodiscard]] double area(VertexId a, VertexId b, VertexId c);
  VertexId addVertex(const Vec3& local);
  VertexId insertCorner(const Vec3& corner);
  void splitTriangle(std::size_t index, VertexId v);
  void splitEdge(VertexId a, VertexId b, VertexId v);
  void replace(std::size_t index, const Triangle& t);
  void append(const Triangle& t);
  void requirePositive(const Triangle& t);
  [[nodiscard]] bool hasEdge(VertexId a, VertexId b) const;
  std::vector<VertexId> walk(VertexId from, VertexId to);
  VertexId step(VertexId from, VertexId to);
  void removeInside(const std::vector<VertexId>& loop, SheetCut& result);

  std::vector<Vec3>& positions_;
  const std::vector<Triangle>& triangles_;
  const std::vector<std::array<TriangleId, 3>>& across_;
  const Frame& frame_;
  std::vector<Vec3> corners_;  // mirrored where the sheet faces against the axis
  double mirror_;
  double near_ = 0;  // mm; what is closer than this is the same
  std::vector<Triangle> patch_;
  std::unordered_map<VertexId, Vec3> local_;
};

}  // namespace thicken::drain
