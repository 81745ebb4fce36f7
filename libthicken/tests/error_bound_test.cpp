// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/error_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analytic_surfaces.h"
#include "bvh/triangle_gap.h"
#include "jobs.h"
#include "plain_shapes.h"
#include "thicken/error.h"
#include "thicken/thicken.h"

namespace thicken {

using bvh::PreparedTriangle;
using bvh::squaredGap;
using measure::ErrorBound;

namespace {

using namespace shapes;  // NOLINT: the surfaces of the tests

ErrorBound boundOf(const TriangleMesh& surface, const TriangleMesh& solid, std::span<const Region> region,
                   double r, double tolerance, Side side = Side::kNegative, int threads = 1) {
  OwnJob own(surface, r, side);
  own.job.threads = threads;
  return measure::boundShellError(own.job, solid, region, tolerance);
}

// The regions of a slab() of a sheet.
std::vector<Region> regionsOf(const TriangleMesh& sheet, const TriangleMesh& slab) {
  std::vector<Region> region(slab.triangles.size(), Region::kWall);
  const auto n = static_cast<std::ptrdiff_t>(sheet.triangles.size());
  std::fill_n(region.begin(), n, Region::kOriginal);
  std::fill_n(region.begin() + n, n, Region::kShell);
  return region;
}

// The largest error of a dense grid of points on every triangle of the shell, without what is the wall's.
double sampledError(const TriangleMesh& surface, const Solid& solid) {
  constexpr int kSteps = 8;
  const ClosestPointTree tree(surface);
  double most = 0;
  for (std::size_t t = 0; t < solid.region.size(); ++t) {
    if (solid.region[t] != Region::kShell) continue;
    const auto& [a, b, c] = solid.mesh.triangles[t];
    const Vec3 &p = solid.mesh.positions[a], u = solid.mesh.positions[b] - p, v = solid.mesh.positions[c] - p;
    for (int i = 0; i <= kSteps; ++i)
      for (int k = 0; i + k <= kSteps; ++k) {
        const auto near = tree.closest(p + double(i) / kSteps * u + double(k) / kSteps * v);
        if (!near->onRim || near->distance > solid.report.thickness)
          most = std::max(most, std::abs(near->distance - solid.report.thickness));
      }
  }
  return most;
}

TEST(ErrorBoundSlow, IsAboveADenseSamplingByAFifthAtMost) {
  const TriangleMesh surfaces[] = {sheet(9, 7), cylinderPatch(40, 5, 2, 4), helicoid(30, 2, 1, 1.5),
                                   sphere(3, 4, [](const Vec3& p) { return p.z() > 1.3; })};
  for (const TriangleMesh& given : surfaces)
    for (const Method method : {Method::kSweep, Method::kReconstruct}) {
      const TriangleMesh s = weld(given);
      const double r = 0.4;
      Options o;
      o.thickness = r;
      o.method = method;
      o.cell = 0.15;
      o.simplify = Simplify::kOff;
      const Solid solid = ::thicken::thicken(s, o);
      const double sampled = sampledError(s, solid), tolerance = std::max(1.2 * sampled, 0.01 * r);
      const ErrorBound bound = boundOf(s, solid.mesh, solid.region, r, tolerance);
      EXPECT_GE(bound.most, sampled);
      EXPECT_LE(bound.most, tolerance);
    }
}

TEST(ErrorBound, OfAFlatSheetIsItsRounding) {
  const TriangleMesh s = flatSheet(6, 5, 0), solid = slab(s, 0.75);
  EXPECT_LT(boundOf(s, solid, regionsOf(s, solid), 0.75, 0.1).most, 1e-10);
}

TEST(ErrorBound, FindsAShellThatIsTooDeepOrTooThinInOnePlace) {
  const double r = 0.5, tolerance = 0.01;
  const TriangleMesh s = flatSheet(8, 8, 0), good = slab(s, r);
  const VertexId moved = 81 + 4 * 9 + 4;
  for (const double by : {-2 * tolerance, 2 * tolerance}) {
    TriangleMesh solid = good;
    solid.positions[moved].z() += by;
    const ErrorBound bound = boundOf(s, solid, regionsOf(s, solid), r, tolerance);
    EXPECT_GT(bound.most, tolerance);
    EXPECT_LE(bound.most, 2.01 * tolerance);
    EXPECT_LT((bound.place - solid.positions[moved]).norm(), 1);
    EXPECT_LE(boundOf(s, solid, regionsOf(s, solid), r, 2.01 * tolerance).most, 2.01 * tolerance);
  }
}

// A dent between the points that samples are taken at.
TEST(ErrorBound, SeesTheMiddleOfALargeTriangle) {
  const TriangleMesh bumpy = parametric(60, 60, [](double u, double v) {
    const double x = u - 0.41, y = v - 0.23;
    return Vec3(10 * u, 10 * v, -0.1 * std::exp(-2000 * (x * x + y * y)));
  });
  const double r = 1;
  const TriangleMesh flat = plane(1, 10), below = slab(flat, r);
  const std::vector<Region> region = regionsOf(flat, below);
  EXPECT_GT(boundOf(bumpy, below, region, r, 0.05).most, 0.05);
  const double most = boundOf(bumpy, below, region, r, 0.12).most;
  EXPECT_LE(most, 0.12);
  EXPECT_GE(most, 0.08);
}

TEST(ErrorBound, CountsNoShellThatEndsHalfwayToAFront) {
  const double r = 0.8, half = 0.5, tolerance = 0.04;
  const TriangleMesh upper = flatSheet(5, 4, 0), lower = flatSheet(5, 4, -2 * half),
                     solid = slab(upper, half);
  const std::vector<Region> region = regionsOf(upper, solid);
  const TriangleMesh sheets = together(upper, lower);
  EXPECT_LE(boundOf(sheets, solid, region, r, tolerance).most, tolerance);
  // Nothing there: merely too thin.
  EXPECT_GT(boundOf(upper, solid, region, r, tolerance).most, tolerance);
  // A back: all that is between the two is to be filled.
  const TriangleMesh backs = together(upper, reversed(lower));
  EXPECT_GT(boundOf(backs, solid, region, r, tolerance).most, tolerance);
  // Material on both sides: the other sheet's comes from there.
  EXPECT_GT(boundOf(sheets, solid, region, r, tolerance, Side::kBoth).most, tolerance);
  // Not as far as to the halfway surface, or beyond it.
  for (const double off : {-1.5 * tolerance, 1.5 * tolerance}) {
    const TriangleMesh other = slab(upper, half + off);
    EXPECT_GT(boundOf(sheets, other, region, r, tolerance).most, tolerance) << off;
  }
  for (const double off : {-0.5 * tolerance, 0.5 * tolerance}) {
    const TriangleMesh other = slab(upper, half + off);
    EXPECT_LE(boundOf(sheets, other, region, r, tolerance).most, tolerance) << off;
  }
}

TEST(ErrorBound, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh s = sheet(10, 8);
  Options o;
  o.thickness = 0.6;
  const Solid solid = ::thicken::thicken(s, o);
  const ErrorBound one = boundOf(s, solid.mesh, solid.region, 0.6, 0.02);
  const ErrorBound two = boundOf(s, solid.mesh, solid.region, 0.6, 0.02, Side::kNegative, 2);
  EXPECT_EQ(one.most, two.most);
  EXPECT_EQ(one.place, two.place);
}

TEST(ErrorBound, IsReportedOrRefusedByThicken) {
  const TriangleMesh s = plane(20, 10);
  Options o;
  o.thickness = 0.7;
  o.simplify = Simplify::kOff;  // which may use up the tolerance
  EXPECT_FALSE(::thicken::thicken(s, o).report.shellErrorBound);
  o.tolerance = 0.01;
  const Solid solid = ::thicken::thicken(s, o);
  ASSERT_TRUE(solid.report.shellErrorBound);
  EXPECT_LT(*solid.report.shellErrorBound, 1e-6);
  // Backs of two sheets that the sweep alone cannot fill the space between.
  TriangleMesh high = plane(12, 6), low = reversed(high);
  for (Vec3& p : low.positions) p.z() -= 0.5;
  o.method = Method::kSweep;
  try {
    (void)::thicken::thicken(together(high, low), o);
    ADD_FAILURE() << "was not refused";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kNoSolid);
    ASSERT_EQ(e.defects().size(), 1u);
    EXPECT_NE(std::string(e.what()).find("tolerance"), std::string::npos);
  }
}

// --- the distance of a triangle to a surface ---

double sampledGap(const TriangleMesh& s, const std::array<Vec3, 3>& t) {
  constexpr int kSteps = 12;
  const ClosestPointTree tree(s);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; i + k <= kSteps; ++k)
      least = std::min(least, tree.distance(t[0] + double(i) / kSteps * (t[1] - t[0]) +
                                            double(k) / kSteps * (t[2] - t[0])));
  return least;
}

