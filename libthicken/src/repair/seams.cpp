// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "exact/box_tree.h"
#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "repair/divided_triangle.h"
#include "repair/rims.h"

namespace thicken::repairing {
namespace {

// A rim that comes back to itself is near itself at every bend. Only where the way along it is this many
// times as long as the way across is it a seam.
constexpr double kFoldedBack = 4;

// Two sheets whose inner sides are within 30° of one direction lie on each other.
constexpr double kSameSide = 0.866;

constexpr std::size_t kOrderReach = 64;  // stops along a rim that are looked at for their order

double share(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double length2 = u.squaredNorm();
  return length2 > 0 ? std::clamp((p - a).dot(u) / length2, 0.0, 1.0) : 0;
}

double toSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (a + share(p, a, b) * (b - a) - p).norm();
}

// A stop and what it may be joined to: another stop, or the rim edge of a slot.
struct Candidate {
  double apart;
  std::uint32_t stop, other;
  bool operator<(const Candidate& o) const {
    return std::tie(apart, stop, other) < std::tie(o.apart, o.stop, o.other);
  }
};

class SeamJoiner {
 public:
  SeamJoiner(Workpiece& piece, double distance)
      : piece_(piece),
        at_(piece.mesh.positions),
        distance_(distance),
        around_(vertexTriangles(at_.size(), piece.mesh.triangles)),
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
    findCandidates();
  }

  SeamFacts run(Ledger& ledger) {
    // First what is beyond doubt: two corners of two rims, then corners on edges. Where seams meet, and
    // among loose triangles, more than two corners become one.
    bool among = false;
    for (int round = 0; round < kMostRounds; ++round) {
      bool changed = false;
      for (const Candidate& c : pairs_) changed |= tryPair(c.stop, c.other, among);
      for (const Candidate& c : edges_) changed |= tryEdge(c.stop, c.other, among);
      if (!changed && among) break;
      among = true;
    }
    noteLeft();
    apply(ledger);
    return std::move(result_);
  }

  // The corners that are near another rim.
  [[nodiscard]] NearRims near() const {
    NearRims result;
    std::vector<std::uint8_t> counted(at_.size(), 0);
    for (const Candidate& c : edges_) {
      const VertexId v = rims_.stop(c.stop).vertex;
      if (counted[v] != 0 || !isApart(c)) continue;
      counted[v] = 1;
      ++result.corners;
      result.distance = c.apart;  // they come in ascending order
    }
    return result;
  }

 private:
  static constexpr int kMostRounds = 8;

  [[nodiscard]] VertexId groupOf(std::uint32_t stop) const { return onto_[rims_.stop(stop).vertex]; }
  [[nodiscard]] bool isAnchor(std::uint32_t stop) const { return stops_[groupOf(stop)].size() > 1; }
  [[nodiscard]] Triangle cornersOf(TriangleId t) const {
    Triangle c = piece_.mesh.triangles[t];
    for (VertexId& v : c) v = onto_[v];
    return c;
  }
  [[nodiscard]] std::pair<VertexId, VertexId> endsOf(std::uint32_t slot) const {
    const Triangle& c = piece_.mesh.triangles[slot / 3];
    return {c[slot % 3], c[(slot % 3 + 1) % 3]};
  }
  [[nodiscard]] bool isOpen(std::uint32_t stop) const {
    const auto& spans = rims_.stop(stop).spans;
    return !rims_.span(spans[0]).joined || !rims_.span(spans[1]).joined;
  }
  [[nodiscard]] bool groupIsOpen(VertexId group) const {
    return std::any_of(stops_[group].begin(), stops_[group].end(),
                       [&](std::uint32_t s) { return isOpen(s); });
  }

