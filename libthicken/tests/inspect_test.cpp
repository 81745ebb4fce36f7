// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/inspect.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "analytic_surfaces.h"
#include "bvh/ray_tree.h"
#include "plain_shapes.h"
#include "thicken/error.h"
#include "thicken/report.h"

namespace thicken {

using bvh::RayTree;
using mesh::kNone;

namespace {

using shapes::box;
using shapes::reversed;
using shapes::together;

// A box with a cavity, in which another box with a cavity floats; and a box beside them.
TriangleMesh nested() {
  TriangleMesh mesh = box({0, 0, 0}, {20, 20, 20});
  mesh = together(mesh, reversed(box({1, 1, 1}, {19, 19, 19})));
  mesh = together(mesh, box({5, 5, 5}, {10, 10, 10}));
  mesh = together(mesh, reversed(box({6, 6, 6}, {9, 9, 9})));
  return together(mesh, box({30, 0, 0}, {31, 1, 1}));
}

TEST(Inspect, FindsTheShellsAndWhichLiesInWhich) {
  const Inspection found = inspect(nested());
  ASSERT_TRUE(found.audit.passed());
  ASSERT_EQ(found.shells.size(), 5u);
  const double volumes[] = {8000, 18. * 18 * 18, 125, 27, 1};
  const bool cavity[] = {false, true, false, true, false};
  const std::uint32_t within[] = {SolidShell::kNoShell, 0, 1, 2, SolidShell::kNoShell};
  for (std::size_t s = 0; s < 5; ++s) {
    EXPECT_NEAR(found.shells[s].volume, volumes[s], 1e-9) << s;
    EXPECT_EQ(found.shells[s].cavity, cavity[s]) << s;
    EXPECT_EQ(found.shells[s].within, within[s]) << s;
    EXPECT_EQ(found.shells[s].triangles, 12u);
    EXPECT_EQ(found.shellOfTriangle[12 * s + 5], s);
  }
  EXPECT_NEAR(found.volume, 8000 - 5832 + 125 - 27 + 1, 1e-9);
  EXPECT_NEAR(found.area, 6 * (400 + 324 + 25 + 9 + 1), 1e-9);
}

TEST(Inspect, SaysWhatIsWrong) {
  TriangleMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  const Inspection found = inspect(open);
  EXPECT_FALSE(found.audit.passed());
  EXPECT_FALSE(found.audit.closed);
  EXPECT_TRUE(found.shells.empty());
  ASSERT_FALSE(found.defects.empty());
  EXPECT_EQ(found.defects[0].count, 3u);
}

TEST(Inspect, ShellsTheWrongWayRoundAreNoCavities) {
  const Inspection found = inspect(together(box({0, 0, 0}, {9, 9, 9}), box({2, 2, 2}, {4, 4, 4})));
  EXPECT_FALSE(found.audit.oriented);
  EXPECT_TRUE(found.shells.empty());
}

TEST(Inspect, AsJson) {
  const auto json = nlohmann::json::parse(toJson(inspect(nested())));
  EXPECT_EQ(json["status"], "ok");
  EXPECT_EQ(json["shells"].size(), 5u);
  EXPECT_TRUE(json["shells"][0]["within"].is_null());
  EXPECT_EQ(json["shells"][3]["within"], 2);
  EXPECT_EQ(json["shells"][3]["cavity"], true);
}

TEST(WallThickness, OfAPlateAndOfAHollowBox) {
  for (const double t : wallThickness(box({0, 0, 0}, {10, 10, 10}))) EXPECT_NEAR(t, 10, 1e-9);
  for (const double t :
       wallThickness(together(box({0, 0, 0}, {20, 20, 20}), reversed(box({2, 2, 2}, {18, 18, 18})))))
    EXPECT_NEAR(t, 2, 1e-9);
}

TEST(WallThickness, BetweenSpheres) {
  const auto sphere = [](double radius) {
    TriangleMesh mesh = shapes::parametric(64, 32, [&](double u, double v) -> Vec3 {
      const double turn = 2 * shapes::kPi * u, rise = shapes::kPi * (0.02 + 0.96 * v);
      return Vec3(std::sin(rise) * std::cos(turn), std::sin(rise) * std::sin(turn), -std::cos(rise)) * radius;
    });
    return mesh;
  };
  // open at the poles: a ray through the wall does not mind
  const auto walls = wallThickness(together(sphere(10), reversed(sphere(8.5))));
  for (const double t : walls) EXPECT_NEAR(t, 1.5, 0.1);
}

TEST(WallThickness, SharpEdgesAreNoThinWalls) {
  // a wedge of 10 degrees: near its edge the next triangle is closer than any wall
  TriangleMesh wedge;
  const double rise = 10 * std::tan(shapes::kPi / 18);
  wedge.positions = {{0, 0, 0}, {10, 0, 0}, {10, 0, rise}, {0, 10, 0}, {10, 10, 0}, {10, 10, rise}};
  wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {0, 3, 5}, {0, 5, 2}};
  ASSERT_TRUE(inspect(reversed(wedge)).audit.passed() || inspect(wedge).audit.passed());
  for (const double t : wallThickness(wedge)) EXPECT_GT(t, 1);
}

TEST(WallThickness, WhatDoesNotFaceTheOtherWayIsNoWall) {
  // A floor that faces down, a lid that faces up 1 mm above it, and a steep side that comes close to it.
  TriangleMesh mesh;
  mesh.positions = {{-10, -10, 0}, {-10, 30, 0},    {30, -10, 0},     {3, 3, 1},        {4, 3, 1},
                    {3, 4, 1},     {0.035, 0, 0.1}, {0.07, 0.1, 0.2}, {0.035, 0.2, 0.1}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 8, 7}};
  const auto walls = wallThickness(mesh);
  EXPECT_DOUBLE_EQ(walls[1], 1);
  EXPECT_TRUE(std::isinf(walls[2])) << walls[2];
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);  // the floor turned over faces the lid
  EXPECT_TRUE(std::isinf(wallThickness(mesh)[1]));
}

