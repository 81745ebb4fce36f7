// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Corners of rims that are about to become one, and corners that are about to divide edges of other rims.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh/topology.h"
#include "repair/divided_triangle.h"
#include "repair/ledger.h"
#include "repair/rims.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// Each step is taken whole, or not at all: where a triangle or a part of one would turn over or lose its
/// area (exact), or an edge would get a third triangle. The workpiece changes with apply() only.
class SeamGroups {
 public:
  explicit SeamGroups(Workpiece& piece);

  [[nodiscard]] const Rims& rims() const { return rims_; }
  /// Rim edges, or parts of divided ones, that have become one with another.
  [[nodiscard]] std::size_t joinedEdges() const { return joinedEdges_; }
  /// The vertex that a stop's becomes.
  [[nodiscard]] VertexId groupOf(std::uint32_t stop) const { return onto_[rims_.stop(stop).vertex]; }

  /// Whether the stop is joined to another.
  [[nodiscard]] bool isAnchor(std::uint32_t stop) const { return stops_[groupOf(stop)].size() > 1; }

  /// The triangle with the corners that its own become.
  [[nodiscard]] Triangle cornersOf(TriangleId t) const {
    Triangle c = piece_.mesh.triangles[t];
    for (VertexId& v : c) v = onto_[v];
    return c;
  }

  /// The ends of the whole rim edge of a slot, as they were.
  [[nodiscard]] std::pair<VertexId, VertexId> endsOf(std::uint32_t slot) const {
    const Triangle& c = piece_.mesh.triangles[slot / 3];
    return {c[slot % 3], c[(slot % 3 + 1) % 3]};
  }

  /// Whether the rim on either side of the stop is not joined.
  [[nodiscard]] bool isOpen(std::uint32_t stop) const {
    const auto& spans = rims_.stop(stop).spans;
    return !rims_.span(spans[0]).joined || !rims_.span(spans[1]).joined;
  }

  [[nodiscard]] bool groupIsOpen(VertexId group) const {
    return std::any_of(stops_[group].begin(), stops_[group].end(),
                       [&](std::uint32_t s) { return isOpen(s); });
  }

  [[nodiscard]] std::array<std::uint32_t, 2> slotsAt(std::uint32_t stop) const {
    const auto& spans = rims_.stop(stop).spans;
    return {rims_.span(spans[0]).slot, rims_.span(spans[1]).slot};
  }

  [[nodiscard]] VertexId onto(VertexId v) const { return onto_[v]; }
  [[nodiscard]] std::size_t stopsIn(VertexId group) const { return stops_[group].size(); }
  /// Whether a corner of the group divides the edge of the slot.
  [[nodiscard]] bool divides(VertexId group, std::uint32_t slot) const;
  /// The spans of a rim edge, those nearest to p first.
  [[nodiscard]] std::vector<std::uint32_t> spansOf(std::uint32_t slot, const Vec3& p) const;

  /// Makes one group of two; no vertex moves farther than `distance` mm.
  bool moveGroup(VertexId from, VertexId to, double distance);
  /// Divides a span at the corner of a stop.
  bool divideAt(std::uint32_t stop, std::uint32_t span);
  void apply(Ledger& ledger);

 private:
  [[nodiscard]] std::vector<Triangle> partsOfTriangle(TriangleId t);
  [[nodiscard]] std::vector<TriangleId> trianglesAt(VertexId group) const;
  [[nodiscard]] bool crowds(VertexId group) const;
  void closeAt(VertexId group);
  [[nodiscard]] std::ptrdiff_t placeOf(std::uint32_t span) const;

  Workpiece& piece_;
  const std::vector<Vec3>& at_;
  mesh::VertexTriangles around_;
  Rims rims_;
  std::vector<VertexId> onto_;                     // per vertex: the one that it becomes
  std::vector<std::vector<VertexId>> vertices_;    // per vertex that stays: those that become it
  std::vector<std::vector<std::uint32_t>> stops_;  // the same: the stops there
  std::unordered_map<std::uint32_t, std::vector<VertexId>> inserted_;  // by slot, in the order of its edge
  std::unordered_map<std::uint32_t, std::uint32_t> spanOfSlot_;        // its first span
  std::unordered_map<TriangleId, Facing> facing_;
  std::size_t joinedEdges_ = 0;
};

}  // namespace thicken::repairing
