// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/repair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>
#include <set>

#include "analytic_surfaces.h"
#include "plain_shapes.h"
#include "repair_options.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

using shapes::sheet;

const RepairChange* changeOf(const RepairResult& result, RepairKind kind) {
  for (const RepairChange& change : result.facts.changes)
    if (change.kind == kind) return &change;
  return nullptr;
}

std::size_t countOf(const RepairResult& result, RepairKind kind) {
  const RepairChange* change = changeOf(result, kind);
  return change == nullptr ? 0 : change->count;
}

double areaOf(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    sum += (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).norm() / 2;
  }
  return sum;
}

using Corner = std::array<double, 3>;
std::set<std::set<Corner>> cornersOf(const TriangleMesh& mesh) {
  std::set<std::set<Corner>> all;
  for (const Triangle& t : mesh.triangles) {
    std::set<Corner> corners;
    for (const VertexId v : t)
      corners.insert({mesh.positions[v][0], mesh.positions[v][1], mesh.positions[v][2]});
    all.insert(corners);
  }
  return all;
}

// What every repair has to keep: a valid surface, of triangles of the input alone where none was
// divided or welded, and an account that adds up.
RepairResult repaired(const TriangleMesh& surface, const RepairOptions& options = {}) {
  RepairResult result = repair(surface, options);
  EXPECT_TRUE(check(result.mesh).valid());
  EXPECT_EQ(result.origin.size(), result.mesh.triangles.size());
  EXPECT_EQ(result.facts.surface.triangles, result.mesh.triangles.size());
  std::size_t removed = 0;
  for (const RepairChange& change : result.facts.changes) {
    EXPECT_GT(change.count, 0u);
    EXPECT_FALSE(change.triangles.empty());
    EXPECT_TRUE(std::is_sorted(change.triangles.begin(), change.triangles.end()));
    if (removes(change.kind)) removed += change.count;
  }
  EXPECT_EQ(removed, result.facts.removed);
  if (countOf(result, RepairKind::kDivided) > 0 || countOf(result, RepairKind::kWelded) > 0) return result;
  EXPECT_EQ(result.mesh.triangles.size() + removed, surface.triangles.size());
  const auto before = cornersOf(surface), after = cornersOf(result.mesh);
  EXPECT_TRUE(std::includes(before.begin(), before.end(), after.begin(), after.end()))
      << "a corner was moved";
  return result;
}

ErrorCode codeOf(const TriangleMesh& surface) {
  try {
    (void)repair(surface);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()), "");
    return error.code();
  }
  ADD_FAILURE() << "a repair that leaves nothing has to fail";
  return ErrorCode::kInternal;
}

TEST(Repair, LeavesAValidSurfaceAsItIs) {
  std::mt19937 random(3);
  for (const TriangleMesh& mesh :
       {sheet(5, 4), shapes::box({0, 0, 0}, {1, 2, 3}), shapes::heightField(20, random, 0.2, 0.4)}) {
    const RepairResult result = repaired(mesh);
    EXPECT_TRUE(result.facts.changes.empty());
    EXPECT_EQ(result.mesh.triangles, mesh.triangles);
    EXPECT_EQ(result.mesh.positions, mesh.positions);
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) EXPECT_EQ(result.origin[t], t);
  }
}

TEST(Repair, WeldsCornersThatARoundingTookApart) {
  const TriangleMesh whole = sheet(6, 6);
  TriangleMesh soup;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-1e-7, 1e-7);
  for (const Triangle& t : whole.triangles) {
    const auto first = static_cast<VertexId>(soup.positions.size());
    for (const VertexId v : t)
      soup.positions.push_back(whole.positions[v] + Vec3(off(random), off(random), off(random)));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const RepairResult result = repaired(soup, weldOver(1e-6));
  EXPECT_EQ(result.mesh.triangles.size(), whole.triangles.size());
  EXPECT_EQ(result.mesh.positions.size(), whole.positions.size());
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(countOf(result, RepairKind::kWelded), soup.positions.size() - whole.positions.size());
  EXPECT_EQ(result.facts.removed, 0u);
  EXPECT_EQ(result.facts.weldDistance, 1e-6);
}