  void findCandidates() {
    std::vector<Triangle> edges;
    for (std::uint32_t s = 0; s < rims_.spanCount(); ++s) {
      const auto [a, b] = endsOf(rims_.span(s).slot);
      edges.push_back({a, b, b});
    }
    const exact::BoxTree tree(at_, edges, 1);
    const Vec3 reach = Vec3::Constant(distance_);
    const std::size_t count = rims_.stopCount();
    for (std::uint32_t s = 0; s < count; ++s) {
      const VertexId v = rims_.stop(s).vertex;
      std::vector<std::uint32_t> near;
      for (const std::uint32_t span : tree.near(at_[v] - reach, at_[v] + reach)) {
        const std::uint32_t slot = rims_.span(span).slot;
        const auto [a, b] = endsOf(slot);
        if (a == v || b == v) continue;
        const double apart = toSegment(at_[v], at_[a], at_[b]);
        if (apart > distance_) continue;
        edges_.push_back({apart, s, slot});
        for (const std::uint32_t end : rims_.span(span).stops)
          if (end != kNone) near.push_back(end);
      }
      sortUnique(near);
      for (const std::uint32_t o : near) {
        const double apart = (at_[v] - at_[rims_.stop(o).vertex]).norm();
        if (s < o && apart <= distance_) pairs_.push_back({apart, s, o});
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
    std::sort(edges_.begin(), edges_.end());
  }

  // The stops along the rim on either side of `stop`.
  using Sides = std::array<std::vector<std::uint32_t>, 2>;
  [[nodiscard]] Sides sidesOf(std::uint32_t stop) const {
    Sides sides;
    for (int side = 0; side < 2; ++side)
      rims_.walk(piece_, stop, side, [&](std::uint32_t to, double) {
        sides[side].push_back(to);
        return sides[side].size() < kOrderReach;
      });
    return sides;
  }
  // The same on either side of a point within a span.
  [[nodiscard]] Sides sidesOfSpan(std::uint32_t span) const {
    Sides sides;
    for (int side = 0; side < 2; ++side) {
      const std::uint32_t end = rims_.span(span).stops[side];
      if (end == kNone) continue;
      sides[side].push_back(end);
      const int away = rims_.stop(end).spans[0] == span ? 1 : 0;
      rims_.walk(piece_, end, away, [&](std::uint32_t to, double) {
        sides[side].push_back(to);
        return sides[side].size() < kOrderReach;
      });
    }
    return sides;
  }

  [[nodiscard]] std::uint32_t firstAnchor(const std::vector<std::uint32_t>& stops) const {
    const auto found = std::find_if(stops.begin(), stops.end(), [&](std::uint32_t s) { return isAnchor(s); });
    return found == stops.end() ? kNone : *found;
  }

  // What is joined next along one rim must not be joined beyond something else along the other.
  [[nodiscard]] bool keepsOrder(const Sides& one, const Sides& other) const {
    for (const auto& side : one) {
      const std::uint32_t next = firstAnchor(side);
      if (next == kNone) continue;
      const VertexId group = groupOf(next);
      bool beyond = false, beside = false;
      for (const auto& opposite : other) {
        const std::uint32_t first = firstAnchor(opposite);
        beside |= first != kNone && groupOf(first) == group;
        beyond |= std::any_of(opposite.begin(), opposite.end(),
                              [&](std::uint32_t s) { return groupOf(s) == group; });
      }
      if (beyond && !beside) return false;
    }
    return true;
  }

  // Whether the way along the rim from one stop to the other, or to a span's nearer end and `rest` farther,
  // is not much longer than the way across.
  [[nodiscard]] bool isBend(std::uint32_t from, std::array<std::uint32_t, 2> to, std::array<double, 2> rest,
                            double apart) const {
    bool bend = false;
    for (int side = 0; side < 2; ++side)
      rims_.walk(piece_, from, side, [&](std::uint32_t at, double length) {
        if (length > kFoldedBack * apart) return false;
        for (int k = 0; k < 2; ++k) bend |= at == to[k] && length + rest[k] <= kFoldedBack * apart;
        return !bend;
      });
    return bend;
  }

  // Towards the inside of the sheet, at the edge of a slot.
  [[nodiscard]] Vec3 inwardOfSlot(std::uint32_t slot) const {
    const auto [a, b] = endsOf(slot);
    const Vec3 along = (at_[b] - at_[a]).normalized();
    const Vec3 up = at_[piece_.mesh.triangles[slot / 3][(slot % 3 + 2) % 3]] - at_[a];
    return (up - up.dot(along) * along).normalized();
  }
  // Whether the sheets at two rim edges lie on each other and not side by side.
  [[nodiscard]] bool lieTogether(std::uint32_t slot, std::uint32_t other) const {
    return inwardOfSlot(slot).dot(inwardOfSlot(other)) > kSameSide;
  }
  [[nodiscard]] std::array<std::uint32_t, 2> slotsAt(std::uint32_t stop) const {
    const auto& spans = rims_.stop(stop).spans;
    return {rims_.span(spans[0]).slot, rims_.span(spans[1]).slot};
  }
  [[nodiscard]] bool stopLiesOn(std::uint32_t stop, std::uint32_t slot) const {
    const auto own = slotsAt(stop);
    return lieTogether(own[0], slot) || lieTogether(own[1], slot);
  }
  [[nodiscard]] bool stopsLieTogether(std::uint32_t x, std::uint32_t y) const {
    const auto a = slotsAt(x), b = slotsAt(y);
    return (lieTogether(a[0], b[0]) && lieTogether(a[1], b[1])) ||
           (lieTogether(a[0], b[1]) && lieTogether(a[1], b[0]));
  }

  [[nodiscard]] std::vector<Triangle> partsOfTriangle(TriangleId t) {
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
  [[nodiscard]] std::vector<TriangleId> trianglesAt(VertexId group) const {
    std::vector<TriangleId> all;
    for (const VertexId v : vertices_[group])
      for (const TriangleId t : around_.of(v))
        if (piece_.present[t] != 0) all.push_back(t);
    for (const std::uint32_t s : stops_[group]) all.push_back(rims_.span(rims_.stop(s).spans[0]).slot / 3);
    sortUnique(all);
    return all;
  }

  // Whether an edge from the group to another would have more than two triangles.
  [[nodiscard]] bool crowds(VertexId group) const {
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
  void closeAt(VertexId group) {
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
        result_.joinedEdges += 2;
      }
  }

  bool tryPair(std::uint32_t x, std::uint32_t y, bool among) {
    const VertexId gx = groupOf(x), gy = groupOf(y);
    if (gx == gy || !mayGrow(gx, gy, among)) return false;
    const double apart = (at_[rims_.stop(x).vertex] - at_[rims_.stop(y).vertex]).norm();
    if (isBend(x, {y, kNone}, {0, 0}, apart) || stopsLieTogether(x, y)) return false;
    if (!keepsOrder(sidesOf(x), sidesOf(y)) || !keepsOrder(sidesOf(y), sidesOf(x))) return false;
    return moveGroup(std::max(gx, gy), std::min(gx, gy)) || moveGroup(std::min(gx, gy), std::max(gx, gy));
  }

  [[nodiscard]] bool mayGrow(VertexId gx, VertexId gy, bool among) const {
    if (!among) return stops_[gx].size() == 1 && stops_[gy].size() == 1;
    return groupIsOpen(gx) && groupIsOpen(gy);
  }

  bool moveGroup(VertexId from, VertexId to) {
    for (const VertexId v : vertices_[from])
      if ((at_[v] - at_[to]).norm() > distance_) return false;
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
  [[nodiscard]] std::vector<std::uint32_t> spansOf(std::uint32_t slot, const Vec3& p) const {
    std::vector<std::pair<double, std::uint32_t>> all;
    const auto [a, b] = endsOf(slot);
    std::uint32_t span = spanOfSlot_.at(slot);
    const auto found = inserted_.find(slot);
    const std::size_t count = found == inserted_.end() ? 1 : found->second.size() + 1;
    VertexId from = onto_[a];
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t end = rims_.span(span).stops[1];
      const VertexId to = i + 1 == count ? onto_[b] : groupOf(end);
      all.emplace_back(toSegment(p, at_[from], at_[to]), span);
      if (i + 1 == count) break;
      from = to;
      span = rims_.onward(end, span);
    }
    std::sort(all.begin(), all.end());
    std::vector<std::uint32_t> spans;
    for (const auto& entry : all) spans.push_back(entry.second);
    return spans;
  }

  bool tryEdge(std::uint32_t x, std::uint32_t slot, bool among) {
    const VertexId group = groupOf(x);
    if (among ? !groupIsOpen(group) : stops_[group].size() != 1) return false;
    const auto [a, b] = endsOf(slot);
    const double apart = toSegment(at_[group], at_[a], at_[b]);
    if (apart > distance_ || onto_[a] == group || onto_[b] == group) return false;
    if (stopLiesOn(x, slot)) return false;
    if (const auto found = inserted_.find(slot); found != inserted_.end())
      for (const VertexId v : found->second)
        if (onto_[v] == group) return false;
    for (const std::uint32_t span : spansOf(slot, at_[group]))
      if (insert(x, span, apart)) return true;
    return false;
  }

  bool insert(std::uint32_t x, std::uint32_t span, double apart) {
    const VertexId group = groupOf(x);
    if (rims_.span(span).joined) return false;
    const auto ends = rims_.span(span).stops;
    const std::uint32_t slot = rims_.span(span).slot;
    if (isBend(x, ends, toEnds(span, at_[group]), apart)) return false;
    const Sides along = sidesOf(x), across = sidesOfSpan(span);
    if (!keepsOrder(along, across) || !keepsOrder(across, along)) return false;
    std::vector<VertexId>& list = inserted_[slot];
    const std::ptrdiff_t place = placeOf(span);
    list.insert(list.begin() + place, group);
    if (partsOfTriangle(slot / 3).empty()) {
      list.erase(list.begin() + place);
      if (list.empty()) inserted_.erase(slot);
      return false;
    }
    stops_[group].push_back(rims_.divide(span, rims_.stop(x).vertex));
    closeAt(group);
    return true;
  }

  // Where in the list of its slot a corner goes that divides the span.
  [[nodiscard]] std::ptrdiff_t placeOf(std::uint32_t span) const {
    std::ptrdiff_t place = 0;
    for (std::uint32_t at = spanOfSlot_.at(rims_.span(span).slot); at != span; ++place)
      at = rims_.onward(rims_.span(at).stops[1], at);
    return place;
  }

  // Whether the stop is open, near an open part of the other rim, and not joined to it.
  [[nodiscard]] bool isApart(const Candidate& c) const {
    const VertexId group = groupOf(c.stop);
    const auto [a, b] = endsOf(c.other);
    if (!isOpen(c.stop) || isAnchor(c.stop) || onto_[a] == group || onto_[b] == group) return false;
    const std::uint32_t span = spansOf(c.other, at_[group]).front();
    if (rims_.span(span).joined || stopLiesOn(c.stop, c.other)) return false;
    return !isBend(c.stop, rims_.span(span).stops, toEnds(span, at_[group]), c.apart);
  }

  // How far the ends of a span are from p.
  [[nodiscard]] std::array<double, 2> toEnds(std::uint32_t span, const Vec3& p) const {
    std::array<double, 2> rest{0, 0};
    const auto& ends = rims_.span(span).stops;
    for (int k = 0; k < 2; ++k)
      if (ends[k] != kNone) rest[k] = (at_[groupOf(ends[k])] - p).norm();
    return rest;
  }

  // Corners near another rim that are not on it, although both are open there.
  void noteLeft() {
    std::vector<VertexId> left;
    for (const Candidate& c : edges_)
      if (isApart(c)) left.push_back(rims_.stop(c.stop).vertex);
    sortUnique(left);
    result_.left = left.size();
    left.resize(std::min(left.size(), SeamFacts::kMaxPlaces));
    for (const VertexId v : left) result_.leftPlaces.push_back(at_[v]);
  }

  void apply(Ledger& ledger) {
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

  Workpiece& piece_;
  const std::vector<Vec3>& at_;
  double distance_;
  VertexTriangles around_;
  Rims rims_;
  std::vector<VertexId> onto_;                     // per vertex: the one that it becomes
  std::vector<std::vector<VertexId>> vertices_;    // per vertex that stays: those that become it
  std::vector<std::vector<std::uint32_t>> stops_;  // the same: the stops there
  std::unordered_map<std::uint32_t, std::vector<VertexId>> inserted_;  // by slot, in the order of its edge
  std::unordered_map<std::uint32_t, std::uint32_t> spanOfSlot_;        // its first span
  std::unordered_map<TriangleId, Facing> facing_;
  std::vector<Candidate> pairs_, edges_;
  SeamFacts result_;
};

}  // namespace

NearRims nearRims(Workpiece& piece) {
  constexpr double kNear = 0.25;  // of the mean rim edge
  double sum = 0;
  std::size_t count = 0;
  const HalfEdges edges(piece.mesh.positions.size(), piece.mesh.triangles, piece.present);
  edges.forEachEdge(
      [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
        if (uses.size() + back.size() != 1) return;
        sum += (piece.mesh.positions[a] - piece.mesh.positions[b]).norm();
        ++count;
      });
  if (count == 0 || !(sum > 0)) return {};
  return SeamJoiner(piece, kNear * sum / static_cast<double>(count)).near();
}

SeamFacts joinSeams(Workpiece& piece, double distance, Ledger& ledger) {
  if (!(distance > 0)) return {};
  return SeamJoiner(piece, distance).run(ledger);
}

}  // namespace thicken::repairing
