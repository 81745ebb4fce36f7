// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A part of a triangle of the shell, as the proof of its error divides it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "thicken/mesh.h"

namespace thicken::measure {

using Corners = std::array<Vec3, 3>;

// A point of the shell with what S is like from there.
struct Corner {
  Vec3 at = Vec3::Zero();
  TriangleId nearest = 0;
  double distance = 0;  // mm
  bool onRim = false, onFace = false;
  double thickness = 0;  // mm
  [[nodiscard]] double excess() const { return distance - thickness; }
};

// Of the thickness that the closest points of a part ask for, mm.
struct Range {
  double least = 0, most = 0;
};

struct Part {
  std::array<Corner, 3> corner;
  bool nearEnough = false, farEnough = false;  // proved
};

inline Corners cornersOf(const Part& part) {
  return {part.corner[0].at, part.corner[1].at, part.corner[2].at};
}

inline Vec3 middleOf(const Corners& t) {
  return (t[0] + t[1] + t[2]) / 3;
}

inline double radiusOf(const Corners& t, const Vec3& middle) {
  return std::sqrt(std::max(
      {(t[0] - middle).squaredNorm(), (t[1] - middle).squaredNorm(), (t[2] - middle).squaredNorm()}));
}

inline Corners moved(const Corners& t, const Vec3& by) {
  return {t[0] + by, t[1] + by, t[2] + by};
}

inline Vec3 normalOf(const Corners& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
}

}  // namespace thicken::measure
