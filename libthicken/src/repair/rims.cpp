// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/rims.h"

#include <algorithm>
#include <utility>

#include "mesh/half_edges.h"
#include "repair/fans.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::kNone;
using mesh::VertexTriangles;

namespace {

using RimEnd = std::pair<VertexId, std::uint32_t>;  // a vertex and a rim edge's span there

// The rim ends of one vertex in groups of those that belong to one fan.
std::vector<std::vector<std::uint32_t>> byFan(std::span<const RimEnd> ends, const std::vector<Span>& spans,
                                              const Workpiece& piece, const VertexTriangles& around) {
  std::vector<std::vector<std::uint32_t>> groups(1);
  for (const RimEnd& end : ends) groups[0].push_back(end.second);
  if (ends.size() == 2) return groups;
  const auto fans = fansAt(piece, around, ends.front().first);
  groups.assign(fans.size(), {});
  for (const RimEnd& end : ends)
    for (std::size_t f = 0; f < fans.size(); ++f)
      if (std::binary_search(fans[f].begin(), fans[f].end(), spans[end.second].slot / 3))
        groups[f].push_back(end.second);
  return groups;
}

}  // namespace

Rims::Rims(const Workpiece& piece, const VertexTriangles& around) {
  const TriangleMesh& mesh = piece.mesh;
  const mesh::HalfEdges edges(mesh.positions.size(), mesh.triangles, piece.present);
  std::vector<RimEnd> ends;
  edges.forEachEdge(
      [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
        if (uses.size() + back.size() != 1) return;
        const auto id = static_cast<std::uint32_t>(spans_.size());
        ends.emplace_back(a, id);
        ends.emplace_back(b, id);
        spans_.push_back({{kNone, kNone}, uses[0].slot, false});
      });
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0, j = 0; i < ends.size(); i = j) {
    const VertexId v = ends[i].first;
    while (j < ends.size() && ends[j].first == v) ++j;
    for (const auto& group : byFan(std::span(ends).subspan(i, j - i), spans_, piece, around)) {
      if (group.size() != 2) continue;
      const auto stop = static_cast<std::uint32_t>(stops_.size());
      stops_.push_back({v, {group[0], group[1]}});
      for (const std::uint32_t s : group) {
        const std::uint32_t slot = spans_[s].slot;
        spans_[s].stops[mesh.triangles[slot / 3][slot % 3] == v ? 0 : 1] = stop;
      }
    }
  }
}

std::uint32_t Rims::divide(std::uint32_t span, VertexId vertex) {
  const auto stop = static_cast<std::uint32_t>(stops_.size());
  const auto rest = static_cast<std::uint32_t>(spans_.size());
  const std::uint32_t end = spans_[span].stops[1];
  spans_.push_back({{stop, end}, spans_[span].slot, false});
  spans_[span].stops[1] = stop;
  stops_.push_back({vertex, {span, rest}});
  if (end != kNone)
    for (std::uint32_t& s : stops_[end].spans)
      if (s == span) {
        s = rest;
        break;
      }
  return stop;
}

}  // namespace thicken::repairing