TEST(Repair, WeldsNothingBeyondTheDistanceAndNoTriangleAway) {
  TriangleMesh apart = shapes::together(sheet(2, 2), sheet(2, 2));
  for (VertexId v = 9; v < 18; ++v) apart.positions[v] += Vec3(2.01, 0.02, 0);
  EXPECT_EQ(countOf(repaired(apart, weldOver(0.005)), RepairKind::kWelded), 0u);
  // within the distance the least triangle is much smaller than it: half its edges is the limit
  TriangleMesh small = sheet(3, 3);
  for (Vec3& p : small.positions) p *= 1e-3;
  const RepairResult result = repaired(small, weldOver(1.0));
  EXPECT_EQ(result.mesh.triangles.size(), small.triangles.size());
  EXPECT_EQ(countOf(result, RepairKind::kWelded), 0u);
}

TEST(Repair, RefusesADistanceThatIsNone) {
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    try {
      (void)repair(sheet(2, 2), weldOver(bad));
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidArgument);
    }
  }
}

TEST(Repair, DropsWhatIsNoTriangle) {
  TriangleMesh mesh = sheet(4, 4);
  const Triangle twice = mesh.triangles[5];
  mesh.triangles.push_back({twice[1], twice[2], twice[0]});
  mesh.triangles.push_back({twice[1], twice[0], twice[2]});
  mesh.triangles.push_back({3, 3, 4});
  mesh.positions.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  mesh.triangles.push_back({0, 1, static_cast<VertexId>(mesh.positions.size() - 1)});
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(cornersOf(result.mesh), cornersOf(sheet(4, 4)));
  EXPECT_EQ(changeOf(result, RepairKind::kDuplicate)->triangles, (std::vector<TriangleId>{32, 33}));
  EXPECT_EQ(changeOf(result, RepairKind::kDegenerate)->triangles, (std::vector<TriangleId>{34}));
  EXPECT_EQ(changeOf(result, RepairKind::kNotFinite)->triangles, (std::vector<TriangleId>{35}));
}

// A flat sheet in which the edge from (1, 1) to (3, 1) has a triangle without area on it.
TEST(Repair, DividesTheNeighbourOfATriangleWithoutArea) {
  const TriangleMesh mesh{{{1, 1, 0}, {3, 1, 0}, {2, 2, 0}, {2, 1, 0}, {2, 0, 0}},
                          {{0, 1, 2}, {0, 3, 1}, {4, 3, 0}, {3, 4, 1}}};
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(countOf(result, RepairKind::kDegenerate), 1u);
  EXPECT_EQ(changeOf(result, RepairKind::kDivided)->triangles, std::vector<TriangleId>{0});
  EXPECT_EQ(result.facts.removedArea, 0);
  EXPECT_EQ(areaOf(result.mesh), areaOf(mesh));
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(result.mesh.triangles.size(), 4u);
  EXPECT_EQ(result.origin, (std::vector<TriangleId>{0, 0, 2, 3}));
}

TEST(Repair, JoinsSheetsWhoseRimsHaveDifferentCorners) {
  TriangleMesh coarse{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}}, {{0, 1, 3}, {0, 3, 2}}};
  TriangleMesh fine;
  for (VertexId i = 0; i <= 4; ++i) fine.positions.emplace_back(i, 0, 0);
  for (VertexId i = 0; i <= 4; ++i) fine.positions.emplace_back(i, -1, 0);
  for (VertexId i = 0; i < 4; ++i) {
    fine.triangles.push_back({i, 5 + i, i + 1});
    fine.triangles.push_back({5 + i, 6 + i, i + 1});
  }
  const RepairResult result = repaired(weld(shapes::together(coarse, fine)));
  EXPECT_EQ(result.facts.removed, 0u);
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(areaOf(result.mesh), 20);
}

TEST(Repair, TurnsTheSmallerPartOver) {
  TriangleMesh mesh = sheet(6, 6);
  for (const TriangleId t : {4u, 5u, 20u}) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(changeOf(result, RepairKind::kTurned)->triangles, (std::vector<TriangleId>{4, 5, 20}));
  EXPECT_EQ(result.facts.removed, 0u);
  EXPECT_EQ(repaired(shapes::reversed(mesh)).facts.changes.front().triangles,
            (std::vector<TriangleId>{4, 5, 20}))
      << "the larger part decides";
}

TEST(Repair, CutsAMoebiusStripAcross) {
  const TriangleMesh mesh = shapes::moebius(24);
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(countOf(result, RepairKind::kOneSided), result.facts.removed);
  EXPECT_LE(result.facts.removed, 2u) << "the strip is one quadrilateral wide";
  EXPECT_GE(result.facts.removed, 1u);
  EXPECT_EQ(result.facts.surface.rims, 1u);
}

