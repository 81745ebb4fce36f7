// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/drain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>

#include "analytic_surfaces.h"
#include "drain/strip.h"
#include "mesh/float_lattice.h"
#include "plain_shapes.h"
#include "thicken/check.h"
#include "thicken/error.h"
#include "thicken/inspect.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

using shapes::box;
using shapes::reversed;
using shapes::together;

const Vec3 kDown(0, 0, -1);

// A box of 20 mm with a cavity of 16 mm: a wall of 2 mm all around.
TriangleMesh hollowBox() {
  return together(box({0, 0, 0}, {20, 20, 20}), reversed(box({2, 2, 2}, {18, 18, 18})));
}

double crossSection(double diameter, int sides) {
  const double half = std::numbers::pi / sides;
  return sides * diameter * diameter / 4 * std::tan(half);
}

DrainHole hole(const Vec3& place, const Vec3& axis, double diameter, int sides = 24) {
  DrainHole result;
  result.place = place;
  result.axis = axis;
  result.diameter = diameter;
  result.sides = sides;
  return result;
}

std::size_t cavities(const TriangleMesh& solid) {
  std::size_t count = 0;
  for (const SolidShell& shell : inspect(solid).shells) count += shell.cavity ? 1 : 0;
  return count;
}

std::set<std::array<double, 9>> corners(const TriangleMesh& mesh, std::size_t count) {
  std::set<std::array<double, 9>> result;
  for (std::size_t t = 0; t < count; ++t) {
    std::array<double, 9> key{};
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) key[3 * k + i] = mesh.positions[mesh.triangles[t][k]][i];
    result.insert(key);
  }
  return result;
}

