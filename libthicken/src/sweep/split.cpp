// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/split.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "exact/predicates.h"
#include "exact/triangle_pair.h"

namespace thicken::sweep {

using mesh::VertexTriangles;

namespace {

// The triangles around a vertex in order: triangle i lies between ring[i] and ring[i + 1] (cyclic
// when closed).
struct Fan {
  std::vector<TriangleId> triangles;
  std::vector<VertexId> ring;
  bool closed = false;
  [[nodiscard]] std::size_t size() const { return triangles.size(); }
  [[nodiscard]] VertexId ringAt(std::size_t i) const { return ring[i % ring.size()]; }
};

Fan orderedFan(const SweptMesh& mesh, std::span<const TriangleId> around, VertexId v) {
  std::unordered_map<VertexId, std::pair<VertexId, TriangleId>> next;
  std::unordered_map<VertexId, int> entered;
  for (const TriangleId t : around) {
    const Triangle& s = mesh.triangles[t];
    const int k = s[0] == v ? 0 : s[1] == v ? 1 : 2;
    next[s[(k + 1) % 3]] = {s[(k + 2) % 3], t};
    ++entered[s[(k + 2) % 3]];
  }
  const Triangle& first = mesh.triangles[around.front()];
  const int k = first[0] == v ? 0 : first[1] == v ? 1 : 2;
  VertexId start = first[(k + 1) % 3];
  Fan fan;
  fan.closed = true;
  for (const TriangleId t : around)  // an open fan starts where nothing enters
    for (const VertexId u : mesh.triangles[t])
      if (u != v && next.contains(u) && !entered.contains(u)) {
        start = u;
        fan.closed = false;
      }
  VertexId u = start;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto [to, t] = next.at(u);
    fan.ring.push_back(u);
    fan.triangles.push_back(t);
    u = to;
  }
  if (!fan.closed) fan.ring.push_back(u);
  return fan;
}

struct Sector {
  Vec3 m = Vec3::Zero();  // n·m ≥ 1 for all of its normals, unless that would be too long
  double safety = 0;      // smallest n·m/|m|
};

// The safest direction of the triangles [begin, end), turned by `tilt` towards where the fan does
// not reach: both sides of a sharp fold want to go around its edge.
Sector sectorOf(const Fan& fan, std::span<const Vec3> faceNormal, std::size_t begin, std::size_t end,
                const Vec3& tilt) {
  std::vector<Vec3> normals;
  for (std::size_t i = begin; i < end; ++i) normals.push_back(faceNormal[fan.triangles[i % fan.size()]]);
  const Vec3 hull = minNormPoint(normals);
  if (hull.norm() < 1e-6) return {};
  const Vec3 m = (hull.normalized() + tilt).normalized();
  double least = 1;
  for (const Vec3& n : normals) least = std::min(least, n.dot(m));
  constexpr double kLongest = 1.5, kLeast = 0.02;
  if (least < kLeast) return {};
  return {m * std::min(1 / least, kLongest), least};
}

// A division: triangles [begin, end) of the fan get the second copy. The dividing edges lead to
// ring[begin] and, where the fan is closed, to ring[end].
struct Division {
  std::size_t begin = 0, end = 0;
  Sector first, second;
  [[nodiscard]] double safety() const { return std::min(first.safety, second.safety); }
  [[nodiscard]] bool isSecond(std::size_t i) const { return i >= begin && i < end; }
};

// What the copies `a` and `b` of `v` add between the two sectors, in the sense of S: a bridge along
// every dividing edge and, on the rim, a piece of wall.
std::vector<Triangle> bridges(const Fan& fan, const Division& d, VertexId v, VertexId a, VertexId b,
                              const std::function<VertexId(std::size_t)>& ring) {
  std::vector<Triangle> t{{a, ring(d.begin), b}};
  if (fan.closed)
    t.push_back({b, ring(d.end), a});
  else
    t.push_back({v, a, b});
  return t;
}

// Whether the divided fan, with both copies next to v and the ring where it is, stays clear of S
// around v and of itself.
class DivisionTest {
 public:
  DivisionTest(const SweptMesh& mesh, const Fan& fan, VertexId v, double sign) : fan_(fan), sign_(sign) {
    positions_.push_back(mesh.positions[v]);
    double shortest = std::numeric_limits<double>::infinity();
    for (const VertexId u : fan.ring) {
      positions_.push_back(mesh.positions[u]);
      shortest = std::min(shortest, (mesh.positions[u] - mesh.positions[v]).norm());
    }
    constexpr double kShallow = 1e-3;
    step_ = kShallow * shortest;
    positions_.resize(positions_.size() + 2);
    for (std::size_t i = 0; i < fan.size(); ++i) obstacles_.push_back({0, ring(i), ring(i + 1)});
  }