TEST(Repair, RemovesTheFinAndNotWhatItStandsOn) {
  TriangleMesh mesh = sheet(4, 4);
  mesh.positions.emplace_back(2, 1.5, 2);
  mesh.triangles.push_back({7, 12, 25});
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(changeOf(result, RepairKind::kNonManifoldEdge)->triangles, std::vector<TriangleId>{32});
  ASSERT_EQ(countOf(result, RepairKind::kCrumb), 1u) << "its tip";
  EXPECT_EQ(cornersOf(result.mesh), cornersOf(sheet(4, 4)));
}

// Three sheets of four cells each along one line, of different widths.
TEST(Repair, CutsOneSheetOfThreeAlongTheirCommonEdge) {
  TriangleMesh mesh;
  for (int blade = 0; blade < 3; ++blade) {
    const Vec3 out(std::cos(2.1 * blade), std::sin(2.1 * blade), 0);
    const auto first = static_cast<VertexId>(mesh.positions.size());
    for (int i = 0; i <= 4; ++i)
      for (int k = 0; k < 3; ++k) mesh.positions.push_back(Vec3(0, 0, i) + k * (1 + 0.5 * blade) * out);
    for (VertexId i = 0; i < 4; ++i)
      for (VertexId k = 0; k < 2; ++k) {
        const VertexId a = first + 3 * i + k;
        mesh.triangles.push_back({a, a + 1, a + 4});
        mesh.triangles.push_back({a, a + 4, a + 3});
      }
  }
  const RepairResult result = repaired(weld(mesh));
  EXPECT_EQ(result.facts.surface.components, 2u);
  EXPECT_EQ(countOf(result, RepairKind::kNonManifoldEdge), result.facts.removed);
  for (const TriangleId t : changeOf(result, RepairKind::kNonManifoldEdge)->triangles)
    EXPECT_TRUE(t < 16 && t % 4 < 2) << "the narrowest sheet gives way, in one row of four cells";
  EXPECT_LT(result.facts.removedArea, 0.5 * 4) << "a quarter of the row's width, less at the apexes";
}

TEST(Repair, LeavesOnePartAtAVertexWhereTwoTouch) {
  TriangleMesh mesh = shapes::together(sheet(4, 4), sheet(2, 2));
  const Vec3 shift = mesh.positions[24] - mesh.positions[25];
  for (VertexId v = 25; v < 34; ++v) mesh.positions[v] += shift;
  const RepairResult result = repaired(weld(mesh));
  EXPECT_EQ(countOf(result, RepairKind::kNonManifoldVertex), 2u);
  EXPECT_EQ(result.facts.surface.components, 2u);
  for (const TriangleId t : changeOf(result, RepairKind::kNonManifoldVertex)->triangles) EXPECT_GE(t, 32u);
  EXPECT_NEAR(result.facts.removedArea, 2 * 0.6 / 16, 0.2 / 16)
      << "a corner a quarter as long as the triangle";
}

// Every other cell of a board, each of two triangles: all corners inside touch two cells.
TEST(Repair, OpensACheckerWithoutLosingMuchOfIt) {
  TriangleMesh mesh;
  const TriangleMesh board = sheet(8, 8);
  mesh.positions = board.positions;
  for (VertexId y = 0; y < 8; ++y)
    for (VertexId x = y % 2; x < 8; x += 2)
      for (VertexId k = 0; k < 2; ++k) mesh.triangles.push_back(board.triangles[2 * (8 * y + x) + k]);
  mesh = weld(mesh);
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(result.facts.surface.components, 32u) << "no cell is lost";
  EXPECT_LT(result.facts.removedArea, 0.15 * areaOf(mesh));
}

