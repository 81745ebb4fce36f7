// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/polygon_triangulator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "exact/predicates.h"

namespace thicken::io {
namespace {

// A polygon of more corners is no drawing but a broken or malicious file; the scratch memory per
// corner is some 30 times what a corner takes in a file.
constexpr std::size_t kMostCorners = 1'000'000;
// In grid cells and corners looked at, over all polygons of a file: 3 s to 15 s.
constexpr std::uint64_t kMostWork = 400'000'000;

double doubledArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).norm();
}

}  // namespace

int PolygonTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return exact::orientation2(points_[a], points_[b], points_[c], 2);
}

// Fills points_. The coordinates are scaled by a power of two, which is exact, so that no product
// of them over- or underflows. False when the polygon has no normal.
bool PolygonTriangulator::project(std::span<const VertexId> polygon) {
  points_.clear();
  double largest = 0;
  for (const VertexId v : polygon) {
    if (!positions_[v].allFinite()) return false;
    largest = std::max(largest, positions_[v].cwiseAbs().maxCoeff());
  }
  const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
  const auto scaled = [exponent](double x) { return std::ldexp(x, exponent); };
  for (const VertexId v : polygon) points_.push_back(positions_[v].unaryExpr(scaled));

  Vec3 normal = Vec3::Zero();  // twice the area vector (Newell)
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    normal += (points_[i] - points_[0]).cross(points_[i + 1] - points_[0]);
  }
  int axis = 0;
  if (normal.cwiseAbs().maxCoeff(&axis) == 0) return false;
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const bool flipped = normal[axis] < 0;
  for (Vec3& p : points_) p = flipped ? Vec3(p[y], p[x], 0) : Vec3(p[x], p[y], 0);
  return true;
}

// Of the diagonals that stay inside, the one that gives the smaller area in space, or the shorter
// one when the quad is flat.
void PolygonTriangulator::appendQuad(std::span<const VertexId> quad, std::vector<Triangle>& triangles) {
  bool second = false;  // from corner 1 to corner 3
  if (project(quad)) {
    const bool firstFits = turn(0, 1, 2) > 0 && turn(0, 2, 3) > 0;
    const bool secondFits = turn(1, 2, 3) > 0 && turn(1, 3, 0) > 0;
    second = secondFits && !firstFits;
    if (firstFits && secondFits) {
      const auto p = [this, &quad](int k) -> const Vec3& { return positions_[quad[k]]; };
      const double firstArea = doubledArea(p(0), p(1), p(2)) + doubledArea(p(0), p(2), p(3));
      const double secondArea = doubledArea(p(1), p(2), p(3)) + doubledArea(p(1), p(3), p(0));
      constexpr double kSame = 1e-6;  // of the area: below it the quad counts as flat
      second = std::abs(firstArea - secondArea) <= kSame * firstArea
                   ? (p(3) - p(1)).squaredNorm() < (p(2) - p(0)).squaredNorm()
                   : secondArea < firstArea;
    }
  }
  if (second) {
    triangles.push_back({quad[0], quad[1], quad[3]});
    triangles.push_back({quad[1], quad[2], quad[3]});
  } else {
    triangles.push_back({quad[0], quad[1], quad[2]});
    triangles.push_back({quad[0], quad[2], quad[3]});
  }
}

void PolygonTriangulator::link(std::uint32_t previous, std::uint32_t next) {
  next_[previous] = next;
  previous_[next] = previous;
}

// Links the corners to a ring and sorts out those that are not strictly convex: only they can lie
// in the way of a cut.
void PolygonTriangulator::prepareCorners() {
  const auto n = static_cast<std::uint32_t>(points_.size());
  previous_.resize(n);
  next_.resize(n);
  reflex_.assign(n, 0);
  for (std::uint32_t i = 0; i < n; ++i) link(i, i + 1 < n ? i + 1 : 0);
  std::vector<std::uint32_t> reflex;
  for (std::uint32_t i = 0; i < n; ++i) {
    reflex_[i] = turn(previous_[i], i, next_[i]) <= 0;
    if (reflex_[i]) reflex.push_back(i);
  }
  grid_.build(points_, std::move(reflex));
}

void PolygonTriangulator::offer(std::uint32_t corner) {
  const std::uint32_t a = previous_[corner], c = next_[corner];
  heap_.push_back({(points_[a] - points_[c]).squaredNorm(), a, corner, c});
  std::push_heap(heap_.begin(), heap_.end());
}

void PolygonTriangulator::offerAll(std::uint32_t from) {
  std::uint32_t corner = from;
  do {
    offer(corner);
    corner = next_[corner];
  } while (corner != from);
}

// From now on `corner` is in no cut's way.
void PolygonTriangulator::clearWay(std::uint32_t corner) {
  if (reflex_[corner]) grid_.remove(corner);
  reflex_[corner] = 0;
}

bool PolygonTriangulator::blocks(const Cut& cut, std::uint32_t corner, bool borderToo) const {
  if (corner == cut.previous || corner == cut.corner || corner == cut.next) return false;
  // Where a hole is bridged, corners of the ear come back as other corners of the polygon.
  for (const std::uint32_t own : {cut.previous, cut.corner, cut.next}) {
    if (points_[own] == points_[corner]) return false;
  }
  const int least = borderToo ? 0 : 1;
  return turn(cut.previous, cut.corner, corner) >= least && turn(cut.corner, cut.next, corner) >= least &&
         turn(cut.next, cut.previous, corner) >= least;
}

bool PolygonTriangulator::passes(const Cut& cut, Rule rule) {
  if (rule == Rule::kAny) return true;
  if (turn(cut.previous, cut.corner, cut.next) <= 0) return false;
  if (rule == Rule::kConvex) return true;
  return !grid_.any({points_[cut.previous], points_[cut.corner], points_[cut.next]}, work_,
                    [&](std::uint32_t corner) { return blocks(cut, corner, rule == Rule::kEmptyEar); });
}

bool PolygonTriangulator::append(std::span<const VertexId> polygon, std::vector<Triangle>& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  if (polygon.size() == 4) {
    appendQuad(polygon, triangles);
    return true;
  }
  if (polygon.size() > kMostCorners) return false;
  if (!project(polygon)) {  // not finite or without area, which check() reports
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    }
    return true;
  }
  prepareCorners();
  heap_.clear();
  offerAll(0);
  Rule rule = Rule::kEmptyEar;
  std::uint32_t someCorner = 0;
  for (std::size_t left = polygon.size(); left > 2;) {
    if (work_ > kMostWork) return false;
    if (heap_.empty()) {
      rule = static_cast<Rule>(static_cast<int>(rule) + 1);
      offerAll(someCorner);
    }
    std::pop_heap(heap_.begin(), heap_.end());
    const Cut cut = heap_.back();
    heap_.pop_back();
    const std::uint32_t a = cut.previous, b = cut.corner, c = cut.next;
    if (next_[b] != c || previous_[b] != a) continue;  // the ring has changed since
    if (!passes(cut, rule)) continue;
    triangles.push_back({polygon[a], polygon[b], polygon[c]});
    link(a, c);
    previous_[b] = next_[b] = b;
    clearWay(b);
    someCorner = a;
    if (--left == 2) break;
    for (const std::uint32_t corner : {a, c}) {
      if (turn(previous_[corner], corner, next_[corner]) > 0) clearWay(corner);
      offer(corner);
    }
  }
  return true;
}

}  // namespace thicken::io
