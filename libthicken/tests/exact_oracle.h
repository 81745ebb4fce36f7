// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The same decisions as src/exact in rational numbers, written as directly as their definitions.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "thicken/mesh.h"

namespace thicken::oracle {

using Rational = boost::multiprecision::cpp_rational;

struct Point {
  Rational x[3];
};

inline Point point(const Vec3& p) {
  return {{Rational(p[0]), Rational(p[1]), Rational(p[2])}};
}

inline Point operator-(const Point& a, const Point& b) {
  return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}

inline Point cross(const Point& a, const Point& b) {
  return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
           a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

inline Rational dot(const Point& a, const Point& b) {
  return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

inline int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Point o = point(a);
  return dot(cross(point(b) - o, point(c) - o), point(d) - o).sign();
}

inline int orientation2(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const Point o = point(a);
  return cross(point(b) - o, point(c) - o).x[axis].sign();
}

// --- triangles meet where an edge of one meets the other, by definition

inline Point at(const Point& p, const Point& q, const Rational& t) {
  Point r;
  for (int k = 0; k < 3; ++k) r.x[k] = p.x[k] + t * (q.x[k] - p.x[k]);
  return r;
}

inline bool insideInPlane(const Point tri[3], const Point& x) {
  const Point n = cross(tri[1] - tri[0], tri[2] - tri[0]);
  for (int k = 0; k < 3; ++k)
    if (dot(cross(tri[(k + 1) % 3] - tri[k], x - tri[k]), n) < 0) return false;
  return true;
}

// Segment pq in the triangle's plane: clipped by the three edge half planes.
inline bool segmentMeetsInPlane(const Point tri[3], const Point& p, const Point& q) {
  const Point n = cross(tri[1] - tri[0], tri[2] - tri[0]);
  Rational low = 0, high = 1;
  for (int k = 0; k < 3; ++k) {
    const Point edge = tri[(k + 1) % 3] - tri[k];
    const Rational f = dot(cross(edge, p - tri[k]), n), g = dot(cross(edge, q - tri[k]), n);
    if (f < 0 && g < 0) return false;
    if (f < 0) low = std::max(low, Rational(f / (f - g)));
    if (g < 0) high = std::min(high, Rational(f / (f - g)));
  }
  return low <= high;
}

inline bool segmentMeets(const Point tri[3], const Point& p, const Point& q) {
  const Point n = cross(tri[1] - tri[0], tri[2] - tri[0]);
  const Rational f = dot(n, p - tri[0]), g = dot(n, q - tri[0]);
  if (f.sign() * g.sign() > 0) return false;
  if (f == 0 && g == 0) return segmentMeetsInPlane(tri, p, q);
  return insideInPlane(tri, at(p, q, f / (f - g)));
}

inline bool expectedMeet(const std::vector<Vec3>& positions, const Triangle& a, const Triangle& b) {
  Point p[3], q[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = oracle::point(positions[a[k]]);
    q[k] = oracle::point(positions[b[k]]);
  }
  std::vector<int> freeA, freeB;
  for (int k = 0; k < 3; ++k) {
    if (std::find(b.begin(), b.end(), a[k]) == b.end()) freeA.push_back(k);
    if (std::find(a.begin(), a.end(), b[k]) == a.end()) freeB.push_back(k);
  }
  switch (freeA.size()) {
    case 0:
      return true;
    case 1: {
      // shared edge: beyond it the triangles have points in common when they overlap in one plane
      const int u = freeA[0], v = freeB[0];
      const Point &s = p[(u + 1) % 3], &t = p[(u + 2) % 3];
      const Point n = cross(t - s, p[u] - s);
      if (dot(n, q[v] - s) != 0) return false;
      return dot(n, cross(t - s, q[v] - s)) > 0;
    }
    case 2:
      return segmentMeets(p, q[freeB[0]], q[freeB[1]]) || segmentMeets(q, p[freeA[0]], p[freeA[1]]);
    default:
      for (int k = 0; k < 3; ++k)
        if (segmentMeets(p, q[k], q[(k + 1) % 3]) || segmentMeets(q, p[k], p[(k + 1) % 3])) return true;
      return false;
  }
}

}  // namespace thicken::oracle