TEST(WallThickness, NeitherBeginsNorEndsAtACrossSection) {
  const TriangleMesh cube = box({0, 0, 0}, {10, 10, 10});
  std::vector<std::uint8_t> isEdge(cube.triangles.size(), 0);
  const auto facesUp = [&](TriangleId t) {
    return cube.positions[cube.triangles[t][0]][2] == 10 && cube.positions[cube.triangles[t][1]][2] == 10 &&
           cube.positions[cube.triangles[t][2]][2] == 10;
  };
  for (TriangleId t = 0; t < cube.triangles.size(); ++t) isEdge[t] = facesUp(t) ? 1 : 0;
  const auto walls = wallThickness(cube, {}, 0, isEdge);
  EXPECT_EQ(std::ranges::count_if(walls, [](double t) { return std::isinf(t); }),
            4);  // the lid, and the floor
}

TEST(WallThickness, SameForAnyNumberOfThreads) {
  EXPECT_EQ(wallThickness(nested(), {}, 1), wallThickness(nested(), {}, 2));
}

TEST(RayTree, FindsTheFirstOfManyTriangles) {
  TriangleMesh mesh;
  for (int k = 0; k < 500; ++k) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    const double z = (k * 197) % 500 + 1;
    mesh.positions.insert(mesh.positions.end(), {{-1, -1, z}, {2, -1, z}, {-1, 2, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const RayTree tree(mesh.positions, mesh.triangles);
  const Triangle none{kNone, kNone, kNone};
  const RayTree::Hit hit = tree.first({0, 0, 0.25}, {0, 0, 1}, none);
  EXPECT_DOUBLE_EQ(hit.along, 0.75);
  EXPECT_EQ(mesh.positions[mesh.triangles[hit.triangle][0]][2], 1);
  const RayTree::Hit second = tree.first({0, 0, 0.25}, {0, 0, 1}, mesh.triangles[hit.triangle]);
  EXPECT_DOUBLE_EQ(second.along, 1.75);
  EXPECT_TRUE(std::isinf(tree.first({5, 5, 0}, {0, 0, 1}, none).along));
  EXPECT_TRUE(std::isinf(tree.first({0, 0, 0.25}, {0, 0, -1}, none).along));
}

// Counts boxes, not time: a ray looks into those along its way, whether it meets a triangle or not.
TEST(RayTree, LeavesOutTheBoxesThatTheRayMisses) {
  constexpr int kSide = 100;
  TriangleMesh mesh;
  for (VertexId y = 0; y <= kSide; ++y)
    for (VertexId x = 0; x <= kSide; ++x)
      mesh.positions.emplace_back(x, y, std::sin(0.2 * x) + std::cos(0.3 * y));
  for (VertexId y = 0; y < kSide; ++y) {
    for (VertexId x = 0; x < kSide; ++x) {
      const VertexId a = y * (kSide + 1) + x, b = a + 1, c = a + kSide + 1, d = c + 1;
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  }
  const RayTree tree(mesh.positions, mesh.triangles);
  const Triangle none{kNone, kNone, kNone};
  constexpr std::uint32_t kFew = 100;  // of about 8,000 boxes; a way from the root to a leaf has 14
  const RayTree::Hit met = tree.first({50.3, 50.6, 9}, {0, 0, -1}, none);
  EXPECT_TRUE(std::isfinite(met.along));
  EXPECT_LE(met.opened, kFew);
  const RayTree::Hit away = tree.first({50.3, 50.6, 9}, {0, 0, 1}, none);
  EXPECT_TRUE(std::isinf(away.along));
  EXPECT_LE(away.opened, 1u);
  const RayTree::Hit past = tree.first({-0.5, 50.6, 0}, Vec3(0.02, 0, -1).normalized(), none);
  EXPECT_TRUE(std::isinf(past.along));
  EXPECT_LE(past.opened, kFew);
}

}  // namespace
}  // namespace thicken
