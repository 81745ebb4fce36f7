// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "exact/predicates.h"
#include "io/polygon_triangulator.h"

namespace thicken::io {
namespace {

std::vector<Triangle> split(const std::vector<Vec3>& corners) {
  std::vector<VertexId> polygon(corners.size());
  std::iota(polygon.begin(), polygon.end(), 0u);
  std::vector<Triangle> triangles;
  EXPECT_TRUE(PolygonTriangulator(corners).append(polygon, triangles));
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  return triangles;
}

double shoelace(const std::vector<Vec3>& p) {
  double doubled = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3 &a = p[i], &b = p[(i + 1) % p.size()];
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return doubled / 2;
}

// A triangulation of a simple polygon covers it exactly when no triangle is turned over or flat and
// the areas add up.
void expectCovers(const std::vector<Vec3>& flat, const std::vector<Triangle>& triangles) {
  const double area = shoelace(flat);
  double sum = 0;
  for (const Triangle& t : triangles) {
    EXPECT_EQ(exact::orientation2(flat[t[0]], flat[t[1]], flat[t[2]], 2), area > 0 ? 1 : -1);
    sum += shoelace({flat[t[0]], flat[t[1]], flat[t[2]]});
  }
  EXPECT_NEAR(sum, area, 1e-9 * std::abs(area));
}

// Corners around the origin at increasing angles and random distances: simple, seldom convex.
std::vector<Vec3> star(std::size_t corners, std::mt19937& random) {
  std::uniform_real_distribution<double> radius(0.2, 1);
  std::vector<Vec3> p;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double r = radius(random);
    p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
  }
  return p;
}

// Teeth as thin as the polygon has many, each as long as the comb: where a box around an ear says little.
std::vector<Vec3> slantedComb(int teeth) {
  std::vector<Vec3> p{{0, 0, 0}};
  for (int i = 0; i < teeth; ++i) {
    p.emplace_back(i + 0.5, 0.01, 0);
    p.emplace_back(i + 1.0 + teeth, teeth, 0);
  }
  p.emplace_back(teeth + 0.5, 0, 0);
  return p;
}

TEST(PolygonTriangulator, KeepsTheDentOfAConcavePolygonOpen) {
  const std::vector<Vec3> pentagon{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
  expectCovers(pentagon, split(pentagon));
  const std::vector<Vec3> reversed(pentagon.rbegin(), pentagon.rend());
  expectCovers(reversed, split(reversed));
}

TEST(PolygonTriangulator, CutsAConcaveQuadAtItsDentWhereverItBegins) {
  std::vector<Vec3> quad{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}};
  for (int turn = 0; turn < 4; ++turn) {
    expectCovers(quad, split(quad));
    std::rotate(quad.begin(), quad.begin() + 1, quad.end());
  }
}

TEST(PolygonTriangulator, SplitsABentQuadAlongTheFoldOfLessArea) {
  // Corners 0 and 2 are raised: the fold from 0 to 2 makes a ridge, the one from 1 to 3 two long flaps.
  const std::vector<Vec3> quad{{0, 0, 1}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
  const auto area = [&quad](const std::vector<Triangle>& triangles) {
    double sum = 0;
    for (const Triangle& t : triangles)
      sum += (quad[t[1]] - quad[t[0]]).cross(quad[t[2]] - quad[t[0]]).norm() / 2;
    return sum;
  };
  const double other = area({{0, 1, 2}, {0, 2, 3}}) + area({{0, 1, 3}, {1, 2, 3}}) - area(split(quad));
  EXPECT_LE(area(split(quad)), other);
}

TEST(PolygonTriangulator, CoversRandomStarsInAnyPlane) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::vector<Vec3> flat = star(5 + round % 60, random);
    const Vec3 axis = Vec3(std::sin(round), std::cos(3 * round), 0.3).normalized();
    std::vector<Vec3> tilted = flat;
    for (Vec3& p : tilted) p = Eigen::AngleAxisd(0.1 * round, axis) * p + Vec3(10, -20, 30);
    expectCovers(flat, split(tilted));
  }
}

TEST(PolygonTriangulator, MakesNoFlatTriangleOfCornersInARow) {
  // A rectangle with corners along its sides; a fan from any corner has flat triangles.
  std::vector<Vec3> rectangle;
  for (int i = 0; i < 10; ++i) rectangle.emplace_back(i, 0, 0);
  for (int i = 0; i < 5; ++i) rectangle.emplace_back(10, i, 0);
  for (int i = 10; i > 0; --i) rectangle.emplace_back(i, 5, 0);
  for (int i = 5; i > 0; --i) rectangle.emplace_back(0, i, 0);
  expectCovers(rectangle, split(rectangle));
}

TEST(PolygonTriangulator, CoversAHoleThatIsBridgedToTheOutline) {
  const std::vector<Vec3> bridged{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0},
                                  {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}};
  expectCovers(bridged, split(bridged));
}

TEST(PolygonTriangulator, SplitsTheSameAtAnyScale) {
  std::mt19937 random(2);
  const std::vector<Vec3> unit = star(40, random);
  for (const int exponent : {-1000, -300, 300, 1000}) {
    std::vector<Vec3> scaled = unit;
    for (Vec3& p : scaled) p = p.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
    EXPECT_EQ(split(scaled), split(unit)) << exponent;
  }
}

TEST(PolygonTriangulator, SplitsWhatIsNoPolygonAnyhow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  split({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});                         // bow tie
  split({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 3, 0}, {1, -1, 0}});  // crosses itself more
  split({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1.5, 1.5, 1.5}});        // on a line
  split({{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}});              // a point
  split({{0, 0, 0}, {1, 0, 0}, {nan, 1, 0}, {0, 1, 0}, {-1, 0.5, 0}});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  std::vector<Vec3> tangle(2000);
  for (Vec3& p : tangle) p = Vec3(anywhere(random), anywhere(random), anywhere(random));
  split(tangle);
}

TEST(PolygonTriangulator, CoversLargePolygonsInShortTime) {
  std::mt19937 random(4);
  for (const std::vector<Vec3>& polygon : {star(5000, random), star(100000, random), slantedComb(5000)}) {
    expectCovers(polygon, split(polygon));
  }
}

TEST(PolygonTriangulator, GivesUpOnAPolygonOfMoreThanAMillionCorners) {
  const std::vector<Vec3> corners(3, Vec3::Zero());
  std::vector<Triangle> triangles;
  EXPECT_FALSE(PolygonTriangulator(corners).append(std::vector<VertexId>(1'000'001, 0), triangles));
  EXPECT_TRUE(triangles.empty());
}

}  // namespace
}  // namespace thicken::io
