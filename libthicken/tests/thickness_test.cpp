// SPDX-License-Identifier: LGPL-2.1-or-later
#include "job/thickness.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analytic_surfaces.h"
#include "jobs.h"
#include "measure/error_bound.h"
#include "mesh/vertex_values.h"
#include "plain_shapes.h"
#include "refusals.h"
#include "thicken/error.h"
#include "thicken/thicken.h"

namespace thicken {

using job::kSteepest;
using job::Thickness;
using measure::boundShellError;

namespace {

constexpr double kR = 1;

// Linear along x, from 0.6 to 1.6 over ten millimetres.
double linear(const Vec3& p) {
  return 0.6 + 0.1 * p.x();
}

template <class Factor>
Options mapped(const TriangleMesh& surface, Factor factor, Method method = Method::kAuto) {
  Options options;
  options.thickness = kR;
  options.method = method;
  for (const Vec3& p : surface.positions) options.thicknessMap.push_back(factor(p));
  return options;
}

Options plain(Method method = Method::kAuto) {
  Options options;
  options.thickness = kR;
  options.method = method;
  return options;
}

// Of the vertices of the shell, but for those whose closest point is on the rim.
double worstError(const Solid& solid, const TriangleMesh& surface, const Thickness& r) {
  const ClosestPointTree tree(surface);
  double worst = 0;
  for (std::size_t t = 0; t < solid.region.size(); ++t) {
    if (solid.region[t] != Region::kShell) continue;
    Vec3 middle = Vec3::Zero();
    for (const VertexId v : solid.mesh.triangles[t]) middle += solid.mesh.positions[v] / 3;
    for (const Vec3& p : {solid.mesh.positions[solid.mesh.triangles[t][0]], middle})
      if (const ClosestPoint c = *tree.closest(p); !c.onRim)
        worst = std::max(worst, std::abs(c.distance - r.at(c)));
  }
  return worst;
}

TEST(Thickness, IsLinearOverTrianglesOfS) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  std::vector<double> r;
  for (const Vec3& p : sheet.positions) r.push_back(2 + std::sin(p.x()));
  const Thickness thickness(sheet, r);
  EXPECT_EQ(thickness.least(), *std::min_element(r.begin(), r.end()));
  EXPECT_EQ(thickness.most(), *std::max_element(r.begin(), r.end()));
  for (TriangleId t = 0; t < sheet.triangles.size(); ++t) {
    const auto& [a, b, c] = sheet.triangles[t];
    const Vec3 p = 0.2 * sheet.positions[a] + 0.3 * sheet.positions[b] + 0.5 * sheet.positions[c];
    EXPECT_NEAR(thickness.at(t, p), 0.2 * r[a] + 0.3 * r[b] + 0.5 * r[c], 1e-12);
    const Vec3 edge = sheet.positions[b] - sheet.positions[a];
    EXPECT_NEAR(thickness.slope(t).dot(edge), r[b] - r[a], 1e-12);
    const Vec3 n = edge.cross(sheet.positions[c] - sheet.positions[a]);
    EXPECT_NEAR(thickness.slope(t).dot(n), 0, 1e-12);
  }
}

TEST(Thickness, IsNowhereSteeperThanItMayBe) {
  const TriangleMesh sheet = shapes::sheet(30, 10);
  Options options = plain();
  std::vector<double> factors;
  for (const Vec3& p : sheet.positions) factors.push_back(p.x() < 10 ? 1 : 20);
  std::optional<ThicknessFacts> facts;
  std::optional<RimFacts> rim;
  const Thickness thickness = job::thicknessOf(sheet, options, factors, facts, rim);
  ASSERT_TRUE(facts);
  EXPECT_FALSE(rim);
  EXPECT_GT(facts->steepest, 15);
  EXPECT_GT(facts->lowered, 10u);
  double steepest = 0;
  for (TriangleId t = 0; t < sheet.triangles.size(); ++t)
    steepest = std::max(steepest, thickness.slope(t).norm());
  EXPECT_LE(steepest, kSteepest * (1 + 1e-6));
  EXPECT_GT(steepest, 0.99 * kSteepest);
  for (VertexId v = 0; v < sheet.positions.size(); ++v)
    if (sheet.positions[v].x() < 10) {
      EXPECT_EQ(thickness.at(v), 1);
    }
  EXPECT_EQ(thickness.most(), 20) << "far enough from the step";
}

// A repair that divides a triangle or fills a hole makes vertices that the map does not have.
TEST(ThicknessMap, IsLinearWhereAVertexIsNew) {
  const TriangleMesh sheet = shapes::flatSheet(4, 3, 0);
  std::vector<double> values;
  for (const Vec3& p : sheet.positions) values.push_back(1 + 2 * p.x() + 3 * p.y());
  TriangleMesh divided = sheet;
  divided.positions.emplace_back(1.25, 0.5, 0);
  divided.positions.emplace_back(1.25, 0.5, 0.1);
  divided.positions.emplace_back(2, -1, 0);  // beyond the rim
  const std::vector<double> there = mesh::valuesAt(sheet, values, divided, "the map");
  const std::size_t known = sheet.positions.size();
  EXPECT_TRUE(std::equal(values.begin(), values.end(), there.begin()));
  EXPECT_NEAR(there[known], 5, 1e-12);
  EXPECT_NEAR(there[known + 1], 5, 1e-12);
  EXPECT_NEAR(there[known + 2], 5, 1e-12);
}

// In a plane Definition 2 has the shell right below every point of S, r(x) deep.
TEST(ThicknessMap, PutsTheShellOfAPlaneWhereTheDefinitionHasIt) {
  const TriangleMesh sheet = shapes::flatSheet(10, 8, 0);
  for (const Side side : {Side::kNegative, Side::kPositive, Side::kBoth}) {
    Options options = mapped(sheet, linear);
    options.side = side;
    const Solid solid = thicken(sheet, options);
    std::size_t count = 0;
    for (std::size_t t = 0; t < solid.region.size(); ++t)
      if (solid.region[t] == Region::kShell)
        for (const VertexId v : solid.mesh.triangles[t]) {
          const Vec3& p = solid.mesh.positions[v];
          EXPECT_NEAR(std::abs(p.z()), linear(p), 1e-6) << name(side);
          ++count;
        }
    EXPECT_GT(count, 0u);
    EXPECT_NEAR(solid.report.volume, 88 * (side == Side::kBoth ? 2 : 1), 88 * 1e-5)
        << "1.1 mm in the mean, of 80 mm2";
    EXPECT_NEAR(solid.report.thinnestShare, 1, 1e-6);
    EXPECT_EQ(solid.report.thinShare, 0);
    ASSERT_TRUE(solid.report.thicknessMap);
    EXPECT_NEAR(solid.report.thicknessMap->steepest, 0.1, 1e-12);
    EXPECT_EQ(solid.report.thicknessMap->lowered, 0u);
  }
}

TEST(ThicknessMap, IsFollowedByEveryMethodOnACurvedSurface) {
  const TriangleMesh cap = shapes::sphere(3, 10, [](const Vec3& p) { return p.z() > 2; });
  const auto factor = [](const Vec3& p) { return 1 + 0.03 * p.x(); };
  for (const Method method : {Method::kAuto, Method::kSweep, Method::kReconstruct}) {
    const Options options = mapped(cap, factor, method);
    const Solid solid = thicken(cap, options);
    // A constant thickness has 0.042 of it at the worst point of the contour, and 0.6 % over 99 % of the
    // area.
    EXPECT_LT(worstError(solid, cap, Thickness(cap, options.thicknessMap)), 0.045 * kR) << name(method);
    EXPECT_LT(solid.report.shellError.p99, 0.007) << name(method);
  }
}

TEST(ThicknessMap, OfOnesIsNone) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  for (const Method method : {Method::kAuto, Method::kSweep, Method::kReconstruct}) {
    const Solid one = thicken(sheet, plain(method));
    const Solid other = thicken(sheet, mapped(
                                           sheet, [](const Vec3&) { return 1.0; }, method));
    EXPECT_EQ(one.mesh.positions, other.mesh.positions) << name(method);
    EXPECT_EQ(one.mesh.triangles, other.mesh.triangles) << name(method);
  }
}

