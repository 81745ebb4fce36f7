// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/expansion.h"
#include "exact_oracle.h"

namespace thicken {
namespace {

class Predicates : public ::testing::Test {
 protected:
  double uniform(double low = -1, double high = 1) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Vec3 point(double size = 1) { return {size * uniform(), size * uniform(), size * uniform()}; }
  Vec3 nudged(const Vec3& p) {
    Vec3 q = p;
    for (int k = 0; k < 3; ++k)
      for (int steps = integer(0, 2); steps > 0; --steps) q[k] = std::nextafter(q[k], uniform() * 1e300);
    return q;
  }
  // compares all the predicates on four points; returns the sign of orientation
  static int agree(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const int expected = oracle::orientation(a, b, c, d);
    EXPECT_EQ(exact::orientation(a, b, c, d), expected);
    EXPECT_EQ(exact::orientation(b, a, c, d), -expected);
    EXPECT_EQ(exact::orientation(c, d, a, b), expected);
    bool line = true;
    for (int axis = 0; axis < 3; ++axis) {
      const int sense = oracle::orientation2(a, b, c, axis);
      EXPECT_EQ(exact::orientation2(a, b, c, axis), sense);
      EXPECT_EQ(exact::orientation2(c, b, a, axis), -sense);
      line = line && sense == 0;
    }
    EXPECT_EQ(exact::collinear(a, b, c), line);
    return expected;
  }

  std::mt19937_64 random_{1};
};

TEST_F(Predicates, OrientationIsPositiveOnTheSideOfTheNormal) {
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(exact::orientation(o, x, y, z), 1);
  EXPECT_EQ(exact::orientation(o, x, y, -z), -1);
  EXPECT_EQ(exact::orientation(o, x, y, x + y), 0);
  EXPECT_EQ(exact::orientation2(o, x, y, 2), 1);
  EXPECT_EQ(exact::orientation2(o, y, z, 0), 1);
  EXPECT_EQ(exact::orientation2(o, z, x, 1), 1);
  EXPECT_EQ(exact::orientation2(o, x, z, 1), -1);
}

TEST_F(Predicates, AgreeWithRationalsOnRandomPoints) {
  for (int i = 0; i < 2000; ++i) agree(point(), point(), point(), point());
}

TEST_F(Predicates, AgreeWithRationalsOnPointsOfVeryDifferentSize) {
  for (int i = 0; i < 2000; ++i) {
    const auto anySize = [this] { return point(std::ldexp(1.0, integer(-60, 60))); };
    agree(anySize(), anySize(), anySize(), anySize());
  }
}

TEST_F(Predicates, AgreeWithRationalsOnNearlyCoplanarPoints) {
  int zero = 0;
  for (int i = 0; i < 4000; ++i) {
    const double far = i % 2 == 0 ? 0.0 : 1000.0;  // away from the origin the differences are not exact
    const Vec3 o = far * point(), u = point(), v = point();
    const auto inPlane = [&]() -> Vec3 { return o + uniform() * u + uniform() * v; };
    zero += agree(nudged(inPlane()), nudged(inPlane()), nudged(inPlane()), nudged(inPlane())) == 0;
  }
  EXPECT_LT(zero, 4000);
}

TEST_F(Predicates, AgreeWithRationalsOnNearlyCollinearPoints) {
  for (int i = 0; i < 4000; ++i) {
    const Vec3 o = (i % 2) * 100.0 * point(), u = point();
    const auto onLine = [&]() -> Vec3 { return nudged(o + uniform() * u); };
    agree(onLine(), onLine(), onLine(), onLine());
  }
}

TEST_F(Predicates, AreZeroOnExactlyDegeneratePoints) {
  int coplanar = 0;
  for (int i = 0; i < 4000; ++i) {
    // integer combinations of integer directions are exact, and stay coplanar
    const auto whole = [this](int size) -> Vec3 {
      return Vec3(integer(-size, size), integer(-size, size), integer(-size, size));
    };
    const double unit = std::ldexp(1.0, integer(-40, 40)) * 3;
    const Vec3 o = whole(1 << 20), u = whole(1 << 10), v = whole(1 << 10);
    const auto inPlane = [&]() -> Vec3 { return unit * (o + integer(-99, 99) * u + integer(-99, 99) * v); };
    const Vec3 a = inPlane(), b = inPlane(), c = inPlane(), d = inPlane();
    EXPECT_EQ(exact::orientation(a, b, c, d), 0);
    coplanar += agree(a, b, c, d) == 0;
    const auto onLine = [&]() -> Vec3 { return unit * (o + integer(-99, 99) * u); };
    EXPECT_TRUE(exact::collinear(onLine(), onLine(), onLine()));
    EXPECT_EQ(exact::orientation(a, a, c, d), 0);
  }
  EXPECT_EQ(coplanar, 4000);
}

TEST_F(Predicates, AgreeWithRationalsOnFloatsInAGrid) {
  for (int i = 0; i < 4000; ++i) {
    const auto grid = [this]() -> Vec3 {
      return {static_cast<float>(0.1 * integer(0, 4)), static_cast<float>(0.1 * integer(0, 4)),
              static_cast<float>(0.1 * integer(0, 4))};
    };
    agree(grid(), grid(), grid(), grid());
  }
}

TEST_F(Predicates, SeeTheSmallestStepOffAPlane) {
  // no third is a double; two of the smaller neighbour and one of the larger sum to 1
  const Vec3 a(1, 0, 0), b(0, 1, 0), c(0, 0, 1);
  const double third = 1.0 / 3;
  EXPECT_EQ(exact::orientation(a, b, c, Vec3(third, third, third)), -1);  // 1/3 rounds down
  EXPECT_EQ(exact::orientation(a, b, c, Vec3(third, third, std::nextafter(third, 1))), 0);
  EXPECT_EQ(exact::orientation(a, b, c, Vec3(0.5, 0.5, 1e-200)), 1);
  EXPECT_EQ(exact::orientation(a, b, c, Vec3(0.5, 0.5, -1e-200)), -1);
}

TEST_F(Predicates, ExpansionsAddAndMultiplyExactly) {
  const auto value = [](const auto& e) {
    oracle::Rational sum = 0;
    for (int i = 0; i < e.size; ++i) sum += oracle::Rational(e.term[i]);
    return sum;
  };
  for (int i = 0; i < 2000; ++i) {
    const double a = std::ldexp(uniform(), integer(-40, 40)), b = std::ldexp(uniform(), integer(-40, 40));
    const double c = std::ldexp(uniform(), integer(-40, 40)), d = std::ldexp(uniform(), integer(-40, 40));
    const auto ab = exact::difference(a, b), cd = exact::difference(c, d);
    EXPECT_EQ(value(ab), oracle::Rational(a) - oracle::Rational(b));
    const auto product = ab * cd;
    EXPECT_EQ(value(product), value(ab) * value(cd));
    EXPECT_EQ(value(product - ab), value(product) - value(ab));
    EXPECT_EQ((product - product).sign(), 0);
    EXPECT_EQ(product.sign(), value(product).sign());
  }
}

}  // namespace
}  // namespace thicken
