// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analytic_surfaces.h"
#include "check/audit.h"
#include "jobs.h"
#include "mesh/float_lattice.h"
#include "mesh/linked_mesh.h"
#include "plain_shapes.h"
#include "simplify/collapse.h"
#include "simplify/edge_queue.h"
#include "simplify/quadric.h"
#include "thicken/thicken.h"

namespace thicken {

using mesh::LinkedMesh;
using mesh::roundToFloat;

namespace {

using namespace shapes;
using namespace simplify;

std::size_t countOf(const Solid& solid, Region region) {
  return static_cast<std::size_t>(std::ranges::count(solid.region, region));
}

Options options(double r, Simplify what, Method method = Method::kSweep) {
  Options o;
  o.thickness = r;
  o.method = method;
  o.simplify = what;
  o.threads = 1;
  return o;
}

TriangleMesh rounded(TriangleMesh mesh) {
  for (Vec3& p : mesh.positions) p = roundToFloat(p);
  return weld(mesh);
}

// S first, in its own order and with its own coordinates.
void expectKept(const Solid& solid, const TriangleMesh& s) {
  ASSERT_GE(solid.mesh.triangles.size(), s.triangles.size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    ASSERT_EQ(solid.mesh.triangles[t], s.triangles[t]);
    for (const VertexId v : s.triangles[t]) ASSERT_EQ(solid.mesh.positions[v], s.positions[v]);
  }
  EXPECT_TRUE(checking::audit(solid.mesh, s, Side::kNegative, RunContext(), 1).facts.passed());
  for (std::size_t v = s.positions.size(); v < solid.mesh.positions.size(); ++v)
    EXPECT_TRUE(mesh::isFloat(solid.mesh.positions[v]));
}

TEST(Simplify, MakesFewTrianglesOfAPlane) {
  const TriangleMesh s = rounded(plane(20, 10));
  const Solid off = thicken(s, options(2, Simplify::kOff)), on = thicken(s, options(2, Simplify::kShell));
  EXPECT_EQ(countOf(off, Region::kShell), s.triangles.size());
  // Two would do but for the fans of the walls, whose triangles must be no needles.
  EXPECT_LE(countOf(on, Region::kShell), 32u);
  EXPECT_LE(countOf(on, Region::kWall), 4 * 20u + 40u)
      << "one for each rim edge, and one for each of the shell's";
  EXPECT_NEAR(on.report.volume, off.report.volume, 1e-3 * off.report.volume);
  EXPECT_EQ(on.report.simplify.before, off.report.triangles);
  EXPECT_EQ(on.report.simplify.after, on.mesh.triangles.size());
  EXPECT_LE(on.report.simplify.worstAspect, kNeedle);
  expectKept(on, s);
}

TEST(Simplify, LeavesTheCopyOfAnEvenSurfaceUnlessAskedFor) {
  const TriangleMesh s = rounded(sphere(4, 10));
  const Solid off = thicken(s, options(1, Simplify::kOff)), on = thicken(s, options(1, Simplify::kAuto));
  EXPECT_EQ(on.mesh.triangles, off.mesh.triangles);
  EXPECT_EQ(on.report.simplify.deviation, 0);
}

// Strips of a cylinder whose chords are off by no more than e to either side: a turn of t has the sagitta
// R (1 - cos t/2), of which one half is above the cylinder and one below.
TEST(Simplify, NeedsOfACylinderWhatTheSagittaSays) {
  constexpr double kRadius = 10, kR = 1, kAngle = kPi;
  const TriangleMesh s = rounded(cylinderPatch(256, kRadius, kAngle, 10));
  const Solid on = thicken(s, options(kR, Simplify::kShell));
  const auto strips = [](double e) { return kAngle / (2 * std::acos(1 - 2 * e / (kRadius - kR))); };
  EXPECT_GE(double(countOf(on, Region::kShell)), 2 * std::floor(strips(0.01 * kR)));
  EXPECT_LE(double(countOf(on, Region::kShell)), 6 * 2 * strips(0.007 * kR)) << "of " << s.triangles.size();
  EXPECT_LE(on.report.shellError.p99, 0.01);
  expectKept(on, s);
}

TEST(Simplify, KeepsAToleranceProved) {
  const TriangleMesh s = rounded(cylinderPatch(16, 10, kPi / 4, 5));
  Options asked = options(1, Simplify::kShell);
  asked.tolerance = 0.02;
  const Solid on = thicken(s, asked);
  asked.simplify = Simplify::kOff;
  const Solid off = thicken(s, asked);
  EXPECT_LT(2 * countOf(on, Region::kShell), countOf(off, Region::kShell));
  ASSERT_TRUE(on.report.shellErrorBound);
  EXPECT_LE(*on.report.shellErrorBound, 0.02);
  expectKept(on, s);
}

TEST(Simplify, MakesAContourAThirdAtMost) {
  const TriangleMesh s = rounded(sphere(2, 10, [](const Vec3& p) { return p.z() > 0; }));
  const Solid off = thicken(s, options(1.5, Simplify::kOff, Method::kReconstruct));
  const Solid on = thicken(s, options(1.5, Simplify::kAuto, Method::kReconstruct));
  EXPECT_LT(3 * on.mesh.triangles.size(), off.mesh.triangles.size());
  EXPECT_LE(on.report.shellError.p99, 0.01);
  expectKept(on, s);
}

TEST(Simplify, KeepsTheRimOnBothSides) {
  const TriangleMesh s = rounded(plane(12, 10));
  Options asked = options(1, Simplify::kShell);
  asked.side = Side::kBoth;
  const Solid on = thicken(s, asked);  // throws where the audit does not find the rim
  EXPECT_LT(4 * countOf(on, Region::kShell), 2 * s.triangles.size());
}

class SimplifyProperty : public ::testing::TestWithParam<int> {};

TEST_P(SimplifyProperty, RandomSolidsStayValidAndTheSameForAnyThreads) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  TriangleMesh s;
  for (double noise = 0.8; s.triangles.empty() || !check(s).valid(); noise *= 0.8)
    s = rounded(heightField(14, random, 0.25, noise));
  Options asked = options(0.08, Simplify::kShell, Method::kAuto);
  const Solid one = thicken(s, asked);
  asked.threads = 2;
  const Solid two = thicken(s, asked);
  EXPECT_EQ(one.mesh.positions, two.mesh.positions);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
  EXPECT_LT(one.report.simplify.after, one.report.simplify.before);
  expectKept(one, s);
}
INSTANTIATE_TEST_SUITE_P(Seeds, SimplifyProperty, ::testing::Range(0, 6));

TEST(Simplify, LeavesWhatIsNotClosed) {
  const TriangleMesh s = plane(4, 10);
  TriangleMesh solid = slab(s, 1);
  solid.triangles.pop_back();
  const TriangleMesh before = solid;
  std::vector<Region> region(solid.triangles.size(), Region::kShell);
  std::fill_n(region.begin(), s.triangles.size(), Region::kOriginal);
  const OwnJob own(s, 1);
  const SimplifyFacts facts = simplify::simplify(own.job, solid, region, Simplify::kShell);
  EXPECT_EQ(solid.triangles, before.triangles);
  EXPECT_EQ(facts.before, facts.after);
}

// Of a cavity smaller than the error that is allowed any place is near enough.
TEST(Simplify, TurnsNoSmallCavityInsideOut) {
  const TriangleMesh s = plane(4, 10);
  TriangleMesh solid = slab(s, 1);
  const std::size_t outer = solid.triangles.size(), before = solid.positions.size();
  const TriangleMesh cavity = sphere(3, 0.002);
  for (const Vec3& p : cavity.positions) solid.positions.push_back(roundToFloat(Vec3(p + Vec3(5, 5, -0.5))));
  for (const Triangle& t : cavity.triangles) {
    Triangle turned{t[0], t[2], t[1]};
    for (VertexId& v : turned) v += static_cast<VertexId>(before);
    solid.triangles.push_back(turned);
  }
  std::vector<Region> region(solid.triangles.size(), Region::kShell);
  std::fill_n(region.begin(), s.triangles.size(), Region::kOriginal);
  const OwnJob own(s, 1);
  (void)simplify::simplify(own.job, solid, region, Simplify::kShell);
  double volume = 0;
  for (const auto& [a, b, c] : solid.triangles) {
    const Vec3 from(5, 5, -0.5);
    const Vec3 p = solid.positions[a] - from, q = solid.positions[b] - from, r = solid.positions[c] - from;
    if (std::max({p.norm(), q.norm(), r.norm()}) < 0.1) volume += p.dot(q.cross(r)) / 6;
  }
  EXPECT_LT(solid.triangles.size(), outer + cavity.triangles.size() / 4);
  EXPECT_LT(volume, -0.4 * 4 / 3 * kPi * std::pow(0.002, 3));
}

// A wall below a rim that is straight but for a corner: all three corners of its cap are those of S.
TEST(Simplify, TurnsTheLongestEdgesOfCaps) {
  TriangleMesh s;
  s.positions = {{0, 0, 0}, {5, 0, 0.01f}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  s.triangles = {{0, 1, 4}, {1, 3, 4}, {1, 2, 3}};
  TriangleMesh solid = s;
  for (const VertexId v : {0, 2, 3, 4}) solid.positions.push_back(s.positions[v] - Vec3(0, 0, 1));
  for (const Triangle& t : {Triangle{2, 1, 0},
                            {2, 0, 5},
                            {2, 5, 6},
                            {3, 2, 6},
                            {3, 6, 7},
                            {4, 3, 7},
                            {4, 7, 8},
                            {0, 4, 8},
                            {0, 8, 5},
                            {5, 8, 7},
                            {5, 7, 6}})
    solid.triangles.push_back(t);
  std::vector<Region> region(solid.triangles.size(), Region::kWall);
  std::fill_n(region.begin(), s.triangles.size(), Region::kOriginal);
  std::fill_n(region.end() - 2, 2, Region::kShell);
  const OwnJob own(s, 1);
  const TriangleMesh before = solid;
  const SimplifyFacts facts = simplify::simplify(own.job, solid, region, Simplify::kAuto);
  EXPECT_EQ(solid.positions, before.positions);
  EXPECT_EQ(solid.triangles.size(), before.triangles.size());
  EXPECT_GT(aspectOf(s.positions[0], s.positions[1], s.positions[2]), 500);
  EXPECT_LT(facts.worstAspect, kNeedle);
  LinkedMesh links(solid.positions.size(), solid.triangles, 1);
  EXPECT_TRUE(links.isClosedManifold());
}

// There the rim has a wall above it and one below, and both would be better with its edge turned.
TEST(Simplify, TurnsNoRimEdgeBetweenTwoWalls) {
  TriangleMesh s;
  s.positions = {{0, 0, 0}, {10, 0, 0}, {5, 10, 0}};
  s.triangles = {{0, 1, 2}};
  TriangleMesh solid{s.positions, {}};
  for (const double z : {1, -1})
    for (const Vec3& p : s.positions) solid.positions.emplace_back(p + Vec3(0, 0, z));
  solid.positions.emplace_back(5, 0, 0.01f);  // of the shell above, as deep down as the rim nearly
  solid.triangles = {{0, 1, 9}, {1, 4, 9}, {0, 9, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}, {1, 0, 6},
                     {1, 6, 7}, {2, 1, 7}, {2, 7, 8}, {0, 2, 8}, {0, 8, 6}, {3, 9, 5}, {9, 4, 5}, {6, 8, 7}};
  std::vector<Region> region(solid.triangles.size(), Region::kWall);
  std::fill_n(region.end() - 3, 3, Region::kShell);
  Options both = options(1, Simplify::kAuto);
  both.side = Side::kBoth;
  const OwnJob own(s, both);
  (void)simplify::simplify(own.job, solid, region, Simplify::kAuto);
  EXPECT_TRUE(std::ranges::any_of(solid.triangles, [](const Triangle& t) {
    return std::ranges::count(t, VertexId{0}) + std::ranges::count(t, VertexId{1}) == 2;
  }));
}

// Else the progress stands still meanwhile.
TEST(Simplify, CountsTheEdgesThatItTries) {
  const TriangleMesh s = rounded(plane(40, 10));
  Solid solid = thicken(s, options(1, Simplify::kOff));
  const std::size_t blocks = solid.mesh.triangles.size() / 256;
  const OwnJob own(s, 1);
  (void)simplify::simplify(own.job, solid.mesh, solid.region, Simplify::kShell);
  EXPECT_GT(own.context.counted(), 3 * blocks) << "two are the search for targets";
}

TEST(Simplify, CanBeCancelled) {
  const TriangleMesh s = plane(8, 10);
  TriangleMesh solid = slab(s, 1);
  std::vector<Region> region(solid.triangles.size(), Region::kShell);
  OwnJob own(s, 1);
  own.context.cancel();
  EXPECT_THROW((void)simplify::simplify(own.job, solid, region, Simplify::kShell), Error);
}

TEST(LinkedMesh, CollapsesAnEdgeAndStaysClosed) {
  TriangleMesh mesh = sphere(1, 1);
  LinkedMesh links(mesh.positions.size(), mesh.triangles, 1);
  ASSERT_TRUE(links.isClosedManifold());
  std::vector<TriangleId> starA, starB;
  const VertexId a = mesh.triangles[0][0], b = mesh.triangles[0][1];
  links.starOf(a, starA);
  links.starOf(b, starB);
  ASSERT_TRUE(links.canCollapse(a, b, starA, starB));
  links.collapse(a, b, starB);
  TriangleMesh left = mesh;
  std::erase_if(left.triangles, [](const Triangle& t) { return t[0] == t[1]; });
  EXPECT_EQ(left.triangles.size(), mesh.triangles.size() - 2);
  LinkedMesh again(left.positions.size(), left.triangles, 1);
  EXPECT_TRUE(again.isClosedManifold());
  links.starOf(a, starA);
  EXPECT_EQ(starA.size() + 4, [&] {
    std::vector<TriangleId> before;
    TriangleMesh fresh = sphere(1, 1);
    LinkedMesh linked(fresh.positions.size(), fresh.triangles, 1);
    linked.starOf(a, before);
    return before.size() + starB.size();
  }());
}

TEST(LinkedMesh, TurnsEdgesAndStaysClosed) {
  TriangleMesh mesh = sphere(1, 1);
  const std::vector<Triangle> before = mesh.triangles;
  LinkedMesh links(mesh.positions.size(), mesh.triangles, 1);
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
    if (links.canTurn(t, t % 3)) links.turn(t, t % 3);
  EXPECT_NE(mesh.triangles, before);
  EXPECT_TRUE(links.isClosedManifold());
  std::vector<Triangle> triangles = mesh.triangles;
  const LinkedMesh fresh(mesh.positions.size(), triangles, 1);
  EXPECT_TRUE(fresh.isClosedManifold());
  for (TriangleId t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(links.neighbour(t, k), fresh.neighbour(t, k));
}

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(LinkedMesh, TurnsNoEdgeOfATetrahedron) {
  TriangleMesh mesh = tetrahedron();
  const LinkedMesh links(mesh.positions.size(), mesh.triangles, 1);
  for (TriangleId t = 0; t < 4; ++t)
    for (int k = 0; k < 3; ++k) EXPECT_FALSE(links.canTurn(t, k));
}

TEST(LinkedMesh, CollapsesNoTetrahedronAndNoNeck) {
  TriangleMesh mesh = tetrahedron();
  LinkedMesh links(mesh.positions.size(), mesh.triangles, 1);
  ASSERT_TRUE(links.isClosedManifold());
  std::vector<TriangleId> starA, starB;
  links.starOf(0, starA);
  links.starOf(1, starB);
  EXPECT_FALSE(links.canCollapse(0, 1, starA, starB));
}

TEST(LinkedMesh, TellsWhatIsNoClosedManifold) {
  TriangleMesh open = plane(2, 1);
  EXPECT_FALSE(LinkedMesh(open.positions.size(), open.triangles, 1).isClosedManifold());
  // two boxes with one corner in common
  TriangleMesh touching = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2}));
  EXPECT_TRUE(LinkedMesh(touching.positions.size(), touching.triangles, 1).isClosedManifold());
  for (Triangle& t : touching.triangles) std::ranges::replace(t, VertexId{8}, VertexId{7});
  EXPECT_FALSE(LinkedMesh(touching.positions.size(), touching.triangles, 1).isClosedManifold());
}