  // One copy for the whole fan.
  bool passesUndivided(const Vec3& m) {
    const auto a = static_cast<VertexId>(positions_.size() - 2);
    positions_[a] = positions_[0] + sign_ * step_ * m;
    std::vector<Triangle> copy = walls(a, a);
    for (std::size_t i = 0; i < fan_.size(); ++i) copy.push_back({a, ring(i), ring(i + 1)});
    return isClear(copy);
  }

  bool passes(const Division& d) {
    const auto a = static_cast<VertexId>(positions_.size() - 2), b = a + 1;
    positions_[a] = positions_[0] + sign_ * step_ * d.first.m;
    positions_[b] = positions_[0] + sign_ * step_ * d.second.m;
    auto divided = bridges(fan_, d, 0, a, b, [&](std::size_t i) { return ring(i); });
    for (std::size_t i = 0; i < fan_.size(); ++i)
      divided.push_back({d.isSecond(i) ? b : a, ring(i), ring(i + 1)});
    const auto wall = walls(a, b);
    divided.insert(divided.end(), wall.begin(), wall.end());
    return isClear(divided);
  }

 private:
  // What the walls below the two rim edges of an open fan are next to v.
  [[nodiscard]] std::vector<Triangle> walls(VertexId first, VertexId last) const {
    if (fan_.closed) return {};
    return {{0, first, ring(0)}, {0, ring(fan_.size()), last}};
  }

  [[nodiscard]] bool isClear(const std::vector<Triangle>& divided) const {
    for (std::size_t i = 0; i < divided.size(); ++i) {
      const Triangle& t = divided[i];
      const auto meets = [&](const Triangle& s) { return exact::meet(positions_, t, s); };
      if (exact::collinear(positions_[t[0]], positions_[t[1]], positions_[t[2]]) ||
          std::any_of(obstacles_.begin(), obstacles_.end(), meets) ||
          std::any_of(divided.begin(), divided.begin() + static_cast<std::ptrdiff_t>(i), meets))
        return false;
    }
    return true;
  }

  [[nodiscard]] VertexId ring(std::size_t i) const { return static_cast<VertexId>(1 + i % fan_.ring.size()); }

  const Fan& fan_;
  double sign_;
  double step_ = 0;
  std::vector<Vec3> positions_;  // v, its ring, the two copies
  std::vector<Triangle> obstacles_;
};

// Unit mean of the directions from v into the triangles [begin, end).
Vec3 alongSector(const SweptMesh& mesh, const Fan& fan, VertexId v, std::size_t begin, std::size_t end) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = begin; i < end; ++i)
    for (const std::size_t k : {i, i + 1})
      sum += (mesh.positions[fan.ringAt(k)] - mesh.positions[v]).normalized();
  return sum.stableNormalized();
}

std::optional<Division> bestDivision(const SweptMesh& mesh, const Fan& fan, std::span<const Vec3> faceNormal,
                                     VertexId v, double sign) {
  const std::size_t n = fan.size();
  Vec3 within = Vec3::Zero();
  for (const VertexId u : fan.ring) within += (mesh.positions[u] - mesh.positions[v]).normalized();
  within.stableNormalize();
  std::vector<Division> candidates;
  const auto consider = [&](std::size_t begin, std::size_t end) {
    // The way is sign·m. Away from the whole fan, around a sharp fold between the sectors; or along
    // each sector, into a narrow gap below it.
    constexpr double kOutward[] = {0, 0.5, 1, 2}, kAlong[] = {1, 4, 16};
    const auto add = [&](const Vec3& firstTilt, const Vec3& secondTilt) {
      const Division d{
          begin, end,
          sectorOf(fan, faceNormal, fan.closed ? end : 0, fan.closed ? begin + n : begin, firstTilt),
          sectorOf(fan, faceNormal, begin, end, secondTilt)};
      if (d.safety() > 0) candidates.push_back(d);
    };
    for (const double tilt : kOutward) add(-sign * tilt * within, -sign * tilt * within);
    const Vec3 alongFirst = alongSector(mesh, fan, v, fan.closed ? end : 0, fan.closed ? begin + n : begin);
    const Vec3 alongSecond = alongSector(mesh, fan, v, begin, end);
    for (const double tilt : kAlong) {
      add(sign * tilt * alongFirst, Vec3::Zero());
      add(Vec3::Zero(), sign * tilt * alongSecond);
    }
  };
  for (std::size_t begin = fan.closed ? 0 : 1; begin < n; ++begin) {
    if (!fan.closed) consider(begin, n);
    for (std::size_t end = begin + 1; fan.closed && end < n; ++end) consider(begin, end);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Division& a, const Division& b) { return a.safety() > b.safety(); });
  DivisionTest test(mesh, fan, v, sign);
  for (const Division& d : candidates)
    if (test.passes(d)) return d;
  return std::nullopt;
}

