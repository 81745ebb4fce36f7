// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/corner_planes.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/offset_error.h"
#include "mesh/union_find.h"

namespace thicken::sweep {

namespace {

// All triangulations of the polygon with the corners first … last.
std::vector<PlaneTriangulation> triangulationsOf(int first, int last) {
  if (last - first < 2) return {{}};
  std::vector<PlaneTriangulation> all;
  for (int apex = first + 1; apex < last; ++apex)
    for (const PlaneTriangulation& left : triangulationsOf(first, apex))
      for (const PlaneTriangulation& right : triangulationsOf(apex, last)) {
        PlaneTriangulation t = left;
        t.push_back({first, apex, last});
        t.insert(t.end(), right.begin(), right.end());
        all.push_back(std::move(t));
      }
  return all;
}

const std::vector<PlaneTriangulation>& triangulations(std::size_t planes) {
  static const auto kAll = [] {
    std::array<std::vector<PlaneTriangulation>, kMostPlanes + 1> all;
    for (std::size_t n = 3; n <= kMostPlanes; ++n) all[n] = triangulationsOf(0, static_cast<int>(n) - 1);
    return all;
  }();
  return kAll[planes];
}

bool sharePlanes(const PlaneTriple& a, const PlaneTriple& b) {
  int shared = 0;
  for (const int x : a) shared += x == b[0] || x == b[1] || x == b[2];
  return shared == 2;
}

}  // namespace

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

double offFrom(const OffsetPlane& plane, const Vec3& m) {
  return std::abs(plane.normal.dot(m) - plane.way);
}

// The planes of a fan, those merged that are nearly parallel, and the most parallel ones where there are too
// many.
std::vector<CornerMaker::Plane> CornerMaker::planesOf(const Fan& fan, std::span<const OffsetPlane> plane) {
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
std::optional<Vec3> CornerMaker::meetingPoint(const PlaneTriple& t) const {
  Eigen::Matrix3d a;
  for (int k = 0; k < 3; ++k) a.row(k) = planes_[t[k]].normal.transpose();
  constexpr double kFlat = 1e-6;
  if (std::abs(a.determinant()) < kFlat) return std::nullopt;
  const Vec3 m = a.inverse() * Vec3(planes_[t[0]].way, planes_[t[1]].way, planes_[t[2]].way);
  if (!(m.norm() <= measure::kMitreLimit)) return std::nullopt;
  return m;
}

CornerMaker::CornerMaker(const Fan& fan, std::span<const OffsetPlane> plane, const Vec3& single)
    : fan_(fan), plane_(plane), single_(single), planes_(planesOf(fan, plane)) {}

std::vector<const PlaneTriangulation*> CornerMaker::candidates() {
  std::vector<std::pair<double, const PlaneTriangulation*>> found;
  for (const PlaneTriangulation& t : triangulations(planes_.size())) {
    double way = 0;
    const bool is = std::all_of(t.begin(), t.end(), [&](const PlaneTriple& triple) {
      const std::optional<Vec3>& p = pointOf(triple);
      if (p) way += (*p - single_).squaredNorm();
      return p.has_value();
    });
    if (is) found.emplace_back(way, &t);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const PlaneTriangulation*> sorted;
  for (const auto& [way, t] : found) sorted.push_back(t);
  return sorted;
}

Corner CornerMaker::corner(const PlaneTriangulation& t) {
  std::vector<Vec3> m;
  for (const PlaneTriple& triple : t) m.push_back(*pointOf(triple));
  return cornerOf(t, m);
}

double CornerMaker::errorOf(const Corner& corner) const {
  double most = 0;
  for (std::size_t i = 0; i < corner.chain.size(); ++i)
    for (const int c : corner.chain[i]) most = std::max(most, offFrom(plane_[fan_.triangle[i]], corner.m[c]));
  return most;
}

const std::optional<Vec3>& CornerMaker::pointOf(const PlaneTriple& t) {
  const std::size_t key = (t[0] * kMostPlanes + t[1]) * kMostPlanes + t[2];
  if (!std::exchange(known_[key], std::uint8_t{1})) points_[key] = meetingPoint(t);
  return points_[key];
}

Corner CornerMaker::cornerOf(const PlaneTriangulation& t, const std::vector<Vec3>& m) const {
  // Vertices that are nearly at one place are one: an edge so short is a needle of a triangle.
  constexpr double kNear = 0.01;  // of r
  mesh::UnionFind same(t.size());
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
      if (const int c = number[same.root(static_cast<std::uint32_t>(i))]; chain.empty() || chain.back() != c)
        chain.push_back(c);
    share(planes_[p], chain, corner);
  }
  return corner;
}

// The triangles of a triangulation at one corner of the polygon, from its next side to its last.
std::vector<std::size_t> CornerMaker::trianglesAt(const PlaneTriangulation& t, int corner) const {
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
void CornerMaker::share(const Plane& plane, const std::vector<int>& chain, Corner& corner) const {
  const std::size_t n = fan_.triangle.size(), whole = plane.count / 2;
  for (std::size_t i = 0; i < plane.count; ++i) {
    auto& own = corner.chain[(plane.first + i) % n];
    if (i == whole)
      own = chain;
    else
      own = {i < whole ? chain.back() : chain.front()};
  }
}

}  // namespace thicken::sweep
