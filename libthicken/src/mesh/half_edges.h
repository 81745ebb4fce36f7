// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The directed edges of a triangle mesh of any kind, manifold or not, for look-up by their ends.
#pragma once

#include <span>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// One use of an edge by a triangle, in the triangle's direction. `slot` is 3 · triangle + corner.
struct HalfEdge {
  VertexId to;
  std::uint32_t slot;
  [[nodiscard]] TriangleId triangle() const { return slot / 3; }
  [[nodiscard]] std::uint32_t corner() const { return slot % 3; }
};

/// Built in O(n log n) even where one vertex or one edge has very many triangles.
class HalfEdges {
 public:
  /// `active[t] == 0` leaves triangle t out (empty span: all are in).
  HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles,
            std::span<const std::uint8_t> active = {}, int threads = 1);

  /// All uses of the edge in this direction, by ascending slot.
  [[nodiscard]] std::span<const HalfEdge> uses(VertexId from, VertexId to) const {
    constexpr std::size_t kFew = 16;
    const std::span<const HalfEdge> leaving = this->from(from);
    if (leaving.size() > kFew) return search(leaving, to);
    // One by one: a search by halves guesses wrong half of the time.
    std::size_t begin = 0, end = 0;
    for (const HalfEdge& e : leaving) {
      begin += e.to < to;
      end += e.to <= to;
    }
    return leaving.subspan(begin, end - begin);
  }

  /// All directed edges that leave a vertex, by ascending end, then slot.
  [[nodiscard]] std::span<const HalfEdge> from(VertexId v) const {
    return std::span(edges_).subspan(offset_[v], offset_[v + 1] - offset_[v]);
  }

  /// Calls visit(a, b, uses of ab, uses of ba) once for every undirected edge, ordered by a, then b.
  /// The edge ab is used at least once.
  template <class Visit>
  void forEachEdge(Visit visit) const {
    for (VertexId a = 0; a + 1 < offset_.size(); ++a) forEachEdgeOf(a, visit);
  }

  /// The part of forEachEdge() that belongs to `a`.
  template <class Visit>
  void forEachEdgeOf(VertexId a, Visit& visit) const {
    const std::span<const HalfEdge> leaving = from(a);
    for (std::size_t i = 0, j = 0; i < leaving.size(); i = j) {
      const VertexId b = leaving[i].to;
      while (j < leaving.size() && leaving[j].to == b) ++j;
      const std::span<const HalfEdge> back = uses(b, a);
      if (a < b || back.empty()) visit(a, b, leaving.subspan(i, j - i), back);
    }
  }

 private:
  [[nodiscard]] static std::span<const HalfEdge> search(std::span<const HalfEdge> leaving, VertexId to);

  std::vector<std::uint32_t> offset_;
  std::vector<HalfEdge> edges_;
};

}  // namespace thicken::mesh