// Gives the triangles of the second sector to a new copy of `id`'s vertex and adds the bridges.
void divide(SweptMesh& mesh, const Fan& fan, const Division& d, std::uint32_t id,
            std::span<const TriangleId> uses, double sign) {
  const VertexId v = mesh.copies[id].base, a = mesh.vertexOf(id), b = mesh.vertexOf(mesh.copies.size());
  const auto baseOf = [&](VertexId x) { return mesh.isCopy(x) ? mesh.copyOf(x).base : x; };
  std::unordered_map<VertexId, VertexId> copyOnRing;
  for (const TriangleId t : uses)
    for (const VertexId x : mesh.triangles[t])
      if (mesh.isCopy(x)) copyOnRing[mesh.copyOf(x).base] = x;
  for (const TriangleId t : uses) {
    Triangle& s = mesh.triangles[t];
    bool second = false;
    if (mesh.region[t] == Region::kWall) {
      second = std::any_of(s.begin(), s.end(), [&](VertexId x) { return baseOf(x) == fan.ring.back(); });
    } else {
      for (std::size_t i = 0; i < fan.size(); ++i) {
        const VertexId p = fan.ringAt(i), q = fan.ringAt(i + 1);
        int matched = 0;
        for (const VertexId x : s) matched += baseOf(x) == p || baseOf(x) == q;
        if (matched == 2) second = d.isSecond(i);
      }
    }
    if (second) std::replace(s.begin(), s.end(), a, b);
  }
  for (Triangle t : bridges(fan, d, v, a, b, [&](std::size_t i) { return copyOnRing.at(fan.ringAt(i)); })) {
    const bool wall = t[0] == v;
    if (sign < 0) std::swap(t[1], t[2]);
    mesh.add(t, wall ? Region::kWall : Region::kShell, mesh::kNone);
  }
  const auto aim = [&](Copy& c, const Sector& s) {
    c.offset = sign * mesh.thickness.at(v) * s.m;
    c.length = c.offset.norm();
    c.safety = s.safety;
  };
  Copy other = mesh.copies[id];
  aim(mesh.copies[id], d.first);
  aim(other, d.second);
  mesh.copies.push_back(other);
  mesh.positions.push_back(mesh.positions[v]);
}

}  // namespace

void markBlockedRimCopies(SweptMesh& mesh, const VertexTriangles& around, const mesh::Rim& rim) {
  for (const mesh::RimEdge& e : rim.edges)
    for (std::size_t shell = 0; shell < mesh.shells; ++shell) {
      Copy& c = mesh.copies[shell * mesh.surfaceVertices + e.from];
      const Fan fan = orderedFan(mesh, around.of(e.from), e.from);
      if (c.length > 0 && !DivisionTest(mesh, fan, e.from, 1).passesUndivided(c.offset / c.length))
        c.safety = 0;
    }
}

std::vector<std::uint32_t> splitCopies(SweptMesh& mesh, std::span<const Vec3> faceNormal,
                                       const VertexTriangles& around, std::span<const std::uint32_t> ids) {
  std::vector<std::uint32_t> unserved;
  if (ids.empty()) return unserved;
  const VertexTriangles uses = mesh::vertexTriangles(mesh.positions.size(), mesh.triangles);
  std::unordered_set<VertexId> divided;
  for (const std::uint32_t id : ids) {
    const VertexId v = mesh.copies[id].base;
    const double sign = id < mesh.surfaceVertices ? -1 : 1;  // the first shell lies behind S
    const Fan fan = orderedFan(mesh, around.of(v), v);
    // Next to a divided or dropped copy the triangles are no longer those of S.
    const std::size_t shell = sign < 0 ? 0 : mesh.surfaceVertices;
    const bool free = std::none_of(fan.ring.begin(), fan.ring.end(), [&](VertexId u) {
      return divided.contains(u) || mesh.copies[shell + u].dropped;
    });
    const auto division = free ? bestDivision(mesh, fan, faceNormal, v, sign) : std::nullopt;
    if (!division) {
      unserved.push_back(id);
      continue;
    }
    divide(mesh, fan, *division, id, uses.of(mesh.vertexOf(id)), sign);
    divided.insert(v);
  }
  return unserved;
}

}  // namespace thicken::sweep