// A wall on a floor, of more area than either half of the floor.
TEST(Repair, KeepsTheSheetThatRunsThrough) {
  TriangleMesh mesh = sheet(8, 8);
  for (Vec3& p : mesh.positions) p.z() = 0;
  const auto first = static_cast<VertexId>(mesh.positions.size());
  for (VertexId z = 1; z <= 7; ++z)
    for (VertexId y = 0; y <= 8; ++y) mesh.positions.emplace_back(4, y, z);
  const auto id = [&](VertexId y, VertexId z) { return z == 0 ? 9 * y + 4 : first + 9 * (z - 1) + y; };
  for (VertexId z = 0; z < 7; ++z)
    for (VertexId y = 0; y < 8; ++y) {
      mesh.triangles.push_back({id(y, z), id(y + 1, z), id(y + 1, z + 1)});
      mesh.triangles.push_back({id(y, z), id(y + 1, z + 1), id(y, z + 1)});
    }
  const RepairResult result = repaired(mesh);
  EXPECT_EQ(result.facts.surface.components, 2u);
  EXPECT_EQ(result.facts.surface.rims, 2u) << "no hole in the floor";
  for (const TriangleId t : changeOf(result, RepairKind::kNonManifoldEdge)->triangles)
    EXPECT_GE(t, 128u) << "the floor keeps all of its triangles";
  const double wall = 7 * 8;
  EXPECT_LT(result.facts.removedArea, 0.06 * wall);
}

// Two passes over one place with a shift that makes them cross in every triangle or two.
TEST(Repair, RemovesAnOverlapAsOnePatch) {
  std::mt19937 random(7);
  TriangleMesh one = shapes::heightField(30, random, 0, 0.3), other = shapes::heightField(30, random, 0, 0.3);
  for (Vec3& p : other.positions) p += Vec3(0.6, 0.013, 0);
  for (Vec3& p : one.positions) p.x() *= 1.1;
  const TriangleMesh mesh = shapes::together(one, other);
  const RepairResult result = repaired(mesh);
  EXPECT_GT(countOf(result, RepairKind::kOverlapping), 500u);
  EXPECT_EQ(result.facts.surface.components, 2u) << "no crumbs";
  EXPECT_EQ(result.facts.surface.rims, 2u) << "no holes";
  for (const TriangleId t : changeOf(result, RepairKind::kOverlapping)->triangles)
    EXPECT_GE(t, one.triangles.size()) << "the smaller part gives way";
}

TEST(Repair, OpensAsLittleAsAThornNeeds) {
  const TriangleMesh thorn{{{1.4, 1.5, -2}, {1.5, 1.4, -2}, {1.45, 1.5, 2}}, {{0, 1, 2}}};
  const RepairResult result = repaired(shapes::together(sheet(3, 3), thorn));
  EXPECT_EQ(result.facts.removed, 1u);
  EXPECT_EQ(countOf(result, RepairKind::kSelfIntersecting), 1u);
}

TEST(Repair, NeedsNoTriangleThatCouldBePutBack) {
  TriangleMesh mesh = shapes::together(sheet(20, 20), sheet(20, 20));
  for (std::size_t v = 441; v < mesh.positions.size(); ++v) {
    const Vec3 p = mesh.positions[v];
    mesh.positions[v] = Vec3(p.x() + 0.31, p.z() + 8.3, p.y() - 8.37);  // upright through the middle
  }
  const RepairResult result = repaired(mesh);
  EXPECT_GT(result.facts.removed, 10u);
  EXPECT_LT(result.facts.removedArea, 0.06 * areaOf(mesh));
  std::set<TriangleId> kept(result.origin.begin(), result.origin.end());
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    if (kept.count(t) > 0) continue;
    TriangleMesh more{mesh.positions, {}};
    for (const TriangleId k : kept) more.triangles.push_back(mesh.triangles[k]);
    more.triangles.push_back(mesh.triangles[t]);
    EXPECT_FALSE(check(weld(more)).valid()) << "triangle " << t << " need not have gone";
  }
}

TEST(Repair, EndsWhereEverythingMeetsEverything) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  TriangleMesh mesh;
  for (VertexId t = 0; t < 8000; ++t) {
    for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(u(random), u(random), u(random));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const RepairResult result = repaired(mesh);
  EXPECT_GT(result.mesh.triangles.size(), 10u);
}

TEST(Repair, SaysWhatWasWrongWhereNothingRemains) {
  EXPECT_EQ(codeOf({}), ErrorCode::kEmpty);
  EXPECT_EQ(codeOf({{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}}), ErrorCode::kDegenerate);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(codeOf({{{0, 0, nan}, {1, 0, 1}, {2, 2, 2}}, {{0, 1, 2}}}), ErrorCode::kNotFinite);
}

