// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/closest_point.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "analytic_surfaces.h"
#include "exact_oracle.h"
#include "mesh/topology.h"

namespace thicken {
namespace {

using shapes::heightField;
using shapes::kPi;
using shapes::plane;
using shapes::sphere;

// Distance to a triangle by a dense search of its plane region and edges, sharing nothing with the
// library's: projection by barycentric coordinates, else the best of the three clamped segments.
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, w = p - a;
  Eigen::Matrix2d gram;
  gram << u.dot(u), u.dot(v), u.dot(v), v.dot(v);
  const Eigen::Vector2d st = gram.inverse() * Eigen::Vector2d(w.dot(u), w.dot(v));
  if (st[0] >= 0 && st[1] >= 0 && st[0] + st[1] <= 1) return (a + st[0] * u + st[1] * v - p).norm();
  double best = std::numeric_limits<double>::infinity();
  const auto segment = [&](const Vec3& x, const Vec3& y) {
    const double t = std::clamp((p - x).dot(y - x) / (y - x).squaredNorm(), 0.0, 1.0);
    best = std::min(best, (x + t * (y - x) - p).norm());
  };
  segment(a, b);
  segment(b, c);
  segment(c, a);
  return best;
}

double bruteForce(const TriangleMesh& s, const Vec3& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : s.triangles)
    best = std::min(best, distanceToTriangle(p, s.positions[a], s.positions[b], s.positions[c]));
  return best;
}

class ClosestPointRandom : public ::testing::TestWithParam<double> {};

TEST_P(ClosestPointRandom, AgreesWithBruteForceAtEveryScaleAndPlace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  TriangleMesh s = heightField(12, random, 0.3, 0.8);
  const double scale = GetParam();
  const Vec3 shift = scale * Vec3(50, -20, 300);  // far from the origin against the size
  for (Vec3& p : s.positions) p = scale * p + shift;
  const ClosestPointTree tree(s);
  for (int i = 0; i < 2000; ++i) {
    const double reach = i % 3 == 0 ? 10 : 0.7;
    const Vec3 p =
        shift + scale * (Vec3(0.5, 0.5, 0) + reach * Vec3(unit(random), unit(random), unit(random)));
    const double expected = bruteForce(s, p);
    const auto c = tree.closest(p);
    ASSERT_TRUE(c);
    EXPECT_NEAR(c->distance, expected, 1e-9 * scale);
    EXPECT_NEAR((p - c->point).norm(), c->distance, 1e-9 * scale);
    EXPECT_DOUBLE_EQ(tree.distance(p), c->distance);
    EXPECT_DOUBLE_EQ(tree.distance(p, static_cast<TriangleId>(i % s.triangles.size())), c->distance);
    EXPECT_FALSE(tree.closest(p, 0.999 * expected));
    EXPECT_TRUE(tree.closest(p, 1.001 * expected));
  }
}
INSTANTIATE_TEST_SUITE_P(Scales, ClosestPointRandom, ::testing::Values(1e-3, 1.0, 1e3));

TEST(ClosestPoint, NamesFaceEdgeVertexAndRim) {
  // a roof: ridge from (0,0,1) to (2,0,1), eaves at y = ±1, z = 0
  TriangleMesh roof;
  roof.positions = {{0, -1, 0}, {2, -1, 0}, {2, 0, 1}, {0, 0, 1}, {2, 1, 0}, {0, 1, 0}};
  roof.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}};
  const ClosestPointTree tree(roof);

  const auto ridge = tree.closest({1, 0, 3});
  EXPECT_EQ(ridge->feature, Feature::kEdge);
  EXPECT_FALSE(ridge->onRim);
  EXPECT_TRUE(ridge->pseudonormal.isApprox(Vec3(0, 0, 1), 1e-12));
  EXPECT_DOUBLE_EQ(ridge->distance, 2);

  const auto face = tree.closest({1.2, -0.4, 5 * 0.5});
  EXPECT_EQ(face->feature, Feature::kEdge);  // straight above the slope the ridge is nearer

  const Vec3 slopeNormal = Vec3(0, -1, 1).normalized();
  const Vec3 onSlope(1.5, -0.5, 0.5);
  const auto slope = tree.closest(onSlope + 0.2 * slopeNormal);
  EXPECT_EQ(slope->feature, Feature::kFace);
  EXPECT_TRUE(slope->point.isApprox(onSlope, 1e-12));
  EXPECT_TRUE(slope->pseudonormal.isApprox(slopeNormal, 1e-12));

  const auto eave = tree.closest({1, -3, 0});
  EXPECT_EQ(eave->feature, Feature::kEdge);
  EXPECT_TRUE(eave->onRim);

  const auto corner = tree.closest({-1, -2, -1});
  EXPECT_EQ(corner->feature, Feature::kVertex);
  EXPECT_TRUE(corner->onRim);
  EXPECT_TRUE(corner->point.isApprox(Vec3(0, -1, 0)));
}

TEST(ClosestPoint, TakesTheLowestTriangleOfEquallyNearOnes) {
  const TriangleMesh s = plane(4, 4);
  const ClosestPointTree tree(s);
  for (VertexId v = 0; v < s.positions.size(); ++v) {
    const auto c = tree.closest(s.positions[v] + Vec3(0, 0, 1));
    const auto first = std::find_if(s.triangles.begin(), s.triangles.end(), [&](const Triangle& t) {
      return std::find(t.begin(), t.end(), v) != t.end();
    });
    EXPECT_EQ(c->triangle, static_cast<TriangleId>(first - s.triangles.begin()));
    EXPECT_EQ(c->feature, Feature::kVertex);
  }
}

