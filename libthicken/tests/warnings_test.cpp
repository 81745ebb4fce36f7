// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a report says of a solid that is not what was asked for.
#include "measure/warnings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analytic_surfaces.h"
#include "jobs.h"
#include "measure/measure.h"
#include "plain_shapes.h"
#include "thicken/thicken.h"

namespace thicken {

using measure::addWarnings;
using measure::percentText;

namespace {

bool warnsOf(const Report& report, const std::string& words) {
  return std::any_of(report.warnings.begin(), report.warnings.end(),
                     [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

Solid thickened(const TriangleMesh& surface, double thickness, Method method = Method::kSweep) {
  Options options;
  options.thickness = thickness;
  options.method = method;
  return thicken(surface, options);
}

// What a sheet of 10 mm with a bump is as a part.
TriangleMesh bump() {
  TriangleMesh mesh = shapes::sheet(10, 10);
  for (Vec3& p : mesh.positions)
    p.z() = 3 * std::exp(-((p.x() - 5) * (p.x() - 5) + (p.y() - 5) * (p.y() - 5)) / 8);
  return mesh;
}

TEST(Warnings, TellOfABrokenRule) {
  Report report;
  report.thickness = report.thinnestWall = report.thinnestShare = 1;
  addWarnings(report);
  EXPECT_TRUE(report.warnings.empty());
  report.fallbacks = {{"contour", "no", Vec3::Zero(), 1},
                      {"internal", "crossings do not cancel", Vec3::Zero(), 1}};
  addWarnings(report);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_TRUE(warnsOf(report, "crossings do not cancel"));
}

TEST(Percent, IsNeverNothingForWhatIsSomething) {
  EXPECT_EQ(percentText(0), "0 %");
  EXPECT_EQ(percentText(1e-9), "less than 0.01 %");
  EXPECT_EQ(percentText(0.0123), "1.23 %");
  EXPECT_EQ(percentText(1), "100 %");
}

TEST(Percent, IsNeverAllOfWhatIsLess) {
  EXPECT_EQ(percentText(0.99956), "more than 99.9 %");
  EXPECT_EQ(percentText(1 - 1e-12), "more than 99.9 %");
  EXPECT_EQ(percentText(0.999), "99.9 %");
}

TEST(Warnings, TellWhatARepairRemovedOrThatItWasNothing) {
  Report report;
  report.input.area = 10;
  report.repair.emplace();
  report.repair->changes.push_back({RepairKind::kDivided, 3, 0, {}, {}});
  addWarnings(report);
  EXPECT_TRUE(warnsOf(report, "repaired (3 divided): nothing of it was removed"));
  report.warnings.clear();
  report.repair->removed = 2;
  report.repair->removedArea = 1;
  addWarnings(report);
  EXPECT_TRUE(warnsOf(report, "2 triangles with 10 % of its area were removed"));
}

TEST(Warnings, GiveNoShareOfNothing) {
  Report report;
  report.thickness = 1;
  report.shellTriangles = 1;
  report.thinnestWall = report.thinnestShare = 0.5;
  addWarnings(report);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_FALSE(warnsOf(report, "0 %")) << report.warnings[0];
  EXPECT_TRUE(warnsOf(report, "below every corner"));
  report.warnings.clear();
  report.thinShare = 1e-7;
  addWarnings(report);
  EXPECT_TRUE(warnsOf(report, "less than 0.01 % of the surface"));
}

TEST(Warnings, TellThatAThicknessExceedsThePart) {
  for (const double thickness : {20.0, 70.0, 1e9}) {
    const Report report = thickened(bump(), thickness, Method::kAuto).report;
    EXPECT_TRUE(warnsOf(report, "exceeds the surface itself")) << thickness;
    EXPECT_TRUE(warnsOf(report, "metres")) << thickness;
    // No wall of a part is thicker than the part.
    EXPECT_GT(report.thinnestWall, 0) << thickness;
    EXPECT_LT(report.thinnestThrough, 40) << thickness;
    EXPECT_NE(report.thinnestPlace, Vec3(0, 0, 0)) << thickness;
  }
  EXPECT_FALSE(warnsOf(thickened(bump(), 1).report, "exceeds"));
}

TEST(Warnings, NoDepthIsLargerThanTheSolid) {
  const Report report = thickened(bump(), 1e9, Method::kAuto).report;
  EXPECT_GT(report.thinShare, 0.99);
  EXPECT_TRUE(warnsOf(report, "of the surface has less than 0.9"));
}

TEST(Warnings, TellOfASurfaceInAnotherUnit) {
  TriangleMesh metres = shapes::sheet(10, 10);
  for (Vec3& p : metres.positions) p *= 0.001;
  EXPECT_TRUE(warnsOf(thickened(metres, 2).report, "scale a surface in metres by 1000"));
  EXPECT_TRUE(warnsOf(thickened(metres, 1e-4).report, "scale a surface in metres by 1000"))
      << "0.014 mm across";
  TriangleMesh inches = shapes::sheet(10, 10);
  for (Vec3& p : inches.positions) p *= 0.2;
  EXPECT_TRUE(warnsOf(thickened(inches, 2).report, "one in inches by 25.4")) << "2.8 mm across";
  EXPECT_FALSE(warnsOf(thickened(shapes::sheet(10, 10), 2).report, "lengths are millimetres"));
  TriangleMesh micrometres = shapes::sheet(10, 10);
  for (Vec3& p : micrometres.positions) p *= 1e4;
  EXPECT_TRUE(warnsOf(thickened(micrometres, 1).report, "micrometres"));
}

TEST(Warnings, CountPartsAndCrumbs) {
  TriangleMesh mesh = shapes::flatSheet(10, 10, 0);
  EXPECT_EQ(thickened(mesh, 1).report.parts, 1u);
  EXPECT_TRUE(thickened(mesh, 1).report.warnings.empty());
  const auto add = [&mesh](double size, double x) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x + size, 0, 0), Vec3(x, size, 0)}) mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  add(5, 20);
  add(0.1, 30);
  const Report report = thickened(mesh, 1).report;
  EXPECT_EQ(report.parts, 3u);
  EXPECT_EQ(report.crumbs, 1u) << "0.005 mm³";
  EXPECT_NEAR(report.crumbVolume, 0.1, 1e-9) << "a thousandth of the sheet's 100 mm³, which is below 1 mm³";
  EXPECT_TRUE(warnsOf(report, "3 separate parts that nothing joins, 1 of them crumbs of less than 0.1 mm³"));
}

TEST(Warnings, CountNoCavityAsAPart) {
  const Report report = thickened(shapes::sphere(2, 10), 1).report;
  EXPECT_EQ(report.components, 2u);
  EXPECT_EQ(report.parts, 1u);
}

// A blade whose two sides come together at an edge of a few degrees, closed behind: below each side there is
// the full thickness, but near the edge the part is thin straight through.
TEST(Warnings, TellOfASharpEdgeOfTheSurfaceItself) {
  TriangleMesh wedge;
  constexpr VertexId kSteps = 40;
  for (VertexId i = 0; i <= kSteps; ++i)
    for (const double y : {0.0, 10.0}) {
      const double x = 20.0 * i / kSteps;
      wedge.positions.emplace_back(x, y, 0.1 * x);
      wedge.positions.emplace_back(x, y, -0.1 * x);
    }
  const auto top = [](VertexId i, VertexId j) { return i == 0 ? 2 * j : 4 * i + 2 * j; };
  const auto bottom = [](VertexId i, VertexId j) { return i == 0 ? 2 * j : 4 * i + 2 * j + 1; };
  for (VertexId i = 0; i < kSteps; ++i) {
    wedge.triangles.push_back({top(i, 0), top(i + 1, 0), top(i + 1, 1)});
    wedge.triangles.push_back({top(i, 0), top(i + 1, 1), top(i, 1)});
    wedge.triangles.push_back({bottom(i, 0), bottom(i + 1, 1), bottom(i + 1, 0)});
    wedge.triangles.push_back({bottom(i, 0), bottom(i, 1), bottom(i + 1, 1)});
  }
  wedge = weld(wedge);
  const Report report = thickened(wedge, 1).report;
  EXPECT_LT(report.thinnestThrough, 0.2)
      << "about 0.2 of the 0.17 mm from the edge to the middle of a triangle";
  EXPECT_LT(report.thinnestThroughPlace.x(), 2) << "at the edge";
}

TEST(Thinness, OfAPlateIsTheThicknessBothWays) {
  const Report report = thickened(shapes::flatSheet(10, 10, 0), 1.5).report;
  EXPECT_DOUBLE_EQ(report.thinnestWall, 1.5);
  EXPECT_DOUBLE_EQ(report.thinnestThrough, 1.5);
  EXPECT_EQ(report.thinShare, 0);
}

// The deviation is looked for in the solid, whatever the stages before have promised.
TEST(Deviation, IsMeasured) {
  const TriangleMesh sheet = shapes::flatSheet(10, 10, 0);
  for (const Side side : {Side::kNegative, Side::kBoth}) {
    Options options;
    options.thickness = 1;
    options.side = side;
    Solid solid = thicken(sheet, options);
    EXPECT_EQ(solid.report.surfaceDeviation, 0);
    const Vec3 corner(10, 10, 0);
    for (Vec3& p : solid.mesh.positions)
      if (p == corner) p += Vec3(0.25, 0, 0);
    measure::measure(solid, OwnJob(sheet, options).job, {}, measure::Measure::kRepresentative);
    EXPECT_DOUBLE_EQ(solid.report.surfaceDeviation, 0.25) << name(side);
  }
}

}  // namespace
}  // namespace thicken
