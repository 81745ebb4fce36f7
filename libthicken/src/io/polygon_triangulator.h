// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Splits polygons, convex or not, into triangles without new vertices: the ears of the polygon's
// projection along the main axis of its normal (exact predicates, no coordinate is rounded) are
// cut off, the shortest cut first.
#pragma once

#include <span>
#include <vector>

#include "io/corner_grid.h"
#include "thicken/mesh.h"

namespace thicken::io {

class PolygonTriangulator {
 public:
  /// `positions` of the polygons' vertices; must stay alive.
  explicit PolygonTriangulator(std::span<const Vec3> positions) : positions_(positions) {}

  /// Appends corners − 2 triangles of the polygon's sense. None of them is degenerate or overlaps
  /// another one when the projected polygon is simple. Others, which check() refuses later, are split
  /// anyhow. Returns false for a polygon that would take unreasonably long. Cost: O(n log n) for
  /// what drawings hold, O(n^1.5) else.
  [[nodiscard]] bool append(std::span<const VertexId> polygon, std::vector<Triangle>& triangles);

 private:
  // Which corners may be cut. Each is less choosy than the one before and follows on it when no
  // corner is left that passes, which happens only for polygons that are not simple.
  enum class Rule { kEmptyEar, kAlmostEmptyEar, kConvex, kAny };

  struct Cut {
    double squaredLength;
    std::uint32_t previous, corner, next;
    // The heap has the largest on top.
    bool operator<(const Cut& other) const {
      return squaredLength != other.squaredLength ? squaredLength > other.squaredLength
                                                  : corner > other.corner;
    }
  };

  void appendQuad(std::span<const VertexId> quad, std::vector<Triangle>& triangles);
  [[nodiscard]] bool project(std::span<const VertexId> polygon);
  void prepareCorners();
  void offer(std::uint32_t corner);
  void offerAll(std::uint32_t from);
  void clearWay(std::uint32_t corner);
  [[nodiscard]] bool passes(const Cut& cut, Rule rule);
  [[nodiscard]] bool blocks(const Cut& cut, std::uint32_t corner, bool borderToo) const;
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  void link(std::uint32_t previous, std::uint32_t next);

  std::span<const Vec3> positions_;
  std::uint64_t work_ = 0;  // grid cells and corners looked at so far, over all polygons

  // Of the polygon at hand, by corner:
  std::vector<Vec3> points_;  // counter-clockwise after projection to x, y
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint8_t> reflex_;  // still there, and not strictly convex
  std::vector<Cut> heap_;
  CornerGrid grid_;
};

}  // namespace thicken::io
