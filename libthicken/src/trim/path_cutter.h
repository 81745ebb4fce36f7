// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Divides a surface along closed lines through given points.
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "thicken/closest_point.h"
#include "thicken/error.h"
#include "thicken/trim.h"
#include "trim/divided_surface.h"
#include "trim/plane_cut.h"

namespace thicken::trimming {

/// The surface and what finds places on it; the same for any number of lines.
struct Ground {
  const TriangleMesh& surface;
  ClosestPointTree tree;
  DividedSurface whole;  ///< nothing divided yet
  double floatStep;      ///< mm, the distance of neighbouring floats at the farthest coordinate
  double diagonal;       ///< mm, of the bounding box

  Ground(const TriangleMesh& surface, int threads);
};

/// A path along edges of the divided surface.
struct CutPath {
  std::vector<VertexId> vertices;  ///< the first is not repeated where it is closed
  TrimFacts::Loop facts;
};

class PathCutter {
 public:
  /// Corners of paths that are within `tolerance` mm of a vertex are moved onto it.
  PathCutter(const Ground& ground, double tolerance);

  /// Throws Error(kInvalidArgument), and TooNarrow where pieces of triangles would be too small for floats.
  CutPath cut(std::span<const Vec3> points, bool closed);

  [[nodiscard]] const DividedSurface& surface() const { return surface_; }
  [[nodiscard]] const PathMarks& marks() const { return marks_; }
  [[nodiscard]] double deviation() const { return deviation_; }
  /// The piece that holds the closest point of the surface to `p`.
  [[nodiscard]] TriangleId pieceAt(const Vec3& p) const;

 private:
  VertexId place(const ClosestPoint& c);
  VertexId placePoint(const Vec3& p, double& farthest);
  [[nodiscard]] TriangleId pieceOf(const ClosestPoint& c) const;
  void connect(VertexId from, VertexId to, int depth, std::vector<VertexId>& path);
  void divideAlong(const Way& way, VertexId from, std::vector<VertexId>& path);
  VertexId moved(VertexId v, const Vec3& exact);
  [[nodiscard]] Error blocked(const Way& way, VertexId from, VertexId to) const;

  const Ground& ground_;
  DividedSurface surface_;
  PathMarks marks_;
  std::unordered_map<VertexId, Vec3> normalAt_;  // of the vertices that paths are led through
  double tolerance_;
  double deviation_ = 0;
  std::size_t loop_ = 0;
};

/// `points` with `rounds` times as many points between, on a smooth curve through them.
[[nodiscard]] TrimLoop smoothed(std::span<const Vec3> points, bool closed, int rounds);

}  // namespace thicken::trimming
