// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/corners.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "exact/triangle_pair.h"
#include "measure/offset_error.h"
#include "mesh/sort_unique.h"
#include "mesh/union_find.h"

namespace thicken {

namespace {

using Triple = std::array<int, 3>;  // of planes, ascending
using Triangulation = std::vector<Triple>;

// More planes are merged, those that differ least first: a polygon of eight has 132 triangulations.
constexpr std::size_t kMostPlanes = 8;

// All triangulations of the polygon with the corners first … last.
std::vector<Triangulation> triangulationsOf(int first, int last) {
  if (last - first < 2) return {{}};
  std::vector<Triangulation> all;
  for (int apex = first + 1; apex < last; ++apex)
    for (const Triangulation& left : triangulationsOf(first, apex))
      for (const Triangulation& right : triangulationsOf(apex, last)) {
        Triangulation t = left;
        t.push_back({first, apex, last});
        t.insert(t.end(), right.begin(), right.end());
        all.push_back(std::move(t));
      }
  return all;
}

const std::vector<Triangulation>& triangulations(std::size_t planes) {
  static const auto kAll = [] {
    std::array<std::vector<Triangulation>, kMostPlanes + 1> all;
    for (std::size_t n = 3; n <= kMostPlanes; ++n) all[n] = triangulationsOf(0, static_cast<int>(n) - 1);
    return all;
  }();
  return kAll[planes];
}

// The triangles around a vertex v: triangle i is (v, ring i, ring i + 1).
struct Fan {
  std::vector<TriangleId> triangle;
  std::vector<VertexId> ring;  // one more than triangles on the rim
  [[nodiscard]] bool isClosed() const { return ring.size() == triangle.size(); }
};

Fan fanOf(std::span<const Triangle> triangles, std::span<const TriangleId> around, VertexId v) {
  struct Step {
    VertexId from, to;
    TriangleId triangle;
  };
  std::vector<Step> steps;
  for (const TriangleId t : around) {
    const Triangle& s = triangles[t];
    const int k = s[0] == v ? 0 : s[1] == v ? 1 : 2;
    steps.push_back({s[(k + 1) % 3], s[(k + 2) % 3], t});
  }
  const auto enters = [&](VertexId u) {
    return std::any_of(steps.begin(), steps.end(), [u](const Step& step) { return step.to == u; });
  };
  Fan fan;
  VertexId at = steps.front().from;
  for (const Step& step : steps)
    if (!enters(step.from)) at = step.from;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto next =
        std::find_if(steps.begin(), steps.end(), [at](const Step& step) { return step.from == at; });
    if (next == steps.end()) return {};
    fan.ring.push_back(at);
    fan.triangle.push_back(next->triangle);
    at = next->to;
  }
  if (at != fan.ring.front()) fan.ring.push_back(at);
  return fan;
}

// How far a copy is off a plane, in r.
double offFrom(const OffsetPlane& plane, const Vec3& m) {
  return std::abs(plane.normal.dot(m) - plane.way);
}

// Neighbours in a fan that one plane stands for.
struct Plane {
  Vec3 normal = Vec3::Zero();
  double way = 1;                    // OffsetPlane
  std::size_t first = 0, count = 0;  // of the fan's triangles, cyclic
};

// The planes of a fan, those merged that are nearly parallel, and the most parallel ones where there are too
// many.
std::vector<Plane> planesOf(const Fan& fan, std::span<const OffsetPlane> plane) {
  constexpr double kParallel = 1e-4;  // 1 − cos: 0.8 degrees
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < fan.triangle.size(); ++i) {
    const OffsetPlane& own = plane[fan.triangle[i]];
    planes.push_back({own.normal, own.way, i, 1});
  }
  while (planes.size() > 3) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < planes.size(); ++i)
      if (const double c = planes[i].normal.dot(planes[(i + 1) % planes.size()].normal); c > most) {
        most = c;
        best = i;
      }
    if (most < 1 - kParallel && planes.size() <= kMostPlanes) break;
    const std::size_t next = (best + 1) % planes.size();
    Plane& one = planes[best];
    const Plane& other = planes[next];
    one.normal = (double(one.count) * one.normal + double(other.count) * other.normal).stableNormalized();
    one.way =
        (double(one.count) * one.way + double(other.count) * other.way) / double(one.count + other.count);
    one.count += other.count;
    planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(next));
  }
  return planes;
}

