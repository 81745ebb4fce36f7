// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/predicates.h"

#include <cmath>

#include "exact/expansion.h"

namespace thicken::exact {
namespace {

constexpr double kUlp = 0x1p-53;  // the largest relative error of one operation

// A determinant computed as below differs from the true one by less than this times the sum of
// the absolute products (Shewchuk 1997, section 4.4).
constexpr double kBound2 = (3 + 16 * kUlp) * kUlp;
constexpr double kBound3 = (7 + 56 * kUlp) * kUlp;
// What the rounding of the differences alone may change: each of the two (three) factors of a
// product has a relative error of at most one kUlp; rounded up generously.
constexpr double kTails2 = (2 + 12 * kUlp) * kUlp;
constexpr double kTails3 = (3 + 28 * kUlp) * kUlp;

int signOf(double x) {
  return (x > 0) - (x < 0);
}

template <int N>
auto determinant(const Expansion<N>& ux, const Expansion<N>& uy, const Expansion<N>& vx,
                 const Expansion<N>& vy) {
  return ux * vy - uy * vx;
}

template <int N>
auto determinant(const Expansion<N> u[3], const Expansion<N> v[3], const Expansion<N> w[3]) {
  const auto x = determinant(u[1], u[2], v[1], v[2]) * w[0];
  const auto y = determinant(u[2], u[0], v[2], v[0]) * w[1];
  const auto z = determinant(u[0], u[1], v[0], v[1]) * w[2];
  return (x + y) + z;
}

Expansion<1> single(double value) {
  return {{value}, value != 0};
}

// First exactly for the rounded differences, which is all where they are exact (as they are for
// most float data); then for the differences in full.
[[gnu::noinline]] int orientationExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                       double permanent) {
  const Vec3* const points[3] = {&b, &c, &d};
  Expansion<1> rounded[3][3];
  Expansion<2> full[3][3];
  bool exact = true;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Rounded r = twoSum((*points[i])[k], -a[k]);
      exact = exact && r.error == 0;
      rounded[i][k] = single(r.value);
      full[i][k].append(r.error);
      full[i][k].append(r.value);
    }
  }
  const auto det = determinant(rounded[0], rounded[1], rounded[2]);
  if (exact || std::abs(det.estimate()) > kTails3 * permanent) return det.sign();
  return determinant(full[0], full[1], full[2]).sign();
}

[[gnu::noinline]] int orientation2Exact(double ax, double ay, double bx, double by, double cx, double cy,
                                        double permanent) {
  const Rounded ux = twoSum(bx, -ax), uy = twoSum(by, -ay), vx = twoSum(cx, -ax), vy = twoSum(cy, -ay);
  const auto rounded = determinant(single(ux.value), single(uy.value), single(vx.value), single(vy.value));
  const bool exact = ux.error == 0 && uy.error == 0 && vx.error == 0 && vy.error == 0;
  if (exact || std::abs(rounded.estimate()) > kTails2 * permanent) return rounded.sign();
  return determinant(difference(bx, ax), difference(by, ay), difference(cx, ax), difference(cy, ay)).sign();
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double wx = d[0] - a[0], wy = d[1] - a[1], wz = d[2] - a[2];
  const double uyvz = uy * vz, uzvy = uz * vy;
  const double uzvx = uz * vx, uxvz = ux * vz;
  const double uxvy = ux * vy, uyvx = uy * vx;
  const double det = (uyvz - uzvy) * wx + (uzvx - uxvz) * wy + (uxvy - uyvx) * wz;
  const double permanent = (std::abs(uyvz) + std::abs(uzvy)) * std::abs(wx) +
                           (std::abs(uzvx) + std::abs(uxvz)) * std::abs(wy) +
                           (std::abs(uxvy) + std::abs(uyvx)) * std::abs(wz);
  // a permanent of 0 means a zero factor in every product: all points in one plane across an axis
  if (std::abs(det) > kBound3 * permanent || permanent == 0) return signOf(det);
  return orientationExact(a, b, c, d, permanent);
}

int orientation2(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const int i = axis == 2 ? 0 : axis + 1;
  const int j = axis == 0 ? 2 : axis - 1;
  const double left = (b[i] - a[i]) * (c[j] - a[j]);
  const double right = (b[j] - a[j]) * (c[i] - a[i]);
  const double det = left - right;
  const double permanent = std::abs(left) + std::abs(right);
  if (std::abs(det) > kBound2 * permanent || permanent == 0) return signOf(det);
  return orientation2Exact(a[i], a[j], b[i], b[j], c[i], c[j], permanent);
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orientation2(a, b, c, 2) == 0 && orientation2(a, b, c, 0) == 0 && orientation2(a, b, c, 1) == 0;
}

Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  Vec3 n;
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    n[axis] = determinant(difference(b[i], a[i]), difference(b[j], a[j]), difference(c[i], a[i]),
                          difference(c[j], a[j]))
                  .estimate();
  }
  return n;
}

}  // namespace thicken::exact
