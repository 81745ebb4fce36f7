// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a repair adds between rims: strips across gaps and patches in holes. And what it divides: sheets.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "cut_surfaces.h"
#include "mesh/float_lattice.h"
#include "plain_shapes.h"
#include "repair/borders.h"
#include "repair/folds.h"
#include "repair/ledger.h"
#include "repair/notches.h"
#include "repair_options.h"
#include "thicken/sheets.h"
#include "thicken/thicken.h"

namespace thicken {
namespace {

std::size_t countOf(const RepairFacts& facts, RepairKind kind) {
  for (const RepairChange& change : facts.changes)
    if (change.kind == kind) return change.count;
  return 0;
}

// Everything that was there is still there, bit for bit, and the rest is marked as added.
void expectOnlyAdded(const TriangleMesh& given, const RepairResult& result, RepairKind kind) {
  EXPECT_TRUE(check(result.mesh, {}, 1).valid());
  EXPECT_EQ(result.facts.removed, 0u);
  std::vector<TriangleId> kept;
  std::size_t added = 0;
  for (TriangleId t = 0; t < result.mesh.triangles.size(); ++t) {
    if (result.origin[t] == RepairResult::kAdded) {
      ++added;
      continue;
    }
    kept.push_back(result.origin[t]);
    std::multiset<std::array<double, 3>> was, is;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &p = given.positions[given.triangles[result.origin[t]][k]],
                 &q = result.mesh.positions[result.mesh.triangles[t][k]];
      was.insert({p[0], p[1], p[2]});
      is.insert({q[0], q[1], q[2]});
    }
    EXPECT_EQ(was, is);
  }
  EXPECT_EQ(kept.size(), given.triangles.size());
  EXPECT_EQ(added, result.facts.added.triangles);
  EXPECT_EQ(added, countOf(result.facts, kind));
}

// A sphere of radius 1 without what is above `height`.
TriangleMesh bowl(double height, VertexId around = 48, VertexId rows = 24) {
  TriangleMesh mesh;
  const double low = -1.5707963, high = std::asin(height);
  mesh.positions.emplace_back(0, 0, -1);
  for (VertexId j = 1; j <= rows; ++j)
    for (VertexId i = 0; i < around; ++i) {
      const double up = low + (high - low) * j / rows, turn = 6.283185307 * i / around;
      mesh.positions.emplace_back(std::cos(up) * std::cos(turn), std::cos(up) * std::sin(turn), std::sin(up));
    }
  for (VertexId i = 0; i < around; ++i) {
    const VertexId next = (i + 1) % around;
    mesh.triangles.push_back({0, 1 + next, 1 + i});
    for (VertexId j = 0; j + 1 < rows; ++j) {
      const VertexId a = 1 + j * around + i, b = 1 + j * around + next;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

TEST(RepairFillsHoles, ClosesABowlLikeTheSphereThatItWas) {
  const TriangleMesh given = bowl(0.9);
  const RepairResult result = repair(given, filling(4));
  expectOnlyAdded(given, result, RepairKind::kFilled);
  EXPECT_TRUE(result.facts.surface.closed);
  EXPECT_EQ(result.facts.added.holes, 1u);
  // Flat, it would be at 0.9 with its middle, and 0.1 below the sphere.
  double highest = 0, off = 0, longest = 0;
  for (TriangleId t = 0; t < result.mesh.triangles.size(); ++t) {
    if (result.origin[t] != RepairResult::kAdded) continue;
    const Triangle& c = result.mesh.triangles[t];
    for (int k = 0; k < 3; ++k) {
      const Vec3& p = result.mesh.positions[c[k]];
      highest = std::max(highest, p.z());
      off = std::max(off, std::abs(p.norm() - 1));
      longest = std::max(longest, (p - result.mesh.positions[c[(k + 1) % 3]]).norm());
    }
  }
  EXPECT_GT(highest, 0.97);
  EXPECT_LT(off, 0.03);
  EXPECT_LT(longest, 0.3) << "the edges around the hole are 0.06 to 0.1 long";
}

TEST(RepairFillsHoles, LeavesLongerRimsOpen) {
  const TriangleMesh given = bowl(0.9);  // a rim of 2.74
  const RepairResult result = repair(given, filling(2.7));
  EXPECT_TRUE(result.facts.changes.empty());
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_EQ(result.facts.added.left, 0u);
}

TEST(RepairFillsHoles, NamesAHoleThatNoPatchFitsInto) {
  // A spike of a part of its own stands in the hole.
  TriangleMesh given = bowl(0.9);
  TriangleMesh spike;
  spike.positions = {Vec3(0, 0, 0), Vec3(0.05, 0, 2), Vec3(-0.05, 0.02, 2)};
  spike.triangles = {{0, 1, 2}};
  given = shapes::together(given, spike);
  const RepairResult result = repair(given, filling(3));
  EXPECT_EQ(result.mesh.triangles.size(), given.triangles.size());
  EXPECT_GE(result.facts.added.left, 1u);
  ASSERT_FALSE(result.facts.added.leftPlaces.empty());
}

TEST(RepairFillsHoles, KeepsThePatchInTheSolid) {
  TriangleMesh given = shapes::sheet(8, 8);
  given.triangles.erase(given.triangles.begin() + 54, given.triangles.begin() + 58);  // two cells
  Options options;
  options.thickness = 0.3;
  options.repair = true;
  options.fillHoles = 10;
  options.method = Method::kSweep;
  const Solid solid = thicken(given, options);
  EXPECT_EQ(solid.report.input.rims, 2u);
  ASSERT_TRUE(solid.report.repair.has_value());
  EXPECT_EQ(solid.report.repair->surface.rims, 1u);
  EXPECT_GE(solid.report.repair->added.triangles, 4u);
  const auto tells = [](const std::string& text) { return text.find("1 holes filled") != std::string::npos; };
  EXPECT_TRUE(std::any_of(solid.report.warnings.begin(), solid.report.warnings.end(), tells));
  const auto original = std::count(solid.region.begin(), solid.region.end(), Region::kOriginal);
  EXPECT_EQ(static_cast<std::size_t>(original), solid.report.repair->surface.triangles);
}

TEST(RepairFillsHoles, KeepsFloatsFloats) {
  TriangleMesh given = bowl(0.8);
  for (Vec3& p : given.positions) p = mesh::roundToFloat(p);
  const RepairResult result = repair(given, filling(10));
  EXPECT_TRUE(result.facts.surface.closed);
  EXPECT_TRUE(std::all_of(result.mesh.positions.begin(), result.mesh.positions.end(), mesh::isFloat));
}

// Two sheets side by side with `gap` between them, of `columns` and `others` edges there.
TriangleMesh panels(double gap, VertexId rows, VertexId others, bool turned = false) {
  const TriangleMesh left = shapes::flatSheet(4, rows, 0);
  TriangleMesh right = shapes::flatSheet(4, others, 0);
  for (Vec3& p : right.positions) p = Vec3(p.x() + 4 + gap, p.y() * rows / others, 0);
  return shapes::together(left, turned ? shapes::reversed(right) : right);
}

TEST(RepairBridges, JoinsParallelRimsWithDifferentCorners) {
  const TriangleMesh given = panels(0.5, 12, 19);
  const RepairResult result = repair(given, bridging(0.6));
  expectOnlyAdded(given, result, RepairKind::kBridged);
  EXPECT_EQ(result.facts.added.strips, 1u);
  EXPECT_EQ(result.facts.added.triangles, 12u + 19u);
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.surface.rims, 1u);
  EXPECT_NEAR(result.facts.added.area, 0.5 * 12, 1e-9);
}

TEST(RepairBridges, LeavesWiderGapsAndShortRuns) {
  EXPECT_TRUE(repair(panels(0.5, 12, 19), bridging(0.4)).facts.changes.empty());
  EXPECT_TRUE(repair(panels(2, 4, 4), bridging(3)).facts.changes.empty()) << "4 is less than 3 gaps of 2";
}

TEST(RepairBridges, TurnsOnePanelOver) {
  const RepairResult result = repair(panels(0.5, 12, 12, true), bridging(0.6));
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(countOf(result.facts, RepairKind::kTurned), 4u * 12 * 2);
  EXPECT_EQ(result.facts.removed, 0u);
}

TEST(RepairBridges, TurnsNothingOverAtAJaggedRim) {
  // Teeth of one rim that stand across the gap: beside them the rims run the same way.
  TriangleMesh given = panels(0.5, 12, 12);
  for (VertexId y = 1; y < 12; y += 2) given.positions[5 * y + 4] += Vec3(0.3, 0.45, 0);
  const RepairResult result = repair(given, bridging(0.6));
  EXPECT_EQ(countOf(result.facts, RepairKind::kTurned), 0u);
  EXPECT_EQ(result.facts.surface.components, 1u);
}

TEST(RepairBridges, ClosesARingAllAround) {
  TriangleMesh given;
  constexpr VertexId kAround = 40;
  for (const double z : {0.0, 1.0, 1.3, 2.3})
    for (VertexId i = 0; i < kAround; ++i) {
      const double turn = 6.283185307 * (i + (z > 1.1 ? 0.3 : 0)) / kAround;
      given.positions.emplace_back(3 * std::cos(turn), 3 * std::sin(turn), z);
    }
  for (const VertexId ring : {0u, 2 * kAround})
    for (VertexId i = 0; i < kAround; ++i) {
      const VertexId a = ring + i, b = ring + (i + 1) % kAround;
      given.triangles.push_back({a, b, b + kAround});
      given.triangles.push_back({a, b + kAround, a + kAround});
    }
  const RepairResult result = repair(given, bridging(0.4));
  expectOnlyAdded(given, result, RepairKind::kBridged);
  EXPECT_EQ(result.facts.surface.rims, 2u);
  EXPECT_EQ(result.facts.surface.components, 1u);
  EXPECT_EQ(result.facts.added.triangles, 2u * kAround);
}

TEST(RepairBridges, ClosesASlitToItsEnd) {
  // A sheet cut along y = 4 from one side to the middle and spread there.
  TriangleMesh given = shapes::flatSheet(12, 8, 0);
  const auto first = static_cast<VertexId>(given.positions.size());
  for (VertexId x = 0; x < 8; ++x) {
    given.positions.push_back(given.positions[4 * 13 + x] + Vec3(0, 0.05 * (8 - x), 0));
    for (TriangleId t = 4 * 24; t < 5 * 24; ++t)
      for (VertexId& v : given.triangles[t])
        if (v == 4 * 13 + x) v = first + x;
  }
  ASSERT_EQ(repair(given).facts.surface.rims, 1u);
  const RepairResult result = repair(given, bridging(0.5));
  expectOnlyAdded(given, result, RepairKind::kBridged);
  EXPECT_EQ(result.facts.added.triangles, 15u) << "8 edges on either side, which end in one corner";
}

TEST(RepairBridges, DoesNotBridgeLayers) {
  const TriangleMesh layers = shapes::together(shapes::flatSheet(9, 9, 0), shapes::flatSheet(9, 9, 0.3));
  EXPECT_TRUE(repair(layers, bridging(0.5)).facts.changes.empty());
}

TEST(RepairAdds, RefusesLengthsThatAreNone) {
  EXPECT_THROW((void)repair(shapes::sheet(3, 3), bridging(0)), Error);
  EXPECT_THROW((void)repair(shapes::sheet(3, 3), filling(-1)), Error);
}

// Panels with gaps between them and holes torn into them. Whatever is added, proved() has the last word.
TEST(RepairAdds, KeepsRandomTornSurfacesValid) {
  std::size_t strips = 0, holes = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto unit = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
    const shapes::CutSurface cut = shapes::SurfaceCutter(seed, 0.05).make();
    TriangleMesh torn = weld(cut.mesh);
    for (int hole = 0; hole < 4; ++hole) {
      const Vec3 middle = torn.positions[random() % torn.positions.size()];
      const double radius = (0.5 + 3 * unit()) * cut.meanEdge;
      std::erase_if(torn.triangles, [&](const Triangle& t) {
        const Vec3 p = (torn.positions[t[0]] + torn.positions[t[1]] + torn.positions[t[2]]) / 3;
        return (p - middle).norm() < radius;
      });
    }
    RepairOptions options = bridging((0.2 + 2 * unit()) * cut.meanEdge);
    options.longestHole = unit() < 0.3 ? 100 : (2 + 20 * unit()) * cut.meanEdge;
    const RepairResult result = repair(weld(torn), options, {}, 1);
    EXPECT_TRUE(check(result.mesh, {}, 1).valid());
    std::size_t removed = 0, added = 0;
    for (const RepairChange& change : result.facts.changes) {
      if (removes(change.kind)) removed += change.count;
      if (adds(change.kind)) added += change.count;
    }
    EXPECT_EQ(removed, result.facts.removed);
    EXPECT_EQ(added, result.facts.added.triangles);
    strips += result.facts.added.strips;
    holes += result.facts.added.holes;
  }
  EXPECT_GT(strips, 50u);
  EXPECT_GT(holes, 50u);
}

TEST(RepairBorders, LoseTheirTeethAndNothingElse) {
  repairing::Workpiece piece(shapes::flatSheet(6, 6, 0));
  for (TriangleId t = 24; t < 36; ++t)
    if (t != 28) piece.remove(t, RepairKind::kSelfIntersecting);
  piece.remove(0, RepairKind::kDuplicate);  // which leaves no hole: there is another
  repairing::smoothBorders(piece, piece.area(28) / 2);
  EXPECT_EQ(piece.present[28], 1);  // it costs more than that
  repairing::smoothBorders(piece, piece.area(28));
  EXPECT_EQ(piece.present[28], 0);
  EXPECT_EQ(piece.reason[28], RepairKind::kSmoothed);
  EXPECT_EQ(std::count(piece.present.begin(), piece.present.end(), 1), 72 - 12 - 1);
}

// A sheet without a triangle of its middle, and a thorn in that place, whose foot is `reach` of the way from
// the corner between two neighbours to the middle of the third edge.
repairing::Workpiece sheetWithThorn(TriangleId hole, double reach) {
  TriangleMesh mesh = shapes::flatSheet(6, 6, 0);
  const Triangle c = mesh.triangles[hole];
  const Vec3 a = mesh.positions[c[0]], b = 0.5 * (mesh.positions[c[1]] + mesh.positions[c[2]]);
  const Vec3 foot = a + reach * (b - a), along = 0.01 * (mesh.positions[c[2]] - mesh.positions[c[1]]);
  const auto first = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(),
                        {foot - along + Vec3(0, 0, 1), foot + along + Vec3(0, 0, 1), foot - Vec3(0, 0, 1)});
  mesh.triangles.push_back({first, first + 1, first + 2});
  repairing::Workpiece piece(mesh);
  piece.remove(hole, RepairKind::kSelfIntersecting);
  return piece;
}

TEST(RepairNotches, AreFilledAsFarAsAWallHasRoom) {
  const std::array<std::pair<double, double>, 2> shares{{{0.6, 1.0 / 3}, {0.9, 0.5}}};
  for (const auto& [reach, share] : shares) {
    repairing::Workpiece piece = sheetWithThorn(30, reach);
    const double whole = piece.area(30), back = repairing::fillNotches(piece, 1);
    EXPECT_NEAR(back, share * whole, 1e-12);
    const RepairResult result = repairing::packed(piece, 0, {});
    EXPECT_NEAR(result.facts.removedArea, whole - back, 1e-12);
    EXPECT_TRUE(check(result.mesh).valid());
  }
}

TEST(RepairNotches, OfWhatIsThereTwiceAreNone) {
  repairing::Workpiece piece = sheetWithThorn(30, 0.9);
  piece.reason[30] = RepairKind::kDuplicate;
  EXPECT_EQ(repairing::fillNotches(piece, 1), 0);
}

TEST(RepairFolds, LoseNoMoreThanAWallNeeds) {
  RepairResult before;
  before.mesh = shapes::flatSheet(20, 20, 0);
  before.origin.resize(before.mesh.triangles.size());
  std::iota(before.origin.begin(), before.origin.end(), 0u);
  const VertexId stuck = 21 * 5 + 5, free = 21 * 15 + 15;
  const Vec3 place = before.mesh.positions[stuck];
  // No wall fits as long as all six triangles around one of the two are there.
  repairing::FoldOpener folds([&](const TriangleMesh& patch) {
    std::map<VertexId, int> around;
    for (const Triangle& t : patch.triangles)
      for (const VertexId v : t)
        if (patch.positions[v] == place) ++around[v];
    std::vector<VertexId> named;
    for (const auto& [v, count] : around)
      if (count == 6) named.push_back(v);
    return named;
  });
  EXPECT_EQ(folds.open(before, std::vector<VertexId>{stuck, free}, {}, 1).facts.removed, 1u);
}

// A wall on a floor: at its foot three triangles meet.
TriangleMesh floorWithWall() {
  TriangleMesh mesh = shapes::flatSheet(6, 8, 0);
  const auto first = static_cast<VertexId>(mesh.positions.size());
  for (VertexId y = 0; y <= 8; ++y) mesh.positions.emplace_back(3, y, 4);
  for (VertexId y = 0; y < 8; ++y) {
    mesh.triangles.push_back({7 * y + 3, 7 * y + 10, first + y + 1});
    mesh.triangles.push_back({7 * y + 3, first + y + 1, first + y});
  }
  return mesh;
}

TEST(Sheets, AreWholeAndValidEach) {
  const TriangleMesh whole = floorWithWall();
  ASSERT_FALSE(check(whole).valid());
  const std::vector<Sheet> sheets = divideIntoSheets(whole);
  ASSERT_EQ(sheets.size(), 2u);
  EXPECT_EQ(sheets[0].mesh.triangles.size(), 6u * 8 * 2);
  EXPECT_EQ(sheets[1].mesh.triangles.size(), 8u * 2);
  std::vector<TriangleId> all;
  for (const Sheet& sheet : sheets) {
    EXPECT_TRUE(check(sheet.mesh).valid());
    for (TriangleId t = 0; t < sheet.origin.size(); ++t) {
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(sheet.mesh.positions[sheet.mesh.triangles[t][k]],
                  whole.positions[whole.triangles[sheet.origin[t]][k]]);
      all.push_back(sheet.origin[t]);
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<TriangleId> every(whole.triangles.size());
  std::iota(every.begin(), every.end(), 0u);
  EXPECT_EQ(all, every);
}

TEST(Sheets, AreOneForASurfaceWithoutSuchEdges) {
  EXPECT_EQ(divideIntoSheets(shapes::sheet(5, 5)).size(), 1u);
  EXPECT_TRUE(divideIntoSheets({}).empty());
}

TEST(Sheets, CrossEachOtherWhole) {
  // Two sheets through one line of edges: four triangles at each.
  TriangleMesh mesh = floorWithWall();
  const auto first = static_cast<VertexId>(mesh.positions.size());
  for (VertexId y = 0; y <= 8; ++y) mesh.positions.emplace_back(3, y, -4);
  for (VertexId y = 0; y < 8; ++y) {
    mesh.triangles.push_back({7 * y + 3, first + y + 1, 7 * y + 10});
    mesh.triangles.push_back({7 * y + 3, first + y, first + y + 1});
  }
  const std::vector<Sheet> sheets = divideIntoSheets(mesh);
  ASSERT_EQ(sheets.size(), 2u);
  EXPECT_EQ(sheets[0].mesh.triangles.size(), 4u * 8) << "the wall is larger than the floor";
  for (const Sheet& sheet : sheets) EXPECT_TRUE(check(sheet.mesh).valid());
}

}  // namespace
}  // namespace thicken
