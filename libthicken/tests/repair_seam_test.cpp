// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Seams whose rims have different corners.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cut_surfaces.h"
#include "plain_shapes.h"
#include "repair_options.h"
#include "thicken/repair.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

using shapes::CutSurface;
using shapes::SurfaceCutter;

constexpr unsigned kSeeds = 20;

TEST(RepairSeams, JoinsSurfacesCutAlongRandomCurves) {
  for (const double jitter : {0.01, 0.03, 0.1, 0.2, 0.3, 0.5}) {
    unsigned joined = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", jitter " << jitter);
      const CutSurface cut = SurfaceCutter(seed, jitter).make();
      const RepairResult result = repair(weld(cut.mesh), weldOver(2 * jitter * cut.meanEdge), {}, 1);
      EXPECT_TRUE(check(result.mesh, {}, 1).valid());
      joined += result.facts.surface.components == cut.components;
    }
    EXPECT_GE(joined, std::ceil(0.95 * kSeeds)) << "jitter " << jitter;
  }
}

// What a weld may do to corners: each of the result is one of the input, and none moved farther than allowed.
TEST(RepairSeams, MakesNoNewCornersAndMovesNoneFarther) {
  const double jitter = 0.1;
  const CutSurface cut = SurfaceCutter(3, jitter).make();
  const double distance = 2 * jitter * cut.meanEdge;
  const TriangleMesh given = weld(cut.mesh);
  const RepairResult result = repair(given, weldOver(distance));
  ASSERT_EQ(result.facts.removed, 0u) << "choose a seed whose seam is clean";
  EXPECT_GT(result.facts.seams.joinedEdges, 0u);
  std::set<std::array<double, 3>> corners;
  for (const Vec3& p : given.positions) corners.insert({p[0], p[1], p[2]});
  for (const Vec3& p : result.mesh.positions) EXPECT_TRUE(corners.count({p[0], p[1], p[2]}) > 0);
  for (const Vec3& p : given.positions) {
    double least = 1e9;
    for (const Vec3& q : result.mesh.positions) least = std::min(least, (p - q).norm());
    EXPECT_LE(least, distance);
  }
}

// Two squares side by side with `gap` between them; their rims there have 4 and 7 edges.
TriangleMesh sideBySide(double gap) {
  TriangleMesh left = shapes::flatSheet(4, 4, 0), right = shapes::flatSheet(4, 7, 0);
  for (Vec3& p : right.positions) p = Vec3(p.x() + 4 + gap, p.y() * 4 / 7, 0);
  return weld(shapes::together(left, right));
}

TEST(RepairSeams, DividesTheEdgesOfBothRims) {
  const RepairResult result = repair(sideBySide(0.01), weldOver(0.02));
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(result.facts.removed, 0u);
  EXPECT_EQ(result.facts.seams.joinedEdges, 2u * 10) << "3 + 6 corners between the ends";
  EXPECT_EQ(result.facts.seams.left, 0u);
}

TEST(RepairSeams, JoinsNothingBeyondTheDistance) {
  const RepairResult result = repair(sideBySide(0.01), weldOver(0.009));
  EXPECT_EQ(result.facts.surface.components, 2u);
  EXPECT_TRUE(result.facts.changes.empty());
}

TEST(RepairSeams, JoinsThreePanelsWhereTheyMeet) {
  TriangleMesh mesh = sideBySide(0.01);
  TriangleMesh top = shapes::flatSheet(11, 3, 0);
  for (Vec3& p : top.positions) p = Vec3(p.x() * 8.01 / 11, p.y() + 4.01, 0);
  const RepairResult result = repair(weld(shapes::together(mesh, top)), weldOver(0.03));
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(result.facts.removed, 0u);
}

TEST(RepairSeams, JoinsPanelsOfOppositeSense) {
  TriangleMesh right = shapes::flatSheet(3, 5, 0);
  for (Vec3& p : right.positions) p = Vec3(p.x() + 4.01, p.y() * 4 / 5, 0);
  const RepairResult result =
      repair(weld(shapes::together(shapes::flatSheet(4, 4, 0), shapes::reversed(right))), weldOver(0.02));
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.removed, 0u);
}

