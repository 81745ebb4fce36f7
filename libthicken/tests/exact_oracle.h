// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The same decisions as src/exact in rational numbers, written as directly as their definitions.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

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

}  // namespace thicken::oracle