TEST(ThicknessMap, IsProvedWithinATolerance) {
  const TriangleMesh cap = shapes::sphere(2, 10, [](const Vec3& p) { return p.z() > 2; });
  Options options = mapped(cap, [](const Vec3& p) { return 1 + 0.03 * p.x(); });
  options.tolerance = 0.05;
  const Solid solid = thicken(cap, options);
  ASSERT_TRUE(solid.report.shellErrorBound);
  EXPECT_LE(*solid.report.shellErrorBound, 0.05);
  EXPECT_GE(*solid.report.shellErrorBound + 1e-9,
            worstError(solid, cap, Thickness(cap, options.thicknessMap)));
  // The same shell is no proof of another map.
  OwnJob own(cap, kR);
  std::vector<double> other = options.thicknessMap;
  for (VertexId v = 0; v < other.size(); ++v)
    if (cap.positions[v].x() > 5) other[v] += 0.08;
  own.job.thickness = Thickness(own.surface, other);
  EXPECT_GT(boundShellError(own.job, solid.mesh, solid.region, 0.05).most, 0.05);
}

// A triangle far larger than the thickness has a proof all the same: over it distance and thickness are
// linear.
TEST(ThicknessMap, IsProvedOverLargeTriangles) {
  const TriangleMesh sheet =
      shapes::parametric(2, 2, [](double u, double v) { return Vec3(100 * u, 100 * v, 0); });
  OwnJob own(sheet, kR);
  std::vector<double> r;
  for (const Vec3& p : sheet.positions) r.push_back(1 + p.x() / 100);
  own.job.thickness = Thickness(own.surface, r);
  TriangleMesh solid = shapes::slab(sheet, 1);
  for (std::size_t v = 0; v < r.size(); ++v) solid.positions[r.size() + v].z() = -r[v];
  std::vector<Region> region(solid.triangles.size(), Region::kWall);
  std::fill_n(region.begin(), sheet.triangles.size(), Region::kOriginal);
  std::fill_n(region.begin() + static_cast<std::ptrdiff_t>(sheet.triangles.size()), sheet.triangles.size(),
              Region::kShell);
  EXPECT_LE(boundShellError(own.job, solid, region, 0.02).most, 0.02);
}