// m in three planes.
std::optional<Vec3> meetingPoint(const std::vector<Plane>& planes, const Triple& t) {
  Eigen::Matrix3d a;
  for (int k = 0; k < 3; ++k) a.row(k) = planes[t[k]].normal.transpose();
  constexpr double kFlat = 1e-6;
  if (std::abs(a.determinant()) < kFlat) return std::nullopt;
  const Vec3 m = a.inverse() * Vec3(planes[t[0]].way, planes[t[1]].way, planes[t[2]].way);
  if (!(m.norm() <= kMitreLimit)) return std::nullopt;
  return m;
}

// Offset vertices in the place of one, in terms of m, and those at each triangle of the fan, in the order
// from the triangle after it to the one before it.
struct Corner {
  std::vector<Vec3> m;
  std::vector<std::vector<int>> chain;
};

class CornerMaker {
 public:
  CornerMaker(const Fan& fan, std::span<const OffsetPlane> plane, const Vec3& single)
      : fan_(fan), plane_(plane), single_(single), planes_(planesOf(fan, plane)) {}

  /// Triangulations whose points there are, those first whose points are nearest to the single copy.
  [[nodiscard]] std::vector<const Triangulation*> candidates() {
    std::vector<std::pair<double, const Triangulation*>> found;
    for (const Triangulation& t : triangulations(planes_.size())) {
      double way = 0;
      const bool is = std::all_of(t.begin(), t.end(), [&](const Triple& triple) {
        const std::optional<Vec3>& p = pointOf(triple);
        if (p) way += (*p - single_).squaredNorm();
        return p.has_value();
      });
      if (is) found.emplace_back(way, &t);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const Triangulation*> sorted;
    for (const auto& [way, t] : found) sorted.push_back(t);
    return sorted;
  }

  [[nodiscard]] Corner corner(const Triangulation& t) {
    std::vector<Vec3> m;
    for (const Triple& triple : t) m.push_back(*pointOf(triple));
    return cornerOf(t, m);
  }

  /// The farthest that any vertex of a corner is off from a plane that it is on, in r.
  [[nodiscard]] double errorOf(const Corner& corner) const {
    double most = 0;
    for (std::size_t i = 0; i < corner.chain.size(); ++i)
      for (const int c : corner.chain[i])
        most = std::max(most, offFrom(plane_[fan_.triangle[i]], corner.m[c]));
    return most;
  }

 private:
  const std::optional<Vec3>& pointOf(const Triple& t) {
    const std::size_t key = (t[0] * kMostPlanes + t[1]) * kMostPlanes + t[2];
    if (!std::exchange(known_[key], std::uint8_t{1})) points_[key] = meetingPoint(planes_, t);
    return points_[key];
  }

  [[nodiscard]] Corner cornerOf(const Triangulation& t, const std::vector<Vec3>& m) const {
    // Vertices that are nearly at one place are one: an edge so short is a needle of a triangle.
    constexpr double kNear = 0.01;  // of r
    UnionFind same(t.size());
    for (std::size_t i = 0; i < t.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (sharePlanes(t[i], t[j]) && (m[i] - m[j]).norm() < kNear)
          same.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
    Corner corner;
    std::vector<int> number(t.size(), -1), count;
    for (std::size_t i = 0; i < t.size(); ++i) {
      int& own = number[same.root(static_cast<std::uint32_t>(i))];
      if (own < 0) {
        own = static_cast<int>(corner.m.size());
        corner.m.push_back(Vec3::Zero());
        count.push_back(0);
      }
      corner.m[own] += m[i];
      ++count[own];
    }
    for (std::size_t i = 0; i < count.size(); ++i) corner.m[i] /= count[i];
    corner.chain.resize(fan_.triangle.size());
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      std::vector<int> chain;
      for (const std::size_t i : trianglesAt(t, static_cast<int>(p)))
        if (const int c = number[same.root(static_cast<std::uint32_t>(i))];
            chain.empty() || chain.back() != c)
          chain.push_back(c);
      share(planes_[p], chain, corner);
    }
    return corner;
  }

  [[nodiscard]] static bool sharePlanes(const Triple& a, const Triple& b) {
    int shared = 0;
    for (const int x : a) shared += x == b[0] || x == b[1] || x == b[2];
    return shared == 2;
  }

  // The triangles of a triangulation at one corner of the polygon, from its next side to its last.
  [[nodiscard]] std::vector<std::size_t> trianglesAt(const Triangulation& t, int corner) const {
    const int n = static_cast<int>(planes_.size());
    std::vector<std::pair<int, std::size_t>> at;
    for (std::size_t i = 0; i < t.size(); ++i) {
      int nearest = n;
      bool has = false;
      for (const int x : t[i]) {
        if (x == corner)
          has = true;
        else
          nearest = std::min(nearest, (x - corner + n) % n);
      }
      if (has) at.emplace_back(nearest, i);
    }
    std::sort(at.begin(), at.end());
    std::vector<std::size_t> ids;
    for (const auto& [nearest, i] : at) ids.push_back(i);
    return ids;
  }

  // Hands a chain out to the triangles of a plane: all of it to the one with the widest angle, its ends to
  // the others.
  void share(const Plane& plane, const std::vector<int>& chain, Corner& corner) const {
    const std::size_t n = fan_.triangle.size(), whole = plane.count / 2;
    for (std::size_t i = 0; i < plane.count; ++i) {
      auto& own = corner.chain[(plane.first + i) % n];
      if (i == whole)
        own = chain;
      else
        own = {i < whole ? chain.back() : chain.front()};
    }
  }

  const Fan& fan_;
  std::span<const OffsetPlane> plane_;
  Vec3 single_;
  std::vector<Plane> planes_;
  static constexpr std::size_t kTriples = kMostPlanes * kMostPlanes * kMostPlanes;
  std::array<std::optional<Vec3>, kTriples> points_;  // where three planes meet, as far as asked for
  std::array<std::uint8_t, kTriples> known_{};
};

// The triangulation of a small plane polygon with the shortest chords whose triangles all face along
// `normal`; empty where there is none.
std::vector<std::array<int, 3>> triangulated(const std::vector<Vec3>& p, const Vec3& normal) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr double kThinnest = 1e-6;  // altitude over longest edge
  const int n = static_cast<int>(p.size());
  std::vector<double> cost(n * n, 0);
  std::vector<int> apex(n * n, -1);
  const auto faces = [&](int a, int b, int c) {
    const Vec3 &x = p[a], &y = p[b], &z = p[c];
    const double longest = std::max({(y - x).squaredNorm(), (z - y).squaredNorm(), (x - z).squaredNorm()});
    return (y - x).cross(z - x).dot(normal) > kThinnest * longest;
  };
  for (int length = 2; length < n; ++length)
    for (int i = 0; i + length < n; ++i) {
      const int j = i + length;
      double& best = cost[i * n + j];
      best = kInfinite;
      for (int k = i + 1; k < j; ++k) {
        const double sum = cost[i * n + k] + cost[k * n + j];
        if (sum < best && faces(i, k, j)) {
          best = sum;
          apex[i * n + j] = k;
        }
      }
      best += (p[i] - p[j]).norm();
    }
  std::vector<std::array<int, 3>> triangles;
  if (!(cost[n - 1] < kInfinite)) return triangles;
  std::vector<std::pair<int, int>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const int k = apex[i * n + j];
    if (k < 0) continue;
    triangles.push_back({i, k, j});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

// The shell of one side of S, of which corners are divided or cut.
class CornerDivider {
 public:
  CornerDivider(SweptMesh& mesh, std::span<const Vec3> faceNormal, std::span<const OffsetPlane> plane,
                const VertexTriangles& around, std::size_t firstCopy, double sign)
      : mesh_(mesh), normal_(faceNormal), plane_(plane), around_(around), firstCopy_(firstCopy), sign_(sign) {
    listCopied();
  }

