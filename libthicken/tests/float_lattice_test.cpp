// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/float_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace thicken {

using mesh::isFloat;
using mesh::roundToFloat;

namespace {

TEST(FloatLattice, RoundsToTheNearestFloat) {
  const Vec3 p = roundToFloat({0.1, -1.0 / 3, 16777217.0});
  EXPECT_EQ(p, Vec3(0.1f, -1.0f / 3, 16777216.0));
  EXPECT_NE(p[0], 0.1);
  EXPECT_TRUE(isFloat(p));
  EXPECT_FALSE(isFloat({0.1, 0, 0}));
  EXPECT_FALSE(isFloat({0, 0.1, 0}));
  EXPECT_FALSE(isFloat({0, 0, 0.1}));
}

TEST(FloatLattice, HasOneZero) {
  const Vec3 p = roundToFloat({-0.0, -1e-300, 0.0});
  for (int k = 0; k < 3; ++k) EXPECT_FALSE(std::signbit(p[k]));
}

TEST(FloatLattice, RoundsInALoopThatACompilerVectorises) {
  std::vector<Vec3> points(1000);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = Vec3(0.1, 0.7, 1.3) * static_cast<double>(i + 1);
  std::vector<Vec3> rounded(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) rounded[i] = roundToFloat(points[i]);
  for (const Vec3& p : rounded) {
    for (int k = 0; k < 3; ++k) {
      std::uint64_t bits;
      std::memcpy(&bits, &p[k], sizeof bits);
      EXPECT_EQ(bits & 0x1fffffffu, 0u);  // the 29 bits that a float does not have
    }
  }
}

}  // namespace
}  // namespace thicken
