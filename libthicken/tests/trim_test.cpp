// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/trim.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>

#include "analytic_surfaces.h"
#include "mesh/float_lattice.h"
#include "mesh/topology.h"
#include "plain_shapes.h"
#include "scratch_folder.h"
#include "thicken/check.h"
#include "thicken/closest_point.h"
#include "thicken/error.h"

namespace thicken {

using mesh::roundToFloat;

namespace {

using shapes::flatSheet;
using shapes::sheet;

TrimLoop circle(const Vec3& centre, double radius, int points) {
  TrimLoop loop;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * shapes::kPi * i / points;
    loop.push_back(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  return loop;
}

TrimmedSurface trimmed(const TriangleMesh& surface, const std::vector<TrimLoop>& loops,
                       const TrimOptions& options = {}) {
  TrimmedSurface part = trim(surface, loops, options);
  EXPECT_TRUE(check(part.mesh).valid());
  EXPECT_EQ(part.mesh.triangles.size(), part.origin.size());
  EXPECT_EQ(part.mesh.triangles.size(), part.facts.untouched + part.facts.divided);
  for (std::size_t t = 0; t < part.facts.untouched; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(part.mesh.positions[part.mesh.triangles[t][k]],
                surface.positions[surface.triangles[part.origin[t]][k]]);
  return part;
}

void expectRefused(const TriangleMesh& surface, const std::vector<TrimLoop>& loops, const char* words,
                   const TrimOptions& options = {}) {
  try {
    (void)trim(surface, loops, options);
    FAIL() << "trimmed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kInvalidArgument) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    ASSERT_EQ(error.defects().size(), 1u);
    EXPECT_NE(std::string(error.what()).find(error.defects()[0].sentence), std::string::npos);
  }
}

TEST(Trim, CutsASquareOutOfASheetAndKeepsWhatLiesInside) {
  const TriangleMesh whole = flatSheet(10, 10, 0);
  const TrimmedSurface part =
      trimmed(whole, {{{2.25, 2.25, 1}, {7.75, 2.25, 1}, {7.75, 7.75, 1}, {2.25, 7.75, 1}}});
  EXPECT_NEAR(part.facts.surface.area, 5.5 * 5.5, 1e-6);
  EXPECT_EQ(part.facts.surface.rims, 1u);
  EXPECT_EQ(part.facts.untouched, 2u * 4 * 4);  // the cells from 3 to 7
  EXPECT_EQ(part.facts.loops[0].points, 4u);
  EXPECT_NEAR(part.facts.loops[0].length, 22, 1e-6);
  EXPECT_NEAR(part.facts.loops[0].farthest, 1, 1e-12);
  for (const mesh::RimEdge& e : mesh::rimOf(part.mesh.positions.size(), part.mesh.triangles).edges) {
    const Vec3 middle = part.mesh.positions[e.from] + part.mesh.positions[e.to] - Vec3(10, 10, 0);
    EXPECT_NEAR(std::max(std::abs(middle.x()), std::abs(middle.y())), 5.5, 1e-5) << "the rim is the path";
  }
  for (const Vec3& p : part.mesh.positions) EXPECT_TRUE(mesh::isFloat(p));
}

TEST(Trim, DividesNothingWhereThePathLeadsAlongEdges) {
  const TrimmedSurface part = trimmed(flatSheet(6, 6, 0), {{{1, 1, 0}, {4, 1, 0}, {4, 3, 0}, {1, 3, 0}}});
  EXPECT_EQ(part.facts.divided, 0u);
  EXPECT_EQ(part.facts.untouched, 12u);
  EXPECT_EQ(part.facts.deviation, 0);
}

TEST(Trim, TakesPointsOnEdgesAndPathsThroughVertices) {
  // The path from (1, 1) to (4, 2.5) and back to (1, 4) passes vertices, and a corner lies on an edge.
  const TrimmedSurface part = trimmed(flatSheet(6, 6, 0), {{{1, 1, 0}, {4, 2.5, 0}, {1, 4, 0}}});
  EXPECT_NEAR(part.facts.surface.area, 4.5, 1e-6);
}

TEST(Trim, KeepsTheSmallerSideOrTheOneThatIsAskedFor) {
  const TriangleMesh ball = shapes::sphere(3, 10);
  const TrimLoop cap = circle({0, 0, 8}, 6, 16);
  const TrimmedSurface small = trimmed(ball, {cap});
  TrimOptions rest;
  rest.keep = Vec3(0, 0, -10);
  const TrimmedSurface large = trimmed(ball, {cap}, rest);
  EXPECT_LT(small.facts.surface.area, large.facts.surface.area);
  EXPECT_NEAR(small.facts.surface.area + large.facts.surface.area, small.facts.input.area, 1e-4);
  EXPECT_EQ(small.facts.surface.rims, 1u);
  EXPECT_EQ(large.facts.surface.rims, 1u);
}

TEST(Trim, KeepsTheInsideOfALoopNearTheRimAlthoughItIsTheLargerPart) {
  const TrimmedSurface part = trimmed(flatSheet(10, 10, 0), {circle({5, 5, 0}, 4.6, 40)});
  EXPECT_GT(part.facts.surface.area, 50);
  EXPECT_EQ(part.facts.surface.rims, 1u);
}

TEST(Trim, SeveralLoopsLeaveWhatLiesBetween) {
  const TriangleMesh whole = sheet(20, 20);
  const TrimmedSurface ring = trimmed(whole, {circle({10, 10, 0}, 8.3, 40), circle({10, 10, 0}, 3.1, 24)});
  EXPECT_EQ(ring.facts.surface.rims, 2u);
  TrimOptions middle;
  middle.keep = Vec3(10, 10, 0);
  const TrimmedSurface disc =
      trimmed(whole, {circle({10, 10, 0}, 8.3, 40), circle({10, 10, 0}, 3.1, 24)}, middle);
  EXPECT_EQ(disc.facts.surface.rims, 1u);
  ASSERT_EQ(disc.facts.warnings.size(), 1u) << "the outer loop does nothing";
  EXPECT_NE(disc.facts.warnings[0].find("loop 1 "), std::string::npos);
}

TEST(Trim, RefusesLoopsThatCannotBeFollowed) {
  const TriangleMesh whole = flatSheet(10, 10, 0);
  expectRefused(whole, {{{2, 2.1, 0}, {8, 8.2, 0}, {8.1, 2, 0}, {2.2, 7.9, 0}}}, "crosses itself at (");
  expectRefused(whole, {circle({4, 5, 0}, 2.3, 12), circle({6, 5.3, 0}, 2.2, 11)},
                "loop 2 crosses loop 1 at (");
  expectRefused(whole, {{{2, 2, 0}, {5, 2, 30}, {5, 5, 0}}}, "away from the surface");
  expectRefused(whole, {{{2, 2, 0}, {5, 2, 0}}}, "it takes three");
}

TEST(Trim, RefusesALoopThatLeavesTheSurface) {
  TriangleMesh holed = flatSheet(10, 10, 0);
  std::erase_if(holed.triangles, [&](const Triangle& t) {
    const Vec3 middle = (holed.positions[t[0]] + holed.positions[t[1]] + holed.positions[t[2]]) / 3;
    return std::abs(middle.x() - 5) < 2 && std::abs(middle.y() - 5) < 2;
  });
  expectRefused(holed, {{{2.5, 5, 0}, {7.5, 5, 0}, {7.5, 8.5, 0}, {2.5, 8.5, 0}}}, "leaves the surface at (");
}

TEST(Trim, RefusesALoopAroundAHandle) {
  const TriangleMesh torus = weld(shapes::parametric(48, 24, [](double u, double v) -> Vec3 {
    const double a = 2 * shapes::kPi * (u == 1 ? 0 : u), b = 2 * shapes::kPi * (v == 1 ? 0 : v);
    return roundToFloat(
        {(10 + 3 * std::cos(b)) * std::cos(a), (10 + 3 * std::cos(b)) * std::sin(a), 3 * std::sin(b)});
  }));
  ASSERT_TRUE(check(torus).valid());
  TrimLoop around;
  for (int i = 0; i < 12; ++i) {
    const double b = 2 * shapes::kPi * i / 12;
    around.emplace_back(10.1 + 3 * std::cos(b), 0.3, 3 * std::sin(b));
  }
  expectRefused(torus, {around}, "does not cut a part off");
  TrimLoop other = around;
  for (Vec3& p : other) p.x() = -p.x();
  const TrimmedSurface half = trimmed(torus, {around, other});
  EXPECT_EQ(half.facts.surface.rims, 2u);
}

TEST(Trim, AsksOnlyThePartThatStaysToBeFreeOfIntersections) {
  const TriangleMesh crossed = shapes::together(flatSheet(10, 10, 0), [] {
    TriangleMesh fin = flatSheet(1, 1, 0);
    for (Vec3& p : fin.positions) p = Vec3(8.3 + 0.1 * p.x(), 8.4 + 0.1 * p.y(), p.x() - 0.5);
    return fin;
  }());
  ASSERT_FALSE(check(crossed).valid());
  EXPECT_EQ(trimmed(crossed, {circle({4, 4, 0}, 3, 20)}).facts.surface.rims, 1u);
  TrimOptions outside;
  outside.keep = Vec3(9.5, 9.5, 0);
  EXPECT_EQ(trimmed(crossed, {circle({4, 4, 0}, 3, 20)}, outside).facts.surface.rims, 2u)
      << "the fin is no part of the sheet";
}

TEST(Trim, RefusesWhatIsNoSurface) {
  const std::vector<TrimLoop> loops{circle({5, 5, 0}, 3, 12)};
  TriangleMesh turned = flatSheet(10, 10, 0);
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  try {
    (void)trim(turned, loops);
    FAIL() << "trimmed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotOriented);
    EXPECT_TRUE(error.input());
  }
}

// Around random places of a bumpy surface that is turned and put anywhere: no path may fail, and both sides
// of a path are the whole surface.
TEST(Trim, BothSidesOfARandomLoopAreValidAndMakeTheWhole) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 25; ++i) {
    TriangleMesh whole = shapes::heightField(24, random, 0.08, 0.2);
    const Eigen::AngleAxisd turn(6 * share(random), Vec3(1, share(random), share(random)).normalized());
    const Vec3 shift(10 * share(random), 0, -30 * share(random));
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (const Vec3& p : whole.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    const double size = high.x() - low.x();
    const double x = 0.2 * share(random) - 0.1, y = 0.2 * share(random) - 0.1;
    TrimLoop loop =
        circle((low + high) / 2 + size * Vec3(x, y, 0), (0.1 + 0.2 * share(random)) * size, 6 + i);
    for (Vec3& p : loop) p = turn * p + shift;
    for (Vec3& p : whole.positions) p = roundToFloat(turn * p + shift);
    const TrimmedSurface inside = trimmed(whole, {loop});
    TrimOptions rest;
    rest.keep = whole.positions[0];
    const TrimmedSurface outside = trimmed(whole, {loop}, rest);
    EXPECT_NEAR(inside.facts.surface.area + outside.facts.surface.area, inside.facts.input.area,
                1e-4 * inside.facts.input.area);
    EXPECT_LT(inside.facts.deviation, 1e-2 * inside.facts.input.meanEdge);
    const ClosestPointTree tree(weld(whole));
    for (const Vec3& p : inside.mesh.positions) EXPECT_LT(tree.closest(p)->distance, 1e-4);
  }
}

TEST(Trim, SmoothingKeepsThePointsAndRoundsBetween) {
  const TriangleMesh whole = flatSheet(12, 12, 0);
  const TrimLoop square{{3.1, 3.1, 0}, {8.9, 3.1, 0}, {8.9, 8.9, 0}, {3.1, 8.9, 0}};
  TrimOptions smooth;
  smooth.smooth = 3;
  const TrimmedSurface round = trimmed(whole, {square}, smooth);
  EXPECT_EQ(round.facts.loops[0].points, 32u);
  EXPECT_GT(round.facts.surface.area, 1.1 * 5.8 * 5.8);
  for (const Vec3& p : square) {
    double nearest = 1e9;
    for (const Vec3& q : round.paths[0]) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 1e-5);
  }
  smooth.smooth = 6;
  EXPECT_THROW((void)trim(whole, std::vector<TrimLoop>{square}, smooth), Error);
}

TEST(SurfacePaths, ShowWhatTrimmingWillCut) {
  const TriangleMesh whole = sheet(12, 12);
  const TrimLoop loop = circle({6, 6, 0}, 4.2, 9);
  const SurfacePaths paths(whole);
  const TrimLoop closed = paths.path(loop, true);
  const TrimLoop cut = trimmed(whole, {loop}).paths[0];
  EXPECT_NEAR((closed.front() - cut.front()).norm(), 0, 1e-4);
  const TrimLoop open = paths.path(std::span(loop).first(3), false);
  EXPECT_LT(open.size(), closed.size());
  EXPECT_EQ(paths.path(std::span(loop).first(1), false).size(), 1u);
}

TEST(ReadLoop, ReadsPointsAndRefusesOtherThings) {
  const test::ScratchFolder folder;
  const TrimLoop loop = readLoop(folder.put("a.txt", "# x y z\n0 0 0\n1.5 0 -2e1 # end\r\n\n1 1 0\n0 0 0\n"));
  ASSERT_EQ(loop.size(), 3u) << "the last point is the first";
  EXPECT_EQ(loop[1], Vec3(1.5, 0, -20));
  for (const char* text : {"0 0 0\n1 0 0\n", "0 0\n1 0 0\n1 1 1\n", "0 0 0 1\n1 0 0\n1 1 1\n", "a b c\n",
                           "0,0,0\n1,0,0\n1,1,1\n", "0 0 nan\n1 0 0\n1 1 1\n"})
    EXPECT_THROW((void)readLoop(folder.put("b.txt", text)), Error) << text;
}

}  // namespace
}  // namespace thicken