  void divide(VertexId v) {
    const std::optional<Fan> fan = copiedFan(v);
    if (!fan || !fan->isClosed()) return cut(v);
    const Vec3 single = mesh_.copies[firstCopy_ + v].offset / (sign_ * mesh_.thickness.at(v));
    CornerMaker maker(*fan, plane_, single);
    double before = 0;
    for (const TriangleId s : fan->triangle) before = std::max(before, offFrom(plane_[s], single));
    Surroundings surroundings(*this, v, *fan);
    const auto most = surroundings.meetings(chainsAt(v, *fan));
    if (!most) return;
    constexpr std::size_t kMostTried = 8;
    std::size_t tried = 0;
    for (const Triangulation* candidate : maker.candidates()) {
      const Corner corner = maker.corner(*candidate);
      if (maker.errorOf(corner) > before / 2) continue;
      const std::size_t copies = mesh_.copies.size();
      const Copy old = mesh_.copies[firstCopy_ + v];
      const auto chains = put(v, *fan, corner);
      const auto meet = surroundings.meetings(chains);
      if (meet && *meet <= *most) {
        take(v, *fan, chains);
        single_.emplace(v, old);
        return;
      }
      takeBack(copies);
      mesh_.copies[firstCopy_ + v] = old;
      if (meet && ++tried == kMostTried) break;
    }
    cut(v);
  }

