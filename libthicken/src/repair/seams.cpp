// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/seams.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <tuple>
#include <utility>

#include "exact/box_tree.h"
#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "repair/near_rim.h"
#include "repair/seam_groups.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::kNone;
using mesh::sortUnique;
using mesh::toSegment;

namespace {

// Two sheets whose inner sides are within 30° of one direction lie on each other.
constexpr double kSameSide = 0.866;

constexpr std::size_t kOrderReach = 64;  // stops along a rim that are looked at for their order

// A stop and what it may be joined to: another stop, or the rim edge of a slot.
struct Candidate {
  double apart;
  std::uint32_t stop, other;
  bool operator<(const Candidate& o) const {
    return std::tie(apart, stop, other) < std::tie(o.apart, o.stop, o.other);
  }
};

class SeamJoiner : private SeamGroups {
 public:
  SeamJoiner(Workpiece& piece, double distance)
      : SeamGroups(piece), piece_(piece), at_(piece.mesh.positions), distance_(distance) {
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
    result_.joinedEdges = joinedEdges();
    apply(ledger);
    return std::move(result_);
  }

  // The corners that are near another rim.
  [[nodiscard]] NearRims near() const {
    NearRims result;
    std::vector<std::uint8_t> counted(at_.size(), 0);
    for (const Candidate& c : edges_) {
      const VertexId v = rims().stop(c.stop).vertex;
      if (counted[v] != 0 || !isApart(c)) continue;
      counted[v] = 1;
      ++result.corners;
      result.distance = c.apart;  // they come in ascending order
    }
    return result;
  }

 private:
  static constexpr int kMostRounds = 8;

