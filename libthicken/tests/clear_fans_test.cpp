// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/clear_fans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analytic_surfaces.h"
#include "exact/triangle_pair.h"
#include "mesh/topology.h"

namespace thicken {
namespace {

// A fan of `blades` triangles around vertex 0 that goes round `turns` times, `lift` high at its rim.
TriangleMesh fan(VertexId blades, int turns, double lift, bool closed = true) {
  TriangleMesh mesh;
  mesh.positions.push_back(Vec3::Zero());
  for (VertexId i = 0; i < blades; ++i) {
    const double angle = 2 * shapes::kPi * turns * i / blades;
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), lift * (1 + i % 2));
  }
  for (VertexId i = 0; i + (closed ? 0 : 1) < blades; ++i)
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % blades});
  return mesh;
}

bool isClear(const TriangleMesh& mesh) {
  return exact::clearFans(mesh.positions, mesh.triangles, {}, 1)[0] != 0;
}

TEST(ClearFans, ProvesFansThatGoRoundOnce) {
  for (const double lift : {0.0, 0.3, -0.3})
    for (const VertexId blades : {3u, 4u, 6u, 17u}) {
      TriangleMesh mesh = fan(blades, 1, lift);
      EXPECT_TRUE(isClear(mesh)) << blades;
      for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);  // seen from below
      EXPECT_TRUE(isClear(mesh)) << blades;
      for (Vec3& p : mesh.positions) p = Vec3(p.y(), p.z(), p.x());  // along another axis
      EXPECT_TRUE(isClear(mesh)) << blades;
    }
}

TEST(ClearFans, SaysNothingOfOthers) {
  EXPECT_FALSE(isClear(fan(9, 2, 0.1)));         // over itself
  EXPECT_FALSE(isClear(fan(6, 1, 0.1, false)));  // at a rim
  TriangleMesh folded = fan(6, 1, 0);
  folded.positions[2] = Vec3(-0.4, -0.5, 0.1);
  EXPECT_FALSE(isClear(folded));
  TriangleMesh flat = fan(6, 1, 0);
  flat.positions[2] = Vec3::Zero();
  EXPECT_FALSE(isClear(flat));
  TriangleMesh twice = fan(6, 1, 0);
  twice.triangles.push_back(twice.triangles[0]);
  EXPECT_FALSE(isClear(twice));
  TriangleMesh fixed = fan(6, 1, 0);
  EXPECT_EQ(exact::clearFans(fixed.positions, fixed.triangles, std::vector<std::uint8_t>(6, 1), 1)[0], 0);
}

// Whatever is called clear is so by the tests of all pairs.
TEST(ClearFans, AgreesWithTheTestsOfPairs) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  int clear = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    TriangleMesh mesh = fan(static_cast<VertexId>(3 + trial % 6), 1 + trial % 2, 0.2);
    const double noise = trial % 5 * 0.3;
    for (Vec3& p : mesh.positions) {
      p += noise * Vec3(unit(random), unit(random), unit(random));
      if (trial % 3 == 0) p = (4 * p).array().round() / 4;  // many on lines and planes
    }
    if (!isClear(mesh)) continue;
    ++clear;
    for (std::size_t a = 0; a < mesh.triangles.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_FALSE(exact::meet(mesh.positions, mesh.triangles[a], mesh.triangles[b]));
  }
  EXPECT_GT(clear, 500);
}

}  // namespace
}  // namespace thicken
