// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The quadric of Garland & Heckbert 1997: the sum of squared distances to planes, each with a weight.
#pragma once

#include <Eigen/Dense>

#include "thicken/mesh.h"

namespace thicken::simplify {

struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;
  double weight = 0;  ///< of all planes, mm²

  /// The plane through `point` with the unit normal `normal`.
  void add(const Vec3& normal, const Vec3& point, double planeWeight) {
    const double height = normal.dot(point);
    a += planeWeight * normal * normal.transpose();
    b -= planeWeight * height * normal;
    c += planeWeight * height * height;
    weight += planeWeight;
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    weight += other.weight;
    return *this;
  }
  /// mm² · mm²; not below 0.
  [[nodiscard]] double at(const Vec3& p) const { return std::max(0.0, p.dot(a * p) + 2 * b.dot(p) + c); }
  /// Where it is least; along directions that the planes leave open, as near to `near` as can be.
  [[nodiscard]] Vec3 leastNear(const Vec3& near) const {
    constexpr double kPull = 1e-3;  // of the planes' weight: moves the answer off a smooth surface by as much
                                    // of the height of `near` above it
    const double pull = kPull * a.trace();
    if (!(pull > 0)) return near;
    return (a + pull * Eigen::Matrix3d::Identity()).ldlt().solve(pull * near - b);
  }
};

}  // namespace thicken::simplify
