// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The way between two vertices of a surface along its cut with a plane.
#pragma once

#include <unordered_map>
#include <vector>

#include "mesh/edge_key.h"
#include "trim/divided_surface.h"

namespace thicken::trimming {

/// Vertices and edges of the divided surface that paths lead along, with the loop that each belongs to.
class PathMarks {
 public:
  void addVertex(VertexId v, std::size_t loop) { loopOf_.try_emplace(v, loop); }
  void addEdge(VertexId a, VertexId b) { edges_.insert(mesh::edgeKey(a, b)); }
  [[nodiscard]] bool hasVertex(VertexId v) const { return loopOf_.count(v) != 0; }
  [[nodiscard]] bool hasEdge(VertexId a, VertexId b) const { return edges_.count(mesh::edgeKey(a, b)) != 0; }
  [[nodiscard]] std::size_t loopOf(VertexId v) const { return loopOf_.at(v); }

 private:
  std::unordered_map<VertexId, std::size_t> loopOf_;
  mesh::EdgeSet edges_;
};

/// A corner of a way: a vertex, or the point `place` of the edge between two vertices.
struct WayPoint {
  VertexId vertex = mesh::kNone;
  std::array<VertexId, 2> edge{mesh::kNone, mesh::kNone};
  Vec3 place = Vec3::Zero();  ///< exact to the precision of double
};

enum class WayEnd {
  kArrived,
  kLeaves,   ///< the surface, at its rim
  kCrosses,  ///< a path
  kTouches,  ///< a path
  kStrays,   ///< leads elsewhere, or goes a long way around
};

struct Way {
  std::vector<WayPoint> points;  ///< without the first vertex
  WayEnd end = WayEnd::kStrays;
  Vec3 place = Vec3::Zero();   ///< where it ended
  VertexId met = mesh::kNone;  ///< with kCrosses and kTouches: a vertex of that path
};

/// Follows the cut of `surface` with the plane through `from` and `to` along `up`, from `from` towards `to`.
/// An edge is passed at its end where the cut comes within `tolerance` of that. Changes nothing.
[[nodiscard]] Way planeCut(const DividedSurface& surface, const PathMarks& marks, VertexId from, VertexId to,
                           const Vec3& up, double tolerance);

}  // namespace thicken::trimming