TEST(EdgeQueue, GivesTheCheapestFirst) {
  std::mt19937 random(1);
  EdgeQueue queue;
  std::vector<double> cost;
  for (VertexId i = 0; i < 1000; ++i) {
    cost.push_back(std::ldexp(double(random() % 1000), -int(random() % 40)));
    queue.push(cost.back(), {i, i + 1, 0, 0});
  }
  double last = 0;
  std::size_t count = 0;
  while (const auto next = queue.pop()) {
    EXPECT_GE(cost[next->a] * (1 + 1.0 / 32), last);
    last = cost[next->a];
    ++count;
  }
  EXPECT_EQ(count, cost.size());
  queue.push(3, {1, 2, 0, 0});
  EXPECT_TRUE(queue.pop()) << "a cheap one after dear ones";
}

TEST(Quadric, IsLeastWherePlanesMeetAndStaysBesideWhereTheyAreOne) {
  Quadric corner;
  corner.add(Vec3::UnitX(), {1, 0, 0}, 2);
  corner.add(Vec3::UnitY(), {0, 2, 0}, 1);
  corner.add(Vec3::UnitZ(), {0, 0, 3}, 1);
  EXPECT_LT((corner.leastNear({1, 2, 2}) - Vec3(1, 2, 3)).norm(), 0.01);
  EXPECT_NEAR(corner.at({2, 2, 3}), 2, 1e-12);
  Quadric flat;
  flat.add(Vec3::UnitZ(), {0, 0, 3}, 1);
  EXPECT_LT((flat.leastNear({5, 6, 3}) - Vec3(5, 6, 3)).norm(), 1e-9);
}

}  // namespace
}  // namespace thicken