TEST(Repair, StopsWhenItIsCancelled) {
  RunContext context;
  context.cancel();
  try {
    (void)repair(shapes::moebius(30), {}, context);
    FAIL() << "a cancelled repair has to throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kCancelled);
  }
}

// Sheets with every kind of damage: the guarantee holds for all of them, and for any number of threads.
TriangleMesh damaged(std::mt19937& random) {
  const auto number = [&](std::uint32_t below) { return static_cast<std::uint32_t>(random() % below); };
  TriangleMesh mesh = shapes::heightField(12, random, 0.3, 2.5);
  TriangleMesh other = shapes::heightField(8, random, 0.3, 0.5);
  const Eigen::AngleAxisd turn(0.01 * number(600), Vec3(1, 0.01 * number(100), 0.3).normalized());
  for (Vec3& p : other.positions) p = turn * (p - Vec3(0.5, 0.5, 0)) + Vec3(0.5, 0.5, 0.1);
  mesh = shapes::together(mesh, other);
  const auto triangles = static_cast<TriangleId>(mesh.triangles.size());
  const auto vertices = static_cast<VertexId>(mesh.positions.size());
  for (int i = 0; i < 6; ++i) {
    std::swap(mesh.triangles[number(triangles)][0], mesh.triangles[number(triangles)][1]);
    Triangle& t = mesh.triangles[number(triangles)];
    std::swap(t[0], t[1]);
    mesh.triangles.push_back(mesh.triangles[number(triangles)]);
    mesh.triangles.push_back({number(vertices), number(vertices), number(vertices)});
  }
  mesh.positions[number(vertices)] = mesh.positions[number(vertices)];
  return weld(mesh);
}

TEST(RepairSlow, MakesAnyDamagedSurfaceValid) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const TriangleMesh mesh = damaged(random);
    const RepairResult result = repaired(mesh);
    EXPECT_FALSE(result.facts.changes.empty());
    EXPECT_GT(areaOf(result.mesh), 0.3 * areaOf(mesh));
    const RepairResult again = repaired(result.mesh);
    EXPECT_EQ(again.mesh.triangles, result.mesh.triangles);
  }
}

TEST(Repair, GivesTheSameForAnyNumberOfThreads) {
  std::mt19937 random(11);
  const TriangleMesh mesh = damaged(random);
  const RepairResult one = repair(mesh, {}, {}, 1), three = repair(mesh, {}, {}, 3);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.mesh.positions, three.mesh.positions);
  EXPECT_EQ(one.origin, three.origin);
}

TEST(Repair, IsMadeByThickenOnlyWhenAskedFor) {
  const TriangleMesh thorn{{{1.4, 1.5, -2}, {1.5, 1.4, -2}, {1.45, 1.5, 2}}, {{0, 1, 2}}};
  const TriangleMesh mesh = shapes::together(sheet(3, 3), thorn);
  Options options;
  options.thickness = 0.1;
  try {
    (void)thicken(mesh, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kSelfIntersecting);
    ASSERT_TRUE(error.input());
    EXPECT_EQ(error.input()->triangles, 19u);
    EXPECT_FALSE(error.repair());
  }
  options.repair = true;
  const Solid solid = thicken(mesh, options);
  EXPECT_TRUE(solid.report.audit.passed());
  EXPECT_EQ(solid.report.input.triangles, 19u);
  ASSERT_TRUE(solid.report.repair && solid.repaired);
  EXPECT_EQ(solid.report.repair->surface.triangles, 18u);
  EXPECT_EQ(solid.repaired->triangles.size(), 18u);
  EXPECT_EQ(solid.report.originalTriangles, 18u);
  ASSERT_FALSE(solid.report.warnings.empty());
  EXPECT_NE(solid.report.warnings[0].find("repaired"), std::string::npos);
}

TEST(Repair, ChangesNothingInTheSolidOfAValidSurface) {
  Options options;
  options.thickness = 0.2;
  const Solid plain = thicken(sheet(5, 5), options);
  options.repair = true;
  const Solid solid = thicken(sheet(5, 5), options);
  EXPECT_EQ(solid.mesh.positions, plain.mesh.positions);
  EXPECT_EQ(solid.mesh.triangles, plain.mesh.triangles);
  ASSERT_TRUE(solid.report.repair);
  EXPECT_TRUE(solid.report.repair->changes.empty());
  EXPECT_TRUE(solid.report.warnings.empty());
}

}  // namespace
}  // namespace thicken
