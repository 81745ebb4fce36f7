// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Solids that begin at a gap from their surface.
#include <gtest/gtest.h>

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

Options options(double thickness, Side side = Side::kNegative) {
  Options o;
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
void expectKept(const GapSolid& made, Side side) {
  const Solid& solid = made.solid;
  EXPECT_TRUE(check(made.surface).valid());
  EXPECT_EQ(made.facts.surface.triangles, made.surface.triangles.size());
  EXPECT_EQ(solid.report.originalTriangles, made.surface.triangles.size());
  EXPECT_TRUE(solid.report.audit.passed());
  std::set<Corners> has;
  for (const Triangle& t : solid.mesh.triangles) has.insert(cornersOf(solid.mesh, t, false));
  for (const Triangle& t : made.surface.triangles)
    ASSERT_TRUE(has.contains(cornersOf(made.surface, t, side == Side::kPositive)));
}

TEST(Gap, OfAPlaneIsAPlane) {
  const TriangleMesh plane = shapes::plane(6, 12);
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const GapSolid made = thickenAtGap(plane, 1.5, options(2, side));
    expectKept(made, side);
    const double sign = side == Side::kPositive ? 1 : -1;
    for (const Vec3& p : made.surface.positions) EXPECT_DOUBLE_EQ(p.z(), sign * 1.5);
    for (const Vec3& p : made.solid.mesh.positions) {
      EXPECT_GE(sign * p.z(), 1.5);
      EXPECT_LE(sign * p.z(), 3.5 + 1e-6);
    }
    EXPECT_NEAR(made.facts.surface.area, 144, 1e-4);
    EXPECT_NEAR(made.solid.report.volume, 288, 1e-3);
    EXPECT_NEAR(made.facts.least, 1.5, 1e-9);
    EXPECT_EQ(made.facts.shortShare, 0);
    EXPECT_EQ(made.facts.asked, 1.5);
    EXPECT_EQ(made.solid.report.thickness, 2);
    EXPECT_EQ(made.solid.report.input.triangles, plane.triangles.size());
    EXPECT_TRUE(made.solid.report.warnings.empty()) << made.solid.report.warnings.front();
  }
}

TEST(Gap, OfASphereIsASphere) {
  constexpr double kRadius = 30, kGap = 2, kThickness = 3;
  const TriangleMesh cap = shapes::sphere(4, kRadius, [](const Vec3& p) { return p.z() > 0; });
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const GapSolid made = thickenAtGap(cap, kGap, options(kThickness, side));
    expectKept(made, side);
    const double sign = side == Side::kPositive ? 1 : -1;
    // Middles of the sphere's triangles are a little nearer to its middle.
    for (const Vec3& p : made.surface.positions)
      EXPECT_NEAR(p.norm(), kRadius + sign * kGap, 0.02 * kGap + kRadius / 400);
    for (const Triangle& t : made.surface.triangles) {  // facing outward as S does
      const Vec3 &a = made.surface.positions[t[0]], &b = made.surface.positions[t[1]],
                 &c = made.surface.positions[t[2]];
      EXPECT_GT((b - a).cross(c - a).dot(a), 0);
    }
    EXPECT_LT(made.facts.error.p99, 0.01);
    EXPECT_GT(made.facts.least, 0.98 * kGap);
  }
}

TEST(Gap, AroundAClosedSurfaceIsClosed) {
  const TriangleMesh ball = shapes::sphere(3, 10);
  const GapSolid made = thickenAtGap(ball, 1, options(2, Side::kPositive));
  expectKept(made, Side::kPositive);
  EXPECT_TRUE(made.facts.surface.closed);
  EXPECT_EQ(made.facts.surface.components, 1u);
  EXPECT_GT(made.solid.report.volume, 4.0 / 3 * shapes::kPi * (13 * 13 * 13 - 11 * 11 * 11) * 0.97);
}

TEST(Gap, TellsWhereThereIsNoRoomForIt) {
  // Sheets 1 mm apart have no room for a gap of 0.8.
  const GapSolid made = thickenAtGap(shapes::roll(60, 3, 1, 2), 0.8, options(0.3));
  expectKept(made, Side::kNegative);
  const GapFacts& gap = made.facts;
  EXPECT_GT(gap.shortShare, 0.1);
  EXPECT_LT(gap.least, 0.72);
  ASSERT_FALSE(made.solid.report.warnings.empty());
  EXPECT_NE(made.solid.report.warnings.front().find("the gap of 0.8 mm is not kept everywhere"),
            std::string::npos);
  double least = 1;
  const ClosestPointTree tree(weld(shapes::roll(60, 3, 1, 2)));
  for (const Vec3& p : made.solid.mesh.positions) least = std::min(least, tree.closest(p)->distance);
  EXPECT_NEAR(gap.least, least, 1e-9);
  EXPECT_NEAR(tree.closest(gap.leastPlace)->distance, least, 1e-9);
}

TEST(Gap, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh sheet = shapes::sheet(20, 15);
  Options one = options(0.5), three = one;
  one.threads = 1;
  three.threads = 3;
  const GapSolid a = thickenAtGap(sheet, 0.4, one), b = thickenAtGap(sheet, 0.4, three);
  EXPECT_EQ(a.solid.mesh.triangles, b.solid.mesh.triangles);
  EXPECT_EQ(a.solid.mesh.positions, b.solid.mesh.positions);
}

TEST(Gap, OfARepairedSurfaceIsThatOfTheRepairedOne) {
  TriangleMesh sheet = shapes::flatSheet(8, 8, 0);
  std::swap(sheet.triangles[5][0], sheet.triangles[5][1]);
  EXPECT_THROW((void)thickenAtGap(sheet, 1, options(1)), Error);
  Options mended = options(1);
  mended.repair = true;
  const GapSolid made = thickenAtGap(sheet, 1, mended);
  expectKept(made, Side::kNegative);
  ASSERT_TRUE(made.solid.repaired && made.solid.report.repair);
  EXPECT_EQ(made.solid.repaired->triangles.size(), sheet.triangles.size());
  EXPECT_FALSE(made.solid.report.repair->changes.empty());
  EXPECT_NE(made.solid.report.warnings.front().find("repaired"), std::string::npos);
}

TEST(Gap, RefusesWhatMakesNoSense) {
  const TriangleMesh plane = shapes::plane(2, 4);
  const auto expectRefused = [&](double gap, const Options& wrong) {
    try {
      (void)thickenAtGap(plane, gap, wrong);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidArgument);
      EXPECT_NE(std::string(error.what()).find("gap"), std::string::npos) << error.what();
    }
  };
  for (const double gap : {-1.0, 0.0, std::nan(""), HUGE_VAL}) expectRefused(gap, options(1));
  expectRefused(1, options(1, Side::kBoth));
}

TEST(Gap, ProgressIsInItsPart) {
  RunContext context;
  (void)thickenAtGap(shapes::sheet(10, 10), 0.3, options(0.3), context, 0.2, 0.6);
  EXPECT_NEAR(context.progress(), 0.6, 1e-12);
}

}  // namespace
}  // namespace thicken
