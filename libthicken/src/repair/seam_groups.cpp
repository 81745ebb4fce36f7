// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/seam_groups.h"

#include <map>
#include <numeric>

#include "mesh/sort_unique.h"
#include "repair/near_rim.h"

namespace thicken::repairing {

using mesh::kNone;
using mesh::sortUnique;

SeamGroups::SeamGroups(Workpiece& piece)
    : piece_(piece),
      at_(piece.mesh.positions),
      around_(mesh::vertexTriangles(at_.size(), piece.mesh.triangles)),
      rims_(piece, around_),
      onto_(at_.size()),
      vertices_(at_.size()),
      stops_(at_.size()) {
  std::iota(onto_.begin(), onto_.end(), 0u);
  for (std::uint32_t s = 0; s < rims_.stopCount(); ++s) {
    const VertexId v = rims_.stop(s).vertex;
    vertices_[v] = {v};
    stops_[v].push_back(s);
  }
  for (std::uint32_t s = 0; s < rims_.spanCount(); ++s) spanOfSlot_[rims_.span(s).slot] = s;
}

bool SeamGroups::divides(VertexId group, std::uint32_t slot) const {
  const auto found = inserted_.find(slot);
  return found != inserted_.end() && std::any_of(found->second.begin(), found->second.end(),
                                                 [&](VertexId v) { return onto_[v] == group; });
}

std::vector<Triangle> SeamGroups::partsOfTriangle(TriangleId t) {
  std::array<std::vector<VertexId>, 3> divisions;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto found = inserted_.find(3 * t + k);
    if (found == inserted_.end()) continue;
    divisions[k] = found->second;
    for (VertexId& v : divisions[k]) v = onto_[v];
  }
  const auto [facing, fresh] = facing_.try_emplace(t);
  if (fresh) facing->second = facingOf(at_, piece_.mesh.triangles[t]);
  return partsOf(at_, cornersOf(t), {divisions[0], divisions[1], divisions[2]}, facing->second);
}

// The triangles that change with the vertices of a group.
std::vector<TriangleId> SeamGroups::trianglesAt(VertexId group) const {
  std::vector<TriangleId> all;
  for (const VertexId v : vertices_[group])
    for (const TriangleId t : around_.of(v))
      if (piece_.present[t] != 0) all.push_back(t);
  for (const std::uint32_t s : stops_[group]) all.push_back(rims_.span(rims_.stop(s).spans[0]).slot / 3);
  sortUnique(all);
  return all;
}

// Whether an edge from the group to another would have more than two triangles.
bool SeamGroups::crowds(VertexId group) const {
  std::vector<std::pair<VertexId, std::uint32_t>> ends;
  for (const std::uint32_t s : stops_[group])
    for (const std::uint32_t span : rims_.stop(s).spans) {
      const std::uint32_t end = rims_.across(span, s);
      if (end != kNone) ends.emplace_back(groupOf(end), span);
    }
  sortUnique(ends);
  for (std::size_t i = 2; i < ends.size(); ++i)
    if (ends[i].first == ends[i - 2].first) return true;
  return false;
}

// Notes the spans that leave the group for one and the same other group.
void SeamGroups::closeAt(VertexId group) {
  std::vector<std::pair<VertexId, std::uint32_t>> ends;
  for (const std::uint32_t s : stops_[group])
    for (const std::uint32_t span : rims_.stop(s).spans) {
      const std::uint32_t end = rims_.across(span, s);
      if (end != kNone && !rims_.span(span).joined) ends.emplace_back(groupOf(end), span);
    }
  sortUnique(ends);
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i].first == ends[i - 1].first) {
      rims_.setJoined(ends[i].second);
      rims_.setJoined(ends[i - 1].second);
      joinedEdges_ += 2;
    }
}

