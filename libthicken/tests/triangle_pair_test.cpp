// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/triangle_pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "exact/predicates.h"
#include "exact_oracle.h"

namespace thicken {
namespace {

using oracle::expectedMeet;

// --- random pairs with a given number of shared vertices

class Pairs : public ::testing::TestWithParam<int> {
 protected:
  using Source = Vec3 (*)(std::mt19937_64&);

  // Compares `count` random pairs in all orders of corners and triangles; returns how many met.
  int compare(int count, Source source) {
    int met = 0;
    for (int i = 0; i < count; ++i) {
      std::vector<Vec3> positions;
      for (int k = 0; k < 6; ++k) positions.push_back(source(random_));
      Triangle a{0, 1, 2}, b{3, 4, 5};
      for (int k = 0; k < GetParam(); ++k) b[k] = a[k];
      if (degenerate(positions, a) || degenerate(positions, b)) continue;
      const bool expected = expectedMeet(positions, a, b);
      met += expected;
      expectInEveryOrder(positions, a, b, expected);
    }
    return met;
  }

 private:
  static bool degenerate(const std::vector<Vec3>& p, const Triangle& t) {
    return exact::collinear(p[t[0]], p[t[1]], p[t[2]]);
  }
  static void expectInEveryOrder(const std::vector<Vec3>& positions, Triangle a, Triangle b, bool expected) {
    std::sort(a.begin(), a.end());
    do {
      std::sort(b.begin(), b.end());
      do {
        ASSERT_EQ(exact::meet(positions, a, b), expected);
        ASSERT_EQ(exact::meet(positions, b, a), expected);
      } while (std::next_permutation(b.begin(), b.end()));
    } while (std::next_permutation(a.begin(), a.end()));
  }

  std::mt19937_64 random_{7};
};

Vec3 anywhere(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  return {u(random), u(random), u(random)};
}
// few places, so that touching, coplanar and overlapping pairs are common
Vec3 onSmallGrid(std::mt19937_64& random) {
  std::uniform_int_distribution<int> u(0, 2);
  return {static_cast<float>(0.1 * u(random)), static_cast<float>(0.1 * u(random)),
          static_cast<float>(0.1 * u(random))};
}
Vec3 inTiltedPlane(std::mt19937_64& random) {
  std::uniform_int_distribution<int> u(-5, 5);
  return u(random) * Vec3(3, 1, -2) + u(random) * Vec3(-1, 4, 5);
}
Vec3 inAxisPlane(std::mt19937_64& random) {
  std::uniform_int_distribution<int> u(-3, 3);
  return {7, 0.3 * u(random), 0.7 * u(random)};
}
Vec3 nearPlane(std::mt19937_64& random) {
  std::uniform_int_distribution<int> u(-4, 4);
  std::uniform_real_distribution<double> noise(-1e-16, 1e-16);
  return {u(random) / 3.0, u(random) / 7.0, noise(random)};
}

TEST_P(Pairs, MeetAsTheOracleSaysAnywhere) {
  EXPECT_GT(compare(2000, anywhere), 0);
}
TEST_P(Pairs, MeetAsTheOracleSaysOnASmallGrid) {
  EXPECT_GT(compare(4000, onSmallGrid), 0);
}
TEST_P(Pairs, MeetAsTheOracleSaysInATiltedPlane) {
  EXPECT_GT(compare(2000, inTiltedPlane), 0);
}
TEST_P(Pairs, MeetAsTheOracleSaysInAnAxisPlane) {
  EXPECT_GT(compare(2000, inAxisPlane), 0);
}
TEST_P(Pairs, MeetAsTheOracleSaysNearAPlane) {
  EXPECT_GT(compare(2000, nearPlane), 0);
}

INSTANTIATE_TEST_SUITE_P(SharedVertices, Pairs, ::testing::Values(0, 1, 3));

// A shared edge meets only when it is folded shut, which random points do not do anywhere.
class PairsAtAnEdge : public Pairs {};
TEST_P(PairsAtAnEdge, MeetAsTheOracleSays) {
  EXPECT_EQ(compare(2000, anywhere), 0);
  EXPECT_GT(compare(4000, onSmallGrid), 0);
  EXPECT_GT(compare(2000, inTiltedPlane), 0);
  EXPECT_GT(compare(2000, inAxisPlane), 0);
  compare(2000, nearPlane);
}
INSTANTIATE_TEST_SUITE_P(SharedVertices, PairsAtAnEdge, ::testing::Values(2));

TEST(Meet, SaysYesToATouchAndNoToTheSmallestGap) {
  std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}, {0, 0, 1}, {1, 0, 1}};
  EXPECT_TRUE(exact::meet(p, {0, 1, 2}, {3, 4, 5}));
  p[3][2] = 1e-300;
  EXPECT_FALSE(exact::meet(p, {0, 1, 2}, {3, 4, 5}));
}

}  // namespace
}  // namespace thicken