  // Puts a copy on each edge around `v`, in both its planes: what is off at `v` goes no farther.
  void cut(VertexId v) {
    if (around_.of(v).empty()) return;
    const std::optional<Fan> fan = fanOf(mesh_.triangles, around_.of(v), v);
    const auto own = chainsAt(v, *fan);
    Surroundings surroundings(*this, v, *fan);
    const auto most = surroundings.meetings(own);
    if (!most) return;
    constexpr double kAway[] = {0.5, 1, 2};  // r
    for (const double away : kAway) {
      const std::size_t copies = mesh_.copies.size();
      if (const auto chains = withCuts(v, *fan, own, away)) {
        if (const auto meet = surroundings.meetings(*chains); meet && *meet <= *most) {
          take(v, *fan, *chains);
          return;
        }
      }
      takeBack(copies);
    }
  }

  // Whether what was made at the vertex can be undone.
  [[nodiscard]] bool canUndo(VertexId v) const {
    const auto around = around_.of(v);
    return std::all_of(around.begin(), around.end(),
                       [&](TriangleId s) { return !chains_.contains(s) || isCopied(s); });
  }

  // Puts the copy that was there before in the place of those that a vertex got.
  void undo(VertexId v) {
    const auto own = static_cast<std::uint32_t>(firstCopy_ + v);
    for (const TriangleId s : around_.of(v)) {
      const auto it = chains_.find(s);
      if (it == chains_.end()) continue;
      Chain& chain = it->second[cornerOf(s, v)];
      if (chain.size() == 1 && chain.front() == own) continue;
      for (const std::uint32_t i : chain) mesh_.copies[i].dropped = i != own;
      chain = {own};
      changed_.insert(s);
    }
    if (const auto it = single_.find(v); it != single_.end()) mesh_.copies[own] = it->second;
  }

  // Puts the polygons of the divided corners into the mesh, and lists their copies.
  void finish(std::vector<std::uint32_t>& copies) {
    std::vector<TriangleId> changed(changed_.begin(), changed_.end());
    std::sort(changed.begin(), changed.end());
    std::vector<std::uint8_t> removed(mesh_.triangles.size(), 0);
    for (const TriangleId s : changed) {
      std::vector<VertexId> polygon;
      std::vector<Vec3> p;
      for (const auto& chain : chains_.at(s))
        for (const std::uint32_t i : chain) {
          copies.push_back(i);
          polygon.push_back(mesh_.vertexOf(i));
          p.push_back(placeOf(i));
        }
      std::size_t put = 0;
      for (const auto& [a, b, c] : triangulated(p, normal_[s])) {
        Triangle t{polygon[a], polygon[b], polygon[c]};
        if (sign_ < 0) std::swap(t[1], t[2]);
        if (put < copied_[s].size())
          mesh_.triangles[copied_[s][put++]] = t;
        else
          mesh_.add(t, Region::kShell, s);
      }
      for (; put < copied_[s].size(); ++put) removed[copied_[s][put]] = 1;
    }
    if (std::find(removed.begin(), removed.end(), 1) != removed.end()) {
      removed.resize(mesh_.triangles.size(), 0);
      mesh_.remove(removed);
    }
    changed_.clear();
    listCopied();
  }