  void findCandidates() {
    std::vector<Triangle> edges;
    for (std::uint32_t s = 0; s < rims().spanCount(); ++s) {
      const auto [a, b] = endsOf(rims().span(s).slot);
      edges.push_back({a, b, b});
    }
    const exact::BoxTree tree(at_, edges, 1);
    const Vec3 reach = Vec3::Constant(distance_);
    const std::size_t count = rims().stopCount();
    for (std::uint32_t s = 0; s < count; ++s) {
      const VertexId v = rims().stop(s).vertex;
      std::vector<std::uint32_t> near;
      for (const std::uint32_t span : tree.near(at_[v] - reach, at_[v] + reach)) {
        const std::uint32_t slot = rims().span(span).slot;
        const auto [a, b] = endsOf(slot);
        if (a == v || b == v) continue;
        const double apart = toSegment(at_[v], at_[a], at_[b]);
        if (apart > distance_) continue;
        edges_.push_back({apart, s, slot});
        for (const std::uint32_t end : rims().span(span).stops)
          if (end != kNone) near.push_back(end);
      }
      sortUnique(near);
      for (const std::uint32_t o : near) {
        const double apart = (at_[v] - at_[rims().stop(o).vertex]).norm();
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
      rims().walk(piece_, stop, side, [&](std::uint32_t to, double) {
        sides[side].push_back(to);
        return sides[side].size() < kOrderReach;
      });
    return sides;
  }
  // The same on either side of a point within a span.
  [[nodiscard]] Sides sidesOfSpan(std::uint32_t span) const {
    Sides sides;
    for (int side = 0; side < 2; ++side) {
      const std::uint32_t end = rims().span(span).stops[side];
      if (end == kNone) continue;
      sides[side].push_back(end);
      const int away = rims().stop(end).spans[0] == span ? 1 : 0;
      rims().walk(piece_, end, away, [&](std::uint32_t to, double) {
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
      rims().walk(piece_, from, side, [&](std::uint32_t at, double length) {
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
  [[nodiscard]] bool stopLiesOn(std::uint32_t stop, std::uint32_t slot) const {
    const auto own = slotsAt(stop);
    return lieTogether(own[0], slot) || lieTogether(own[1], slot);
  }
  [[nodiscard]] bool stopsLieTogether(std::uint32_t x, std::uint32_t y) const {
    const auto a = slotsAt(x), b = slotsAt(y);
    return (lieTogether(a[0], b[0]) && lieTogether(a[1], b[1])) ||
           (lieTogether(a[0], b[1]) && lieTogether(a[1], b[0]));
  }

  bool tryPair(std::uint32_t x, std::uint32_t y, bool among) {
    const VertexId gx = groupOf(x), gy = groupOf(y);
    if (gx == gy || !mayGrow(gx, gy, among)) return false;
    const double apart = (at_[rims().stop(x).vertex] - at_[rims().stop(y).vertex]).norm();
    if (isBend(x, {y, kNone}, {0, 0}, apart) || stopsLieTogether(x, y)) return false;
    if (!keepsOrder(sidesOf(x), sidesOf(y)) || !keepsOrder(sidesOf(y), sidesOf(x))) return false;
    return moveGroup(std::max(gx, gy), std::min(gx, gy), distance_) ||
           moveGroup(std::min(gx, gy), std::max(gx, gy), distance_);
  }

  [[nodiscard]] bool mayGrow(VertexId gx, VertexId gy, bool among) const {
    if (!among) return stopsIn(gx) == 1 && stopsIn(gy) == 1;
    return groupIsOpen(gx) && groupIsOpen(gy);
  }

  bool tryEdge(std::uint32_t x, std::uint32_t slot, bool among) {
    const VertexId group = groupOf(x);
    if (among ? !groupIsOpen(group) : stopsIn(group) != 1) return false;
    const auto [a, b] = endsOf(slot);
    const double apart = toSegment(at_[group], at_[a], at_[b]);
    if (apart > distance_ || onto(a) == group || onto(b) == group) return false;
    if (stopLiesOn(x, slot)) return false;
    if (divides(group, slot)) return false;
    for (const std::uint32_t span : spansOf(slot, at_[group]))
      if (insert(x, span, apart)) return true;
    return false;
  }

  bool insert(std::uint32_t x, std::uint32_t span, double apart) {
    if (rims().span(span).joined) return false;
    if (isBend(x, rims().span(span).stops, toEnds(span, at_[groupOf(x)]), apart)) return false;
    const Sides along = sidesOf(x), across = sidesOfSpan(span);
    return keepsOrder(along, across) && keepsOrder(across, along) && divideAt(x, span);
  }

  // Whether the stop is open, near an open part of the other rim, and not joined to it.
  [[nodiscard]] bool isApart(const Candidate& c) const {
    const VertexId group = groupOf(c.stop);
    const auto [a, b] = endsOf(c.other);
    if (!isOpen(c.stop) || isAnchor(c.stop) || onto(a) == group || onto(b) == group) return false;
    const std::uint32_t span = spansOf(c.other, at_[group]).front();
    if (rims().span(span).joined || stopLiesOn(c.stop, c.other)) return false;
    return !isBend(c.stop, rims().span(span).stops, toEnds(span, at_[group]), c.apart);
  }

  // How far the ends of a span are from p.
  [[nodiscard]] std::array<double, 2> toEnds(std::uint32_t span, const Vec3& p) const {
    std::array<double, 2> rest{0, 0};
    const auto& ends = rims().span(span).stops;
    for (int k = 0; k < 2; ++k)
      if (ends[k] != kNone) rest[k] = (at_[groupOf(ends[k])] - p).norm();
    return rest;
  }

  // Corners near another rim that are not on it, although both are open there.
  void noteLeft() {
    std::vector<VertexId> left;
    for (const Candidate& c : edges_)
      if (isApart(c)) left.push_back(rims().stop(c.stop).vertex);
    sortUnique(left);
    result_.left = left.size();
    left.resize(std::min(left.size(), SeamFacts::kMaxPlaces));
    for (const VertexId v : left) result_.leftPlaces.push_back(at_[v]);
  }

  Workpiece& piece_;
  const std::vector<Vec3>& at_;
  double distance_;
  std::vector<Candidate> pairs_, edges_;
  SeamFacts result_;
};

}  // namespace

NearRims nearRims(Workpiece& piece) {
  constexpr double kNear = 0.25;  // of the mean rim edge
  double sum = 0;
  std::size_t count = 0;
  const mesh::HalfEdges edges(piece.mesh.positions.size(), piece.mesh.triangles, piece.present);
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
