// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Solids that begin at a gap from their surface.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "analytic_surfaces.h"
#include "plain_shapes.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

Options options(double gap, double thickness, Side side = Side::kNegative) {
  Options o;
  o.gap = gap;
  o.thickness = thickness;
  o.side = side;
  o.threads = 2;
  return o;
}

// A triangle's corners as coordinates, the least first; turned where `turned`.
using Corners = std::array<std::array<double, 3>, 3>;
Corners cornersOf(const TriangleMesh& mesh, const Triangle& t, bool turned) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = mesh.positions[t[turned ? 2 - k : k]];
    corners[k] = {p.x(), p.y(), p.z()};
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

// What holds of every solid with a gap: the gap surface is valid, faces as S does, and is in the solid.
void expectKept(const Solid& solid, Side side) {
  ASSERT_TRUE(solid.gapSurface);
  ASSERT_TRUE(solid.report.gap);
  EXPECT_TRUE(check(*solid.gapSurface).valid());
  EXPECT_EQ(solid.report.gap->surface.triangles, solid.gapSurface->triangles.size());
  EXPECT_EQ(solid.report.originalTriangles, solid.gapSurface->triangles.size());
  EXPECT_TRUE(solid.report.audit.passed());
  std::set<Corners> has;
  for (const Triangle& t : solid.mesh.triangles) has.insert(cornersOf(solid.mesh, t, false));
  for (const Triangle& t : solid.gapSurface->triangles)
    ASSERT_TRUE(has.contains(cornersOf(*solid.gapSurface, t, side == Side::kPositive)));
}

TEST(Gap, OfAPlaneIsAPlane) {
  const TriangleMesh plane = shapes::plane(6, 12);
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const Solid solid = thicken(plane, options(1.5, 2, side));
    expectKept(solid, side);
    const double sign = side == Side::kPositive ? 1 : -1;
    for (const Vec3& p : solid.gapSurface->positions) EXPECT_DOUBLE_EQ(p.z(), sign * 1.5);
    for (const Vec3& p : solid.mesh.positions) {
      EXPECT_GE(sign * p.z(), 1.5);
      EXPECT_LE(sign * p.z(), 3.5 + 1e-6);
    }
    EXPECT_NEAR(solid.report.gap->surface.area, 144, 1e-4);
    EXPECT_NEAR(solid.report.volume, 288, 1e-3);
    EXPECT_NEAR(solid.report.gap->least, 1.5, 1e-9);
    EXPECT_EQ(solid.report.gap->shortShare, 0);
    EXPECT_EQ(solid.report.gap->asked, 1.5);
    EXPECT_EQ(solid.report.thickness, 2);
    EXPECT_EQ(solid.report.input.triangles, plane.triangles.size());
    EXPECT_TRUE(solid.report.warnings.empty()) << solid.report.warnings.front();
  }
}

TEST(Gap, OfASphereIsASphere) {
  constexpr double kRadius = 30, kGap = 2, kThickness = 3;
  const TriangleMesh cap = shapes::sphere(4, kRadius, [](const Vec3& p) { return p.z() > 0; });
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const Solid solid = thicken(cap, options(kGap, kThickness, side));
    expectKept(solid, side);
    const double sign = side == Side::kPositive ? 1 : -1;
    // Middles of the sphere's triangles are a little nearer to its middle.
    for (const Vec3& p : solid.gapSurface->positions)
      EXPECT_NEAR(p.norm(), kRadius + sign * kGap, 0.02 * kGap + kRadius / 400);
    for (const Triangle& t : solid.gapSurface->triangles) {  // facing outward as S does
      const Vec3 &a = solid.gapSurface->positions[t[0]], &b = solid.gapSurface->positions[t[1]],
                 &c = solid.gapSurface->positions[t[2]];
      EXPECT_GT((b - a).cross(c - a).dot(a), 0);
    }
    EXPECT_LT(solid.report.gap->error.p99, 0.01);
    EXPECT_GT(solid.report.gap->least, 0.98 * kGap);
  }
}

TEST(Gap, AroundAClosedSurfaceIsClosed) {
  const TriangleMesh ball = shapes::sphere(3, 10);
  const Solid solid = thicken(ball, options(1, 2, Side::kPositive));
  expectKept(solid, Side::kPositive);
  EXPECT_TRUE(solid.report.gap->surface.closed);
  EXPECT_EQ(solid.report.gap->surface.components, 1u);
  EXPECT_GT(solid.report.volume, 4.0 / 3 * shapes::kPi * (13 * 13 * 13 - 11 * 11 * 11) * 0.97);
}