  // To be called when the triangles of the mesh have changed.
  void listCopied() {
    copied_.assign(mesh_.surfaceTriangles, {});
    for (std::size_t t = mesh_.surfaceTriangles; t < mesh_.triangles.size(); ++t)
      if (const TriangleId s = mesh_.above[t]; s != kNone && isOfThisShell(mesh_.triangles[t]))
        copied_[s].push_back(static_cast<TriangleId>(t));
  }

 private:
  using Chain = std::vector<std::uint32_t>;  // copies
  using Chains = std::array<Chain, 3>;       // at the corners of a triangle of S, in its sense

  [[nodiscard]] bool isOfThisShell(const Triangle& t) const {
    return mesh_.shells == 1 ||
           (mesh_.copyOf(t[0]).offset.dot(mesh_.copies[firstCopy_ + mesh_.copyOf(t[0]).base].offset) > 0);
  }

  [[nodiscard]] Vec3 placeOf(std::size_t copy) const {
    const Copy& c = mesh_.copies[copy];
    return mesh_.positions[c.base] + c.depth * c.offset;
  }

  [[nodiscard]] Chains chainsOf(TriangleId s) const {
    if (const auto it = chains_.find(s); it != chains_.end()) return it->second;
    Chains chains;
    for (int k = 0; k < 3; ++k) chains[k] = {static_cast<std::uint32_t>(firstCopy_ + mesh_.triangles[s][k])};
    return chains;
  }

  // Whether all that the triangle was copied to is there, with no other vertices.
  [[nodiscard]] bool isCopied(TriangleId s) const {
    if (changed_.contains(s)) return true;
    const Chains chains = chainsOf(s);
    Chain all;
    for (const Chain& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
    if (copied_[s].size() + 2 != all.size()) return false;
    return std::all_of(copied_[s].begin(), copied_[s].end(), [&](TriangleId t) {
      return std::all_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), [&](VertexId x) {
        return std::find(all.begin(), all.end(), x - mesh_.surfaceVertices) != all.end();
      });
    });
  }

  // The fan of a vertex whose triangles are all copied.
  [[nodiscard]] std::optional<Fan> copiedFan(VertexId v) const {
    const auto around = around_.of(v);
    if (around.empty() ||
        !std::all_of(around.begin(), around.end(), [&](TriangleId s) { return isCopied(s); }))
      return std::nullopt;
    Fan fan = fanOf(mesh_.triangles, around, v);
    if (fan.triangle.size() != around.size()) return std::nullopt;
    return fan;
  }

  [[nodiscard]] int cornerOf(TriangleId s, VertexId v) const {
    const Triangle& t = mesh_.triangles[s];
    return t[0] == v ? 0 : t[1] == v ? 1 : 2;
  }

  // The copies of `v` at each triangle of its fan.
  [[nodiscard]] std::vector<Chain> chainsAt(VertexId v, const Fan& fan) const {
    std::vector<Chain> chains;
    for (const TriangleId s : fan.triangle) chains.push_back(chainsOf(s)[cornerOf(s, v)]);
    return chains;
  }

  std::uint32_t add(VertexId v, const Vec3& offset, double safety) {
    Copy c;
    c.base = v;
    c.offset = offset;
    c.length = offset.norm();
    c.safety = safety;
    c.exact = true;
    mesh_.copies.push_back(c);
    mesh_.positions.push_back(mesh_.positions[v]);
    return static_cast<std::uint32_t>(mesh_.copies.size() - 1);
  }

