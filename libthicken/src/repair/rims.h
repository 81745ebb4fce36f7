// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The rims of a surface under repair as chains of stops and spans, which corners of other rims can divide.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// A corner on a rim: one fan of triangles at a vertex. Where parts touch in a point only, a vertex has
/// several.
struct Stop {
  VertexId vertex = mesh::kNone;
  std::array<std::uint32_t, 2> spans{mesh::kNone, mesh::kNone};
};

/// The part of a rim edge between two stops, in the direction of its triangle. `stops` may hold kNone,
/// where the rim branches.
struct Span {
  std::array<std::uint32_t, 2> stops{mesh::kNone, mesh::kNone};
  std::uint32_t slot = 0;  ///< 3 · triangle + corner of the whole rim edge
  bool joined = false;     ///< another rim has the same two ends now
};

class Rims {
 public:
  Rims(const Workpiece& piece, const mesh::VertexTriangles& around);

  [[nodiscard]] std::size_t stopCount() const { return stops_.size(); }
  [[nodiscard]] const Stop& stop(std::uint32_t s) const { return stops_[s]; }
  [[nodiscard]] const Span& span(std::uint32_t s) const { return spans_[s]; }
  [[nodiscard]] std::size_t spanCount() const { return spans_.size(); }
  void setJoined(std::uint32_t span) { spans_[span].joined = true; }
  /// The stop at the other end of a span.
  [[nodiscard]] std::uint32_t across(std::uint32_t span, std::uint32_t stop) const {
    const auto& ends = spans_[span].stops;
    return ends[0] == stop ? ends[1] : ends[0];
  }
  /// The span at `stop` that is not `span`.
  [[nodiscard]] std::uint32_t onward(std::uint32_t stop, std::uint32_t span) const {
    const auto& s = stops_[stop].spans;
    return s[0] == span ? s[1] : s[0];
  }
  /// Puts a stop at `vertex` between the ends of a span, which keeps its first end. Returns the stop.
  std::uint32_t divide(std::uint32_t span, VertexId vertex);

  /// Calls visit(stop, length of the rim from `stop` to it) for the stops along the rim on the side of
  /// stop's span `side`, until it returns false, the rim ends, or it comes back.
  template <class Visit>
  void walk(const Workpiece& piece, std::uint32_t stop, int side, Visit visit) const {
    double length = 0;
    std::uint32_t at = stop, span = stops_[stop].spans[side];
    for (int step = 0; step < kMostSteps && span != mesh::kNone; ++step) {
      const std::uint32_t to = across(span, at);
      if (to == mesh::kNone || to == stop) return;
      length += (piece.mesh.positions[stops_[at].vertex] - piece.mesh.positions[stops_[to].vertex]).norm();
      if (!visit(to, length)) return;
      span = onward(to, span);
      at = to;
    }
  }

 private:
  // Farther along a rim nothing is looked for: neighbours on a seam are near each other.
  static constexpr int kMostSteps = 256;

  std::vector<Stop> stops_;
  std::vector<Span> spans_;
};

}  // namespace thicken::repairing
