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

using oracle::Point;
using oracle::Rational;

// --- an oracle that intersects in rational coordinates: triangle against segment, by definition

Point at(const Point& p, const Point& q, const Rational& t) {
  Point r;
  for (int k = 0; k < 3; ++k) r.x[k] = p.x[k] + t * (q.x[k] - p.x[k]);
  return r;
}

bool insideInPlane(const Point tri[3], const Point& x) {
  const Point n = cross(tri[1] - tri[0], tri[2] - tri[0]);
  for (int k = 0; k < 3; ++k)
    if (dot(cross(tri[(k + 1) % 3] - tri[k], x - tri[k]), n) < 0) return false;
  return true;
}

// Segment pq in the triangle's plane: clipped by the three edge half planes.
bool segmentMeetsInPlane(const Point tri[3], const Point& p, const Point& q) {
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

bool segmentMeets(const Point tri[3], const Point& p, const Point& q) {
  const Point n = cross(tri[1] - tri[0], tri[2] - tri[0]);
  const Rational f = dot(n, p - tri[0]), g = dot(n, q - tri[0]);
  if (f.sign() * g.sign() > 0) return false;
  if (f == 0 && g == 0) return segmentMeetsInPlane(tri, p, q);
  return insideInPlane(tri, at(p, q, f / (f - g)));
}

bool expectedMeet(const std::vector<Vec3>& positions, const Triangle& a, const Triangle& b) {
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