  void takeBack(std::size_t copies) {
    mesh_.copies.resize(copies);
    mesh_.positions.resize(mesh_.surfaceVertices + copies);
  }

  // Copies for a corner, the first in the place of the single one.
  std::vector<Chain> put(VertexId v, const Fan& fan, const Corner& corner) {
    std::vector<double> safety(corner.m.size(), 1);
    for (std::size_t i = 0; i < fan.triangle.size(); ++i)
      for (const int c : corner.chain[i])
        safety[c] = std::min(safety[c], normal_[fan.triangle[i]].dot(corner.m[c]) / corner.m[c].norm());
    Chain id;
    for (std::size_t c = 0; c < corner.m.size(); ++c)
      id.push_back(add(v, sign_ * mesh_.thickness.at(v) * corner.m[c], safety[c]));
    mesh_.copies[firstCopy_ + v] = mesh_.copies.back();
    takeBack(mesh_.copies.size() - 1);
    id.back() = static_cast<std::uint32_t>(firstCopy_ + v);
    std::vector<Chain> chains(fan.triangle.size());
    for (std::size_t i = 0; i < chains.size(); ++i)
      for (const int c : corner.chain[i]) chains[i].push_back(id[c]);
    return chains;
  }

  // The chains with another copy at either end, `away` · r along the edges or more where the copies of `v`
  // are as far along. Nothing where all edges are too short for that.
  std::optional<std::vector<Chain>> withCuts(VertexId v, const Fan& fan, std::vector<Chain> chains,
                                             double away) {
    constexpr double kMostShare = 0.45;  // of an edge, which may be cut from its other end, too
    constexpr double kBeyond = 1.25;     // of what the copies of v are along
    const std::size_t n = fan.triangle.size();
    const double r = mesh_.thickness.at(v);
    bool any = false;
    for (std::size_t i = fan.isClosed() ? 0 : 1; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      if (!isCopied(fan.triangle[before]) || !isCopied(fan.triangle[i])) continue;
      const OffsetPlane &one = plane_[fan.triangle[before]], &other = plane_[fan.triangle[i]];
      const Vec3 &a = one.normal, &b = other.normal;
      const Vec3 m = (one.way + other.way) / 2 * (a + b) / (1 + a.dot(b));
      const Vec3 edge = mesh_.positions[fan.ring[i]] - mesh_.positions[v];
      const double length = edge.norm();
      double at = away * r;
      for (const std::uint32_t c : chains[i])
        at = std::max(at, kBeyond * (placeOf(c) - mesh_.positions[v]).dot(edge) / length);
      if (!(m.norm() <= kMitreLimit) || at > kMostShare * length) continue;
      any = true;
      const double there = r + at / length * (mesh_.thickness.at(fan.ring[i]) - r);
      const Vec3 offset = sign_ * there * m + (at / length) * edge;
      const std::uint32_t id = add(v, offset, there / offset.norm());
      chains[i].push_back(id);
      chains[before].insert(chains[before].begin(), id);
    }
    if (!any) return std::nullopt;
    return chains;
  }

  void take(VertexId v, const Fan& fan, const std::vector<Chain>& chains) {
    for (std::size_t i = 0; i < fan.triangle.size(); ++i) {
      const TriangleId s = fan.triangle[i];
      if (!isCopied(s)) continue;
      Chains all = chainsOf(s);
      all[cornerOf(s, v)] = chains[i];
      chains_[s] = std::move(all);
      changed_.insert(s);
    }
  }