TEST(Gap, LeavesOutWhereThereIsNoRoomForItAndSaysSo) {
  // Between sheets 1 mm apart there is no room for a gap of 0.8, but outside of the last turn.
  const TriangleMesh roll = shapes::roll(60, 3, 1, 2);
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const Solid solid = thicken(roll, options(0.8, 0.3, side));
    expectKept(solid, side);
    const GapFacts& gap = *solid.report.gap;
    EXPECT_GT(gap.shortShare, 0.1);
    EXPECT_GT(gap.leftOut, 0);
    EXPECT_LT(gap.surface.area, 0.9 * solid.report.input.area);
    ASSERT_FALSE(solid.report.warnings.empty());
    EXPECT_NE(solid.report.warnings.front().find("no room for the gap of 0.8 mm"), std::string::npos);
    double least = 1;
    const ClosestPointTree tree(weld(roll));
    for (const Vec3& p : solid.gapSurface->positions) EXPECT_GE(tree.closest(p)->distance, 0.72);
    for (const Vec3& p : solid.mesh.positions) least = std::min(least, tree.closest(p)->distance);
    EXPECT_NEAR(gap.least, least, 1e-9);
    EXPECT_NEAR(tree.closest(gap.leastPlace)->distance, least, 1e-9);
  }
}

TEST(Gap, HasTheThicknessOfTheClosestPointsBehindIt) {
  const TriangleMesh plane = shapes::plane(6, 12);
  Options o = options(1.5, 2);
  double mean = 0;
  for (const Vec3& p : plane.positions) {
    o.thicknessMap.push_back(1.5 + 0.05 * p.x());
    mean += o.thicknessMap.back() / double(plane.positions.size());
  }
  const Solid solid = thicken(plane, o);
  expectKept(solid, Side::kNegative);
  EXPECT_NEAR(solid.report.volume, 144 * 2 * mean, 1e-3);
  double deepest = 0, highest = -5;
  for (const Vec3& p : solid.mesh.positions) {
    deepest = std::min(deepest, p.z() + 1.5 + 2 * (1.5 + 0.05 * p.x()));
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(deepest, 0, 1e-5);
  EXPECT_EQ(highest, -1.5);
  o.thicknessMap.pop_back();
  EXPECT_THROW((void)thicken(plane, o), Error);
}

TEST(Gap, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh sheet = shapes::sheet(20, 15);
  Options one = options(0.4, 0.5), three = one;
  one.threads = 1;
  three.threads = 3;
  const Solid a = thicken(sheet, one), b = thicken(sheet, three);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
}

TEST(Gap, OfARepairedSurfaceIsThatOfTheRepairedOne) {
  TriangleMesh sheet = shapes::flatSheet(8, 8, 0);
  std::swap(sheet.triangles[5][0], sheet.triangles[5][1]);
  EXPECT_THROW((void)thicken(sheet, options(1, 1)), Error);
  Options mended = options(1, 1);
  mended.repair = true;
  const Solid solid = thicken(sheet, mended);
  expectKept(solid, Side::kNegative);
  ASSERT_TRUE(solid.repaired && solid.report.repair);
  EXPECT_EQ(solid.repaired->triangles.size(), sheet.triangles.size());
  EXPECT_FALSE(solid.report.repair->changes.empty());
  EXPECT_NE(solid.report.warnings.front().find("repaired"), std::string::npos);
}

TEST(Gap, RefusesWhatMakesNoSense) {
  const TriangleMesh plane = shapes::plane(2, 4);
  for (const Options& wrong : {options(-1, 1), options(std::nan(""), 1), options(1, 1, Side::kBoth)}) {
    try {
      (void)thicken(plane, wrong);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidArgument);
      EXPECT_NE(std::string(error.what()).find("gap"), std::string::npos) << error.what();
    }
  }
}

TEST(Gap, IsForecastAsTwoRuns) {
  const SurfaceFacts sizes = sizesOf(shapes::plane(40, 30));
  const double solid = forecast(sizes, options(0, 2)).seconds, gap = forecast(sizes, options(0, 1)).seconds;
  EXPECT_DOUBLE_EQ(forecast(sizes, options(1, 2)).seconds, solid + gap);
}

TEST(Gap, ProgressIsInItsPart) {
  RunContext context;
  context.setPart(0.2, 0.6);
  (void)thicken(shapes::sheet(10, 10), options(0.3, 0.3), context);
  EXPECT_NEAR(context.progress(), 0.6, 1e-12);
}

}  // namespace
}  // namespace thicken