TEST(ThicknessMap, StaysWithTheCornersThatAreWelded) {
  const TriangleMesh sheet = shapes::flatSheet(10, 8, 0);
  TriangleMesh soup;
  for (const Triangle& t : sheet.triangles) {
    const auto first = static_cast<VertexId>(soup.positions.size());
    for (const VertexId v : t) soup.positions.push_back(sheet.positions[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const Solid one = thicken(sheet, mapped(sheet, linear));
  Options options = mapped(soup, linear);
  EXPECT_NEAR(thicken(soup, options).report.volume, one.report.volume, 1e-9);
  options.repair = true;
  soup.triangles.push_back(soup.triangles.front());  // twice
  EXPECT_NEAR(thicken(soup, options).report.volume, one.report.volume, 1e-9);
  options.thicknessMap[4] += 1;
  EXPECT_NE(refusalOf(soup, options).find("different values"), std::string::npos);
}

TEST(ThicknessMap, IsRefusedWhereItMakesNoSense) {
  const TriangleMesh sheet = shapes::flatSheet(4, 4, 0);
  Options options = mapped(sheet, linear);
  options.thicknessMap.pop_back();
  EXPECT_NE(refusalOf(sheet, options).find("24 values"), std::string::npos);
  for (const double factor : {0.0, -1.0, std::nan("")}) {
    options = mapped(sheet, linear);
    options.thicknessMap[7] = factor;
    EXPECT_NE(refusalOf(sheet, options).find("vertex 7"), std::string::npos) << factor;
  }
}

TEST(ThicknessMap, ThatIsTooSteepIsReported) {
  const TriangleMesh sheet = shapes::flatSheet(20, 8, 0);
  const Solid solid = thicken(sheet, mapped(sheet, [](const Vec3& p) { return p.x() < 10 ? 1.0 : 4.0; }));
  ASSERT_TRUE(solid.report.thicknessMap);
  EXPECT_GT(solid.report.thicknessMap->lowered, 0u);
  EXPECT_TRUE(std::ranges::any_of(solid.report.warnings, [](const std::string& w) {
    return w.find("shell would fold") != std::string::npos;
  }));
}

}  // namespace
}  // namespace thicken