  // What the triangles around one vertex are copied to must not meet: S there, and the copies of the
  // triangles that only share a vertex with them.
  class Surroundings {
   public:
    Surroundings(const CornerDivider& shell, VertexId v, const Fan& fan) : shell_(shell), v_(v), fan_(fan) {
      std::vector<TriangleId> near;
      for (const VertexId u : fan.ring)
        near.insert(near.end(), shell.around_.of(u).begin(), shell.around_.of(u).end());
      sortUnique(near);
      tooMany_ = near.size() > kMost;
      if (tooMany_) return;
      constexpr std::uint64_t kOfSurface = std::uint64_t{1} << 32;
      for (const TriangleId s : near) {
        Triangle t{};
        for (int k = 0; k < 3; ++k) {
          const VertexId x = shell.mesh_.triangles[s][k];
          t[k] = vertex(kOfSurface + x, shell.mesh_.positions[x]);
        }
        triangles_.push_back(t);
        if (std::find(fan.triangle.begin(), fan.triangle.end(), s) == fan.triangle.end() && shell.isCopied(s))
          addCopy(s, shell.chainsOf(s));
      }
      for (const Triangle& t : triangles_) boxes_.push_back(boxOf(t));
      fresh_.clear();
    }

    // How often the copies of the fan meet these and each other with `chains` at its vertex; nothing where
    // one is folded over, or there are too many to look at.
    std::optional<std::size_t> meetings(const std::vector<Chain>& chains) {
      if (tooMany_) return std::nullopt;
      const std::size_t near = triangles_.size();
      bool folded = false;
      for (std::size_t i = 0; i < fan_.triangle.size() && !folded; ++i) {
        const TriangleId s = fan_.triangle[i];
        if (!shell_.isCopied(s)) continue;
        Chains all = shell_.chainsOf(s);
        all[shell_.cornerOf(s, v_)] = chains[i];
        folded = !addCopy(s, all);
      }
      std::size_t count = 0;
      for (std::size_t i = near; i < triangles_.size() && !folded; ++i) {
        const Box box = boxOf(triangles_[i]);
        for (std::size_t j = 0; j < i; ++j)
          if (box.intersects(boxes_[j]) && exact::meet(at_, triangles_[i], triangles_[j])) ++count;
        boxes_.push_back(box);
      }
      triangles_.resize(near);
      boxes_.resize(near);
      for (const std::uint64_t key : fresh_) number_.erase(key);
      fresh_.clear();
      if (folded) return std::nullopt;
      return count;
    }

   private:
    using Box = Eigen::AlignedBox3d;
    static constexpr std::size_t kMost = 128;  // triangles of S

    [[nodiscard]] Box boxOf(const Triangle& t) const {
      Box box(at_[t[0]]);
      return box.extend(at_[t[1]]).extend(at_[t[2]]);
    }

    VertexId vertex(std::uint64_t key, const Vec3& p) {
      const auto [it, isNew] = number_.emplace(key, static_cast<VertexId>(at_.size()));
      if (isNew) {
        at_.push_back(p);
        fresh_.push_back(key);
      }
      return it->second;
    }

    // Adds the polygon that a triangle of S is copied to; false where it is folded over.
    bool addCopy(TriangleId s, const Chains& chains) {
      std::vector<VertexId> polygon;
      std::vector<Vec3> p;
      for (const Chain& chain : chains)
        for (const std::uint32_t c : chain) {
          p.push_back(shell_.placeOf(c));
          polygon.push_back(vertex(c, p.back()));
        }
      const auto triangles = triangulated(p, shell_.normal_[s]);
      for (const auto& [a, b, c] : triangles) triangles_.push_back({polygon[a], polygon[b], polygon[c]});
      return !triangles.empty();
    }

    const CornerDivider& shell_;
    VertexId v_;
    const Fan& fan_;
    bool tooMany_ = false;
    std::vector<Vec3> at_;
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;
    std::unordered_map<std::uint64_t, VertexId> number_;
    std::vector<std::uint64_t> fresh_;  // keys that were added for the fan
  };

  SweptMesh& mesh_;
  std::span<const Vec3> normal_;
  std::span<const OffsetPlane> plane_;
  const VertexTriangles& around_;
  std::size_t firstCopy_;
  double sign_;
  std::vector<std::vector<TriangleId>> copied_;  // per triangle of S: what it is copied to
  std::unordered_map<TriangleId, Chains> chains_;
  std::unordered_set<TriangleId> changed_;
  std::unordered_map<VertexId, Copy> single_;  // that a corner took the place of
};

}  // namespace