void expectRefused(const TriangleMesh& solid, const DrainHole& wanted, ErrorCode code, const char* words) {
  try {
    (void)drill(solid, wanted);
    FAIL() << "drilled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Drill, OpensACavityAndTakesAwayAPrism) {
  const DrilledSolid drilled = drill(hollowBox(), hole({10, 10, 2}, kDown, 3));
  const Inspection found = inspect(drilled.mesh);
  ASSERT_TRUE(found.audit.passed());
  EXPECT_EQ(found.shells.size(), 1u);
  EXPECT_EQ(cavities(hollowBox()), 1u);
  EXPECT_EQ(cavities(drilled.mesh), 0u);
  EXPECT_NEAR(found.volume, 20. * 20 * 20 - 16. * 16 * 16 - 2 * crossSection(3, 24), 1e-3);
  EXPECT_NEAR(drilled.entry[2], 2, 1e-12);
  EXPECT_NEAR(drilled.exit[2], 0, 1e-12);
  EXPECT_NEAR(drilled.walledFrom, 0, 1e-6);
  EXPECT_NEAR(drilled.walledTo, 2, 1e-6);
  EXPECT_LT((drilled.entry - Vec3(10, 10, 2)).norm(), 0.02 * 3 + 1e-9);
}

TEST(Drill, APinOfTheDiameterPasses) {
  const DrilledSolid drilled = drill(hollowBox(), hole({10, 10, 2}, kDown, 3, 6));
  ASSERT_EQ(drilled.outline.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const Vec3 middle = 0.5 * (drilled.outline[k] + drilled.outline[(k + 1) % 6]);
    EXPECT_NEAR((middle - drilled.entry).norm(), 1.5, 1e-9);
  }
}

TEST(Drill, LeavesTheRestAsItWas) {
  const TriangleMesh before = weld(hollowBox());
  const DrilledSolid drilled = drill(before, hole({10, 10, 2}, kDown, 3));
  EXPECT_EQ(drilled.untouched, before.triangles.size() - 4);  // two triangles a sheet
  const auto old = corners(before, before.triangles.size());
  for (const auto& triangle : corners(drilled.mesh, drilled.untouched)) EXPECT_EQ(old.count(triangle), 1u);
}

TEST(Drill, NewVerticesAreFloats) {
  const DrilledSolid drilled = drill(hollowBox(), hole({9.7, 10.3, 2}, {0.1, 0.2, -1}, 3));
  for (const Vec3& p : drilled.mesh.positions) EXPECT_TRUE(mesh::isFloat(p));
}

TEST(Drill, SlantedHole) {
  const Vec3 axis = Vec3(0.3, -0.2, -1).normalized();
  const DrilledSolid drilled = drill(hollowBox(), hole({10, 10, 2}, axis, 3));
  const Inspection found = inspect(drilled.mesh);
  ASSERT_TRUE(found.audit.passed());
  const double length = 2 / -axis[2];
  EXPECT_NEAR(found.volume, 20. * 20 * 20 - 16. * 16 * 16 - length * crossSection(3, 24), 1e-2);
  EXPECT_LT((drilled.axis - axis).norm(), 1e-12);
}

TEST(Drill, SeveralHolesOneAfterTheOther) {
  TriangleMesh solid = hollowBox();
  const std::pair<Vec3, Vec3> holes[] = {
      {{10, 10, 2}, kDown}, {{10, 10, 18}, -kDown}, {{18, 6, 10}, {1, 0, 0}}, {{15, 5, 0}, -kDown}};
  double volume = inspect(solid).volume;
  for (const auto& [place, axis] : holes) {
    solid = drill(solid, hole(place, axis, 2.5)).mesh;
    const Inspection found = inspect(solid);
    ASSERT_TRUE(found.audit.passed());
    EXPECT_NEAR(found.volume, volume - 2 * crossSection(2.5, 24), 1e-3);
    volume = found.volume;
  }
}

TEST(Drill, ThroughManySmallTriangles) {
  Options options;
  options.thickness = 1.5;
  options.precision = Precision::kSingle;
  TriangleMesh surface = shapes::parametric(
      60, 60, [](double u, double v) { return Vec3(30 * u, 30 * v, 3 * std::sin(5 * u) * std::cos(4 * v)); });
  for (Vec3& p : surface.positions) p = mesh::roundToFloat(p);
  const Solid solid = thicken(surface, options);
  for (const double diameter : {0.4, 2., 5.}) {
    const Vec3 place = surface.positions[61 * 30 + 30];
    const DrilledSolid drilled = drill(solid.mesh, hole(place, kDown, diameter));
    const Inspection found = inspect(drilled.mesh);
    ASSERT_TRUE(found.audit.passed());
    const double removed = solid.report.volume - found.volume;
    EXPECT_GT(removed, 1.4 * crossSection(diameter, 24));  // the wall is 1.5 mm across, longer along z
    EXPECT_LT(removed, 1.8 * crossSection(diameter, 24));
    EXPECT_GT(drilled.walledTo, drilled.walledFrom);
  }
}

TEST(Drill, SameBytesForAnyNumberOfThreads) {
  const DrilledSolid one = drill(hollowBox(), hole({10, 10, 2}, kDown, 3), {}, 1);
  const DrilledSolid two = drill(hollowBox(), hole({10, 10, 2}, kDown, 3), {}, 2);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
  EXPECT_EQ(one.mesh.positions, two.mesh.positions);
}

TEST(Drill, RefusesWhatCannotBe) {
  expectRefused(hollowBox(), hole({40, 40, 2}, kDown, 3), ErrorCode::kNoSolid, "no material");
  expectRefused(hollowBox(), hole({2.5, 10, 2}, kDown, 3), ErrorCode::kNoSolid, "cannot be drilled");
  expectRefused(hollowBox(), hole({10, 10, 2}, kDown, 30), ErrorCode::kNoSolid, "smaller diameter");
  expectRefused(hollowBox(), hole({10, 10, 2}, Vec3::Zero(), 3), ErrorCode::kInvalidArgument, "axis");
  expectRefused(hollowBox(), hole({10, 10, 2}, kDown, 0), ErrorCode::kInvalidArgument, "diameter");
  expectRefused(hollowBox(), hole({10, 10, 2}, kDown, 3, 2), ErrorCode::kInvalidArgument, "sides");
  TriangleMesh open = hollowBox();
  open.triangles.pop_back();
  expectRefused(open, hole({10, 10, 2}, kDown, 3), ErrorCode::kNoSolid, "no valid solid");
}

TEST(Drill, NamesWhatIsInTheWay) {
  // a small closed cavity within the wall, where the hole would go
  const TriangleMesh solid = together(hollowBox(), reversed(box({9.5, 9.5, 0.8}, {10.5, 10.5, 1.2})));
  const DrilledSolid beside = drill(solid, hole({5, 5, 2}, kDown, 2));
  EXPECT_EQ(cavities(beside.mesh), 1u);  // the small one is left
  expectRefused(solid, hole({10.9, 10.9, 2}, kDown, 3), ErrorCode::kNoSolid, "other parts");
}

TEST(Drill, TakesTheFirstPlaceThatWorks) {
  const DrainHole holes[] = {hole({40, 40, 2}, kDown, 3), hole({2.5, 10, 2}, kDown, 3),
                             hole({10, 10, 2}, kDown, 3), hole({5, 5, 2}, kDown, 3)};
  const DrilledSolid drilled = drill(hollowBox(), holes);
  EXPECT_EQ(drilled.candidate, 2u);
  EXPECT_EQ(cavities(drilled.mesh), 0u);
  try {
    (void)drill(hollowBox(), std::span(holes, 2));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("1 other place"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("no material"), std::string::npos) << error.what();
  }
}

TEST(Drill, IsCancelled) {
  RunContext context;
  context.cancel();
  try {
    (void)drill(hollowBox(), hole({10, 10, 2}, kDown, 3), context);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

double areaOf(const std::vector<Triangle>& triangles, const std::vector<Vec3>& flat) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = flat[b] - flat[a], v = flat[c] - flat[a];
    const double doubled = u[0] * v[1] - u[1] * v[0];
    EXPECT_GT(doubled, 0);
    sum += doubled / 2;
  }
  return sum;
}

TEST(Triangulate, PolygonsWithDentsAndStraightCorners) {
  const std::vector<Vec3> comb{{0, 0, 0},     {1, 0, 0}, {2, 0, 0},     {3, 0, 0}, {3, 2, 0},
                               {2.5, 0.2, 0}, {2, 2, 0}, {1.5, 0.1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::vector<VertexId> loop(comb.size());
  for (VertexId v = 0; v < loop.size(); ++v) loop[v] = v;
  const auto triangles = drain::triangulate(loop, comb);
  EXPECT_EQ(triangles.size(), comb.size() - 2);
  double area = 0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Vec3 &p = comb[i], &q = comb[(i + 1) % comb.size()];
    area += (p[0] * q[1] - p[1] * q[0]) / 2;
  }
  EXPECT_NEAR(areaOf(triangles, comb), area, 1e-12);
}

TEST(Triangulate, RefusesWhatIsNoSimplePolygon) {
  EXPECT_TRUE(drain::triangulate({0, 1, 2, 3}, {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
  EXPECT_TRUE(drain::triangulate({0, 1, 2}, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).empty());
  EXPECT_TRUE(drain::triangulate({0, 1}, {{0, 0, 0}, {1, 1, 0}}).empty());
}

}  // namespace
}  // namespace thicken