bool SeamGroups::moveGroup(VertexId from, VertexId to, double distance) {
  for (const VertexId v : vertices_[from])
    if ((at_[v] - at_[to]).norm() > distance) return false;
  const std::vector<TriangleId> touched = trianglesAt(from);
  for (const VertexId v : vertices_[from]) onto_[v] = to;
  const std::size_t vertices = vertices_[to].size(), stops = stops_[to].size();
  vertices_[to].insert(vertices_[to].end(), vertices_[from].begin(), vertices_[from].end());
  stops_[to].insert(stops_[to].end(), stops_[from].begin(), stops_[from].end());
  const bool fits = !crowds(to) && std::none_of(touched.begin(), touched.end(),
                                                [&](TriangleId t) { return partsOfTriangle(t).empty(); });
  if (!fits) {
    vertices_[to].resize(vertices);
    stops_[to].resize(stops);
    for (const VertexId v : vertices_[from]) onto_[v] = from;
    return false;
  }
  vertices_[from].clear();
  stops_[from].clear();
  closeAt(to);
  return true;
}

// The spans of a rim edge, those nearest to p first.
std::vector<std::uint32_t> SeamGroups::spansOf(std::uint32_t slot, const Vec3& p) const {
  std::vector<std::pair<double, std::uint32_t>> all;
  const auto [a, b] = endsOf(slot);
  std::uint32_t span = spanOfSlot_.at(slot);
  const auto found = inserted_.find(slot);
  const std::size_t count = found == inserted_.end() ? 1 : found->second.size() + 1;
  VertexId from = onto_[a];
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t end = rims_.span(span).stops[1];
    const VertexId to = i + 1 == count ? onto_[b] : groupOf(end);
    all.emplace_back(mesh::toSegment(p, at_[from], at_[to]), span);
    if (i + 1 == count) break;
    from = to;
    span = rims_.onward(end, span);
  }
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> spans;
  for (const auto& entry : all) spans.push_back(entry.second);
  return spans;
}

// Where in the list of its slot a corner goes that divides the span.
std::ptrdiff_t SeamGroups::placeOf(std::uint32_t span) const {
  std::ptrdiff_t place = 0;
  for (std::uint32_t at = spanOfSlot_.at(rims_.span(span).slot); at != span; ++place)
    at = rims_.onward(rims_.span(at).stops[1], at);
  return place;
}

bool SeamGroups::divideAt(std::uint32_t stop, std::uint32_t span) {
  const VertexId group = groupOf(stop);
  const std::uint32_t slot = rims_.span(span).slot;
  std::vector<VertexId>& list = inserted_[slot];
  const std::ptrdiff_t place = placeOf(span);
  list.insert(list.begin() + place, group);
  if (partsOfTriangle(slot / 3).empty()) {
    list.erase(list.begin() + place);
    if (list.empty()) inserted_.erase(slot);
    return false;
  }
  stops_[group].push_back(rims_.divide(span, rims_.stop(stop).vertex));
  closeAt(group);
  return true;
}

void SeamGroups::apply(Ledger& ledger) {
  std::size_t moved = 0;
  for (VertexId v = 0; v < onto_.size(); ++v) moved += onto_[v] != v;
  std::map<TriangleId, std::vector<Triangle>> divided;
  for (const auto& [slot, list] : inserted_) divided.try_emplace(slot / 3);
  for (auto& [t, parts] : divided) parts = partsOfTriangle(t);
  const auto count = static_cast<TriangleId>(piece_.mesh.triangles.size());
  for (TriangleId t = 0; t < count; ++t) {
    const Triangle c = cornersOf(t);
    if (piece_.present[t] == 0 || c == piece_.mesh.triangles[t]) continue;
    ledger.addUncounted(RepairKind::kWelded, piece_.origin[t], piece_.area(t), piece_.middle(t));
    piece_.mesh.triangles[t] = c;
  }
  if (moved > 0) ledger.addCount(RepairKind::kWelded, moved);
  for (const auto& [t, parts] : divided) {
    piece_.remove(t, RepairKind::kDivided);
    for (const Triangle& part : parts) piece_.addPart(part, t);
  }
}

}  // namespace thicken::repairing