// Whether an edge at `v` is longer than `length`.
bool hasLongEdge(const SweptMesh& mesh, std::span<const TriangleId> around, VertexId v, double length) {
  return std::any_of(around.begin(), around.end(), [&](TriangleId t) {
    return std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), [&](VertexId u) {
      return (mesh.positions[u] - mesh.positions[v]).squaredNorm() > length * length;
    });
  });
}

// Around shorter edges, in r, the triangles that are off are small anyway.
constexpr double kLong = 2;

struct Corners::Impl {
  SweptMesh& mesh;
  std::span<const std::vector<OffsetPlane>> plane;
  const VertexTriangles& around;
  std::vector<CornerDivider> shells;
  std::vector<std::uint8_t> cut;       ///< per copy that is single: whether it was
  std::vector<std::uint32_t> changed;  ///< copies
};

Corners::Corners(SweptMesh& mesh, std::span<const Vec3> faceNormal,
                 std::span<const std::vector<OffsetPlane>> plane, const VertexTriangles& around)
    : impl_(std::make_unique<Impl>(Impl{mesh, plane, around, {}, {}, {}})) {
  for (std::size_t shell = 0; shell < mesh.shells; ++shell)
    impl_->shells.emplace_back(mesh, faceNormal, plane[shell], around, shell * mesh.surfaceVertices,
                               shell == 0 ? -1 : 1);
  impl_->cut.assign(mesh.shells * mesh.surfaceVertices, 0);
}

Corners::~Corners() = default;

void Corners::divide(double tolerance, std::span<const std::uint8_t> single) {
  SweptMesh& mesh = impl_->mesh;
  for (std::size_t shell = 0; shell < mesh.shells; ++shell) {
    CornerDivider& divider = impl_->shells[shell];
    for (VertexId v = 0; v < mesh.surfaceVertices; ++v) {
      const Copy& c = mesh.copies[shell * mesh.surfaceVertices + v];
      if (single[v] || c.dropped || c.safety < kLeastSafety) continue;
      const double r = mesh.thickness.at(v);
      const Vec3 m = c.offset / ((shell == 0 ? -1 : 1) * r);
      const auto fan = impl_->around.of(v);
      if (std::none_of(fan.begin(), fan.end(),
                       [&](TriangleId s) { return offFrom(impl_->plane[shell][s], m) > tolerance; }))
        continue;
      if (!hasLongEdge(mesh, fan, v, kLong * r)) continue;
      divider.divide(v);
      impl_->cut[shell * mesh.surfaceVertices + v] = 1;
    }
    divider.finish(impl_->changed);
  }
}

bool Corners::undo(std::span<const VertexId> vertices) {
  for (CornerDivider& divider : impl_->shells) {
    divider.listCopied();
    if (!std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return divider.canUndo(v); }))
      return false;
  }
  for (CornerDivider& divider : impl_->shells) {
    divider.listCopied();
    for (const VertexId v : vertices) divider.undo(v);
    divider.finish(impl_->changed);
  }
  return true;
}

std::vector<std::uint32_t> Corners::takeChanged() {
  sortUnique(impl_->changed);
  std::erase_if(impl_->changed, [&](std::uint32_t i) { return impl_->mesh.copies[i].dropped; });
  return std::exchange(impl_->changed, {});
}

void Corners::cutShort(std::span<const double> depth) {
  constexpr double kShort = 0.9;  // of the depth that was free
  SweptMesh& mesh = impl_->mesh;
  for (std::size_t shell = 0; shell < mesh.shells; ++shell) {
    CornerDivider& divider = impl_->shells[shell];
    divider.listCopied();
    for (VertexId v = 0; v < mesh.surfaceVertices; ++v) {
      const std::size_t i = shell * mesh.surfaceVertices + v;
      if (mesh.copies[i].dropped || mesh.copies[i].depth >= kShort * depth[i] ||
          std::exchange(impl_->cut[i], std::uint8_t{1}) ||
          !hasLongEdge(mesh, impl_->around.of(v), v, kLong * mesh.thickness.at(v)))
        continue;
      divider.cut(v);
    }
    divider.finish(impl_->changed);
  }
}

}  // namespace thicken