TEST(TriangleGap, OfATreeIsTheLeastOfAllItsTriangles) {
  const TriangleMesh s = sheet(12, 9);
  const ClosestPointTree tree(s);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-2, 14), z(0.4, 3), by(-1, 1);
  for (int i = 0; i < 150; ++i) {
    const Vec3 p(x(random), x(random), z(random));
    const double size = i % 3 == 0 ? 4 : 0.3;
    const auto near = [&] { return Vec3(p + Vec3(size * by(random), size * by(random), 0.1 * by(random))); };
    const std::array<Vec3, 3> t{p, near(), near()};
    const PreparedTriangle prepared(t, {0, 1, 2});
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& own : s.triangles)
      least = std::min(
          least,
          squaredGap(prepared,
                     PreparedTriangle({s.positions[own[0]], s.positions[own[1]], s.positions[own[2]]}, own),
                     least));
    const double found = tree.distance(t, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(found, std::sqrt(least), 1e-14);
    const double sampled = sampledGap(s, t);
    EXPECT_LE(found, sampled + 1e-14);
    EXPECT_GT(found, sampled - size / 3);
    EXPECT_EQ(tree.distance(t, 0.9 * found), 0.9 * found) << "nothing is as near";
  }
}

TEST(TriangleGap, OfEdgesThatAreNearlyParallel) {
  for (const double angle : {0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-4}) {
    const Vec3 u(3, 0, 0), v = 3 * Vec3(std::cos(angle), std::sin(angle), 0);
    const Vec3 b = Vec3(1.5, 0, 2) - v / 2;  // above the middles of both
    EXPECT_NEAR(std::sqrt(squaredGap(Vec3::Zero(), u, b, v)), 2, 1e-14);
  }
}

}  // namespace
}  // namespace thicken
