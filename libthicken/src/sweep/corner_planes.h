// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The offset vertices that can take the place of one: each is where three of the planes around a vertex of S
// meet at depth r. The planes, in their order around the vertex, are the corners of a polygon, and each
// triangulation of it is a set of such points: a triangle is a point in three planes, a chord an edge in two.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sweep/direction.h"
#include "thicken/mesh.h"

namespace thicken::sweep {

/// The triangles around a vertex v, in their order: triangle i is (v, ring i, ring i + 1).
struct Fan {
  std::vector<TriangleId> triangle;
  std::vector<VertexId> ring;  ///< one more than triangles on the rim
  [[nodiscard]] bool isClosed() const { return ring.size() == triangle.size(); }
};

/// The fan of the triangles `around` a vertex; empty where they are no single fan.
[[nodiscard]] Fan fanOf(std::span<const Triangle> triangles, std::span<const TriangleId> around, VertexId v);

/// How far an offset vertex is off a plane, in r.
[[nodiscard]] double offFrom(const OffsetPlane& plane, const Vec3& m);

/// Offset vertices in the place of one. At depth r, vertex i is at r · m[i] from the vertex of S.
struct Corner {
  std::vector<Vec3> m;
  std::vector<std::vector<int>>
      chain;  ///< per triangle of the fan: its vertices, from the next triangle to the last
};

/// Planes of a fan with almost equal normals count as one. There are at most kMostPlanes: those that differ
/// least are merged. A polygon of eight corners has 132 triangulations.
constexpr std::size_t kMostPlanes = 8;

using PlaneTriple = std::array<int, 3>;               ///< of planes, ascending
using PlaneTriangulation = std::vector<PlaneTriple>;  ///< of the polygon whose corners the planes are

/// Makes the corners that a vertex can have.
class CornerMaker {
 public:
  /// `plane` per triangle of S. `single`: m of the offset vertex that the corners are to replace. `fan` and
  /// `plane` must outlive this.
  CornerMaker(const Fan& fan, std::span<const OffsetPlane> plane, const Vec3& single);

  /// The triangulations all of whose points exist, those first whose points are nearest to the single one.
  [[nodiscard]] std::vector<const PlaneTriangulation*> candidates();

  /// The corner that a candidate makes; points less than 0.01 r apart are one.
  [[nodiscard]] Corner corner(const PlaneTriangulation& t);

  /// The largest distance of a vertex of a corner from a plane that it is on, as a share of r.
  [[nodiscard]] double errorOf(const Corner& corner) const;

 private:
  /// Neighbours in a fan that one plane stands for.
  struct Plane {
    Vec3 normal = Vec3::Zero();
    double way = 1;                    ///< OffsetPlane
    std::size_t first = 0, count = 0;  ///< of the fan's triangles, cyclic
  };

  [[nodiscard]] static std::vector<Plane> planesOf(const Fan& fan, std::span<const OffsetPlane> plane);
  [[nodiscard]] std::optional<Vec3> meetingPoint(const PlaneTriple& t) const;
  const std::optional<Vec3>& pointOf(const PlaneTriple& t);
  [[nodiscard]] Corner cornerOf(const PlaneTriangulation& t, const std::vector<Vec3>& m) const;
  [[nodiscard]] std::vector<std::size_t> trianglesAt(const PlaneTriangulation& t, int corner) const;
  void share(const Plane& plane, const std::vector<int>& chain, Corner& corner) const;

  const Fan& fan_;
  std::span<const OffsetPlane> plane_;
  Vec3 single_;
  std::vector<Plane> planes_;
  static constexpr std::size_t kTriples = kMostPlanes * kMostPlanes * kMostPlanes;
  std::array<std::optional<Vec3>, kTriples> points_;  ///< where three planes meet, as far as asked for
  std::array<std::uint8_t, kTriples> known_{};
};

}  // namespace thicken::sweep