TEST(ClosestPoint, AnswersManyPointsAsItAnswersOne) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const TriangleMesh s = heightField(40, random, 0.05, 0.1);
  const ClosestPointTree tree(s);
  std::uniform_int_distribution<TriangleId> any(0, static_cast<TriangleId>(s.triangles.size() - 1));
  for (int group = 0; group < 300; ++group) {
    const double spread = group % 3 == 0 ? 2 : 0.05;
    const Vec3 middle(0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random), 0.1 * unit(random));
    std::vector<ClosestPointTree::Query> queries(static_cast<std::size_t>(1 + group % 70));
    for (auto& q : queries) {
      q.point = middle + spread * Vec3(unit(random), unit(random), unit(random));
      if (group % 2 == 0) q.within = 0.05;
      if (unit(random) > 0) q.hint = any(random);
    }
    std::vector<ClosestPoint> answers(queries.size());
    tree.closest(queries, answers);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto one = tree.closest(queries[i].point, queries[i].within);
      ASSERT_EQ(one.has_value(), std::isfinite(answers[i].distance));
      if (!one) continue;
      EXPECT_EQ(one->triangle, answers[i].triangle);
      EXPECT_EQ(one->distance, answers[i].distance);
      EXPECT_EQ(one->point, answers[i].point);
      EXPECT_EQ(one->pseudonormal, answers[i].pseudonormal);
      EXPECT_EQ(one->onRim, answers[i].onRim);
    }
  }
}

TEST(ClosestPoint, MeasuresNeedlesAsTheirEdges) {
  TriangleMesh s;
  s.positions = {{0, 0, 0}, {1e4, 0, 0}, {5e3, 1e-9, 0}};
  s.triangles = {{0, 1, 2}};
  const ClosestPointTree tree(s);
  EXPECT_NEAR(tree.distance({5e3, 0, 3}), 3, 1e-9);
  EXPECT_NEAR(tree.distance({7e3, -4, 3}), 5, 1e-9);
}

// The pseudonormal of a vertex must not depend on how the fan is triangulated.
TEST(ClosestPoint, SignsAreRightAroundSharpVertices) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  // a spike: apex far above a small base, closed below
  TriangleMesh spike;
  spike.positions = {{0, 0, 10}, {1, 0, 0}, {-0.5, 0.8, 0}, {-0.5, -0.8, 0}};
  spike.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const ClosestPointTree tree(spike);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(2 * unit(random), 2 * unit(random), 6 + 6 * unit(random));
    // inside by the four planes
    bool inside = true;
    for (const auto& [a, b, c] : spike.triangles) {
      const Vec3 n = (spike.positions[b] - spike.positions[a]).cross(spike.positions[c] - spike.positions[a]);
      inside = inside && n.dot(p - spike.positions[a]) < 0;
    }
    EXPECT_EQ(signedDistance(p, *tree.closest(p)) < 0, inside) << p.transpose();
  }
}

TEST(InsideThickened, FollowsDefinition2OnAHemisphere) {
  const double radius = 10, r = 2;
  const TriangleMesh s = sphere(4, radius, [](const Vec3& p) { return p.z() > 0; });
  const ClosestPointTree tree(s);
  const auto at = [&](double distance, double elevation) {
    const Vec3 p = distance * Vec3(std::cos(elevation), 0, std::sin(elevation));
    return insideThickened(p, *tree.closest(p), r);
  };
  EXPECT_TRUE(at(9, 1.2));
  EXPECT_TRUE(at(8.1, 0.5));
  EXPECT_FALSE(at(7.9, 1.2)) << "deeper than r";
  EXPECT_FALSE(at(10.5, 1.2)) << "on the positive side";
  EXPECT_FALSE(at(9, -0.1)) << "beyond the rim";
  EXPECT_TRUE(
      insideThickened(s.positions[s.triangles[0][0]], *tree.closest(s.positions[s.triangles[0][0]]), r))
      << "S itself belongs to H";
}

// A flat obtuse triangle of whatever angle: its normal must not be tilted by the rounding of its edges. The
// expected distance is that from the plane, in rational numbers.
TEST(ClosestPoint, IsAsNearToAFlatTriangleAsItsPlaneIs) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = 10 * Vec3(unit(random), unit(random), unit(random));
    const Vec3 b = 10 * Vec3(unit(random), unit(random), unit(random));
    const Vec3 up = (b - a).cross(Vec3(unit(random), unit(random), unit(random))).normalized();
    const double width = std::pow(10, -1 - i % 6);
    TriangleMesh mesh{{a, b, (a + b) / 2 + width * up}, {{0, 1, 2}}};
    const Vec3 out = (b - a).cross(up).normalized();
    const Vec3 p = 0.45 * a + 0.55 * b + 0.3 * width * up + out;  // above the face, away from its corners
    using namespace oracle;
    const Point n = cross(point(mesh.positions[1]) - point(a), point(mesh.positions[2]) - point(a));
    const Rational height = dot(point(p) - point(a), n);
    const double expected = std::sqrt(static_cast<double>(Rational(height * height / dot(n, n))));
    ++tried;
    EXPECT_NEAR(ClosestPointTree(mesh, 1).closest(p)->distance, expected, 1e-11) << "width " << width;
  }
  EXPECT_EQ(tried, 300);
}

}  // namespace
}  // namespace thicken