TEST(RepairSeams, LeavesSheetsThatLieOnEachOther) {
  const TriangleMesh mesh = shapes::together(shapes::flatSheet(4, 4, 0), shapes::flatSheet(4, 4, 0.05));
  const RepairResult result = repair(mesh, weldOver(0.1));
  EXPECT_TRUE(result.facts.changes.empty());
  EXPECT_EQ(result.facts.surface.components, 2u);
  EXPECT_EQ(nearRims(mesh).corners, 0u);
}

TEST(RepairSeams, LeavesANarrowStripOpen) {
  TriangleMesh strip = shapes::flatSheet(20, 1, 0);
  for (Vec3& p : strip.positions) p.y() *= 0.1;
  const RepairResult result = repair(strip, weldOver(0.2));
  EXPECT_EQ(result.mesh.triangles.size(), strip.triangles.size());
  EXPECT_EQ(result.facts.surface.rims, 1u);
}

TEST(RepairSeams, NamesWhatIsNearAndHowFar) {
  const NearRims near = nearRims(sideBySide(0.01));
  EXPECT_EQ(near.corners, 5u + 8u);
  EXPECT_NEAR(near.distance, 0.01, 1e-12);
  EXPECT_EQ(nearRims(shapes::flatSheet(5, 5, 0)).corners, 0u);
  const RepairResult joined = repair(sideBySide(0.01), weldOver(near.distance));
  EXPECT_EQ(joined.facts.surface.components, 1u);
  EXPECT_EQ(nearRims(joined.mesh).corners, 0u);
}

TEST(RepairSeams, GivesTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = weld(SurfaceCutter(9, 0.2).make().mesh);
  const RepairResult one = repair(mesh, weldOver(0.02), {}, 1), three = repair(mesh, weldOver(0.02), {}, 3);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.mesh.positions, three.mesh.positions);
}

TEST(RepairSeams, AreThickAtTheSeam) {
  Options options;
  options.thickness = 0.5;
  options.repair = true;
  options.weld = 0.02;
  options.method = Method::kSweep;
  const Solid solid = thicken(sideBySide(0.01), options);
  EXPECT_GE(solid.report.thinnestWall, 0.4999);
  EXPECT_EQ(solid.report.components, 1u);
}

// A wall in the middle of a floor loses a strip to it: more than 5 % where it is low.
TriangleMesh lowWall() {
  TriangleMesh mesh = shapes::flatSheet(2, 8, 0);
  const auto first = static_cast<VertexId>(mesh.positions.size());
  for (VertexId y = 0; y <= 8; ++y) mesh.positions.emplace_back(1, y, 4);
  for (VertexId y = 0; y < 8; ++y) {
    mesh.triangles.push_back({3 * y + 1, 3 * y + 4, first + y + 1});
    mesh.triangles.push_back({3 * y + 1, first + y + 1, first + y});
  }
  return mesh;
}

TEST(RepairOutcome, WarnsOfALossAndRefusesItWhereStrict) {
  Options options;
  options.thickness = 0.2;
  options.repair = true;
  options.method = Method::kSweep;
  const Solid solid = thicken(lowWall(), options);
  ASSERT_GE(solid.report.warnings.size(), 2u);
  const auto tells = [](const std::string& text) {
    return text.find("the repair removed") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(solid.report.warnings.begin(), solid.report.warnings.end(), tells));
  options.strict = true;
  try {
    (void)thicken(lowWall(), options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNoSolid);
    EXPECT_TRUE(tells(error.what()));
  }
}

TEST(RepairOutcome, IsContentWithASmallLoss) {
  TriangleMesh fin = shapes::flatSheet(8, 8, 0);
  fin.positions.emplace_back(4, 3.5, 1);
  fin.triangles.push_back({31, 40, 81});
  Options options;
  options.thickness = 0.2;
  options.repair = true;
  options.strict = true;
  options.method = Method::kSweep;
  EXPECT_TRUE(thicken(fin, options).report.audit.passed());
}

}  // namespace
}  // namespace thicken
