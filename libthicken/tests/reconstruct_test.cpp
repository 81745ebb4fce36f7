// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/reconstruct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "analytic_surfaces.h"
#include "jobs.h"
#include "plain_shapes.h"
#include "reconstruct/cells.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/diagonals.h"
#include "reconstruct/loose_parts.h"
#include "reconstruct/strip_region.h"
#include "reconstruct/window.h"
#include "reconstruct/working_set.h"
#include "thicken/error.h"
#include "thicken/thicken.h"

namespace thicken {

using mesh::rimOf;
using reconstruct::Assembly;
using reconstruct::heldBytes;
using reconstruct::leanBytes;
using reconstruct::mostShellCrossings;
using reconstruct::Reconstruction;
using reconstruct::shellShadows;
using reconstruct::staysWithin;
using reconstruct::wholeBytes;
using reconstruct::widthWithRoom;
using reconstruct::Window;
using reconstruct::windowsOf;
using reconstruct::withWindows;
using reconstruct::WorkingSet;
using reconstruct::workingSetFor;

namespace {

Options by(double thickness, double cell, int threads = 1) {
  Options o;
  o.method = Method::kReconstruct;
  o.thickness = thickness;
  o.cell = cell;
  o.simplify = Simplify::kOff;  // the contour as it is made
  o.threads = threads;
  return o;
}

TriangleMesh flat(VertexId columns, VertexId rows) {
  return shapes::flatSheet(columns, rows, 0);
}

// thicken() throws unless its exact audit has passed, so that a return is a proof.
TEST(Reconstruct, MakesAPlateOfExactVolume) {
  const TriangleMesh plate = flat(10, 6);
  const Solid solid = thicken(plate, by(1, 0.3));
  EXPECT_TRUE(solid.report.audit.passed());
  EXPECT_NEAR(solid.report.volume, 60, 0.01);
  EXPECT_EQ(solid.report.method, Method::kReconstruct);
  EXPECT_LT(solid.report.shellError.p99, 1e-3);
  EXPECT_GT(solid.report.shellTriangles, 100u);
}

TEST(Reconstruct, ThickensABumpySheetOnEitherSide) {
  const TriangleMesh sheet = shapes::sheet(14, 11);
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    Options o = by(0.9, 0.25);
    o.side = side;
    const Solid solid = thicken(sheet, o);
    EXPECT_TRUE(solid.report.audit.surfaceKept);
    EXPECT_LT(solid.report.shellError.mean, 0.01);
  }
}

TEST(Reconstruct, HollowsAClosedSurface) {
  const Solid solid = thicken(shapes::box({0, 0, 0}, {8, 6, 5}), by(1, 0.3));
  EXPECT_EQ(solid.report.components, 2u);
  EXPECT_NEAR(solid.report.volume, 8 * 6 * 5 - 6 * 4 * 3, 0.5);
}

// Corners are where a copy of a vertex is nearer to S than the thickness, and a box has nothing but corners.
TEST(ReconstructSlow, FindsTheCavityOfABoxAtAnyThickness) {
  for (const Method method : {Method::kAuto, Method::kReconstruct})
    for (const double r : {0.1, 0.3, 0.5, 0.77, 1.0, 1.6, 2.2}) {
      Options options;
      options.thickness = r;
      options.method = method;
      const Solid solid = ::thicken::thicken(shapes::box({0, 0, 0}, {8, 6, 5}), options);
      EXPECT_EQ(solid.report.components, 2u) << r;
      EXPECT_NEAR(solid.report.volume, 240 - (8 - 2 * r) * (6 - 2 * r) * (5 - 2 * r), 0.01 * 240) << r;
    }
}

TEST(Reconstruct, GivesTheSameBytesForAnyThreads) {
  const TriangleMesh sheet = shapes::sheet(12, 9);
  const Solid one = thicken(sheet, by(0.9, 0.25, 1)), three = thicken(sheet, by(0.9, 0.25, 3));
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.mesh.positions, three.mesh.positions);
}

// Valleys of the sheet, which are edges for the material below them: the offset is round there, and no axis
// of the grid is along them.
TriangleMesh valleys() {
  TriangleMesh mesh = flat(12, 8);
  constexpr double kTurn = 0.4;
  for (Vec3& p : mesh.positions) {
    p.z() = std::abs(std::fmod(p.x(), 6) - 3);
    p = {std::cos(kTurn) * p.x() - std::sin(kTurn) * p.y(), std::sin(kTurn) * p.x() + std::cos(kTurn) * p.y(),
         p.z()};
  }
  return mesh;
}

TEST(Reconstruct, IsRoundBelowEdgesOfTheirRadius) {
  Options o;
  o.method = Method::kReconstruct;
  o.thickness = 0.8;
  o.simplify = Simplify::kOff;
  const Solid solid = thicken(valleys(), o);
  EXPECT_LT(solid.report.shellErrorFullDepth.p99, 0.0015);
  EXPECT_LT(solid.report.shellErrorFullDepth.mean, 0.00015);
}

// Two sheets that face each other at less than twice the thickness: Definition 2 ends the solid between them,
// where the sweep does, too.
TEST(Auto, LeavesSheetsThatMeetHalfwayToTheSweep) {
  TriangleMesh s = shapes::plane(12, 10), other = s;
  for (Vec3& p : other.positions) p = {p.x(), 10 - p.y(), -1.2};
  const auto first = static_cast<VertexId>(s.positions.size());
  s.positions.insert(s.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) s.triangles.push_back({first + a, first + b, first + c});
  Options o;
  o.thickness = 1;
  o.simplify = Simplify::kOff;
  const Solid made = thicken(s, o);
  o.method = Method::kSweep;
  const Solid swept = thicken(s, o);
  EXPECT_LT(made.report.triangles, 1.2 * double(swept.report.triangles))
      << "some where walls face each other";
  EXPECT_NEAR(made.report.volume, 1.2 * 100, 0.01 * 120);
}

TEST(Auto, LeavesMitredCreasesToTheSweepAndMakesRoundOnes) {
  Options o;
  o.thickness = 0.8;
  const Solid mitred = thicken(valleys(), o);
  EXPECT_EQ(mitred.report.method, Method::kSweep);
  EXPECT_LT(mitred.report.triangles, 3 * valleys().triangles.size());
  o.join = Join::kRound;
  const Solid round = thicken(valleys(), o);
  EXPECT_EQ(round.report.method, Method::kAuto);
  EXPECT_LT(round.report.shellErrorFullDepth.p99, 0.01);
  EXPECT_LT(round.report.volume, mitred.report.volume);
}

class Diagonals : public ::testing::Test {
 protected:
  Diagonals() {
    dual_.vertexCount = 4;
    dual_.faces = {{0, 1, 2, 3}};
    dual_.shared = {0};
    crossings_.resize(1);
    crossings_[0].normal = Vec3::UnitZ();
    assembly_.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    assembly_.crossing = {0, 0};
  }

  std::vector<Triangle> chosenFor(const std::vector<Vec3>& corners) {
    reconstruct::chooseDiagonals(assembly_, dual_, crossings_, corners, RunContext(), 1);
    return assembly_.mesh.triangles;
  }

 private:
  Assembly assembly_;
  contour::DualSurface dual_;
  std::vector<contour::Crossing> crossings_;
};

TEST_F(Diagonals, RunAlongARoundEdge) {
  EXPECT_EQ(chosenFor({{-1, -1, 0}, {1, -1, -1}, {1, 1, 0}, {-1, 1, -1}}),
            (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(chosenFor({{-1, -1, -1}, {1, -1, 0}, {1, 1, -1}, {-1, 1, 0}}),
            (std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}));
}

TEST_F(Diagonals, DoNotFoldAQuadThatIsNotConvex) {
  EXPECT_EQ(chosenFor({{-1, -1, 0}, {-0.5, 0.5, -1}, {1, 1, 0}, {-1, 1, -1}}),
            (std::vector<Triangle>{{1, 2, 3}, {1, 3, 0}}));
}

// A rim of four edges, 0 to 4; before it the contour's vertices 5, 6 and 7, with wall before 5 and 6, shell
// before 6 and 7.
TEST(StripRegion, IsWhatTheContourGoesOnAs) {
  Assembly assembly;
  assembly.mesh.positions.resize(10);
  assembly.mesh.triangles = {{5, 6, 8}, {6, 7, 9}, {0, 1, 5}, {1, 6, 5},
                             {1, 2, 6}, {2, 3, 6}, {3, 7, 6}, {3, 4, 7}};
  constexpr std::uint32_t kStrip = Assembly::kStrip;
  assembly.crossing = {0, 1, kStrip, kStrip, kStrip, kStrip, kStrip, kStrip};
  assembly.region.assign(8, Region::kShell);
  assembly.region[0] = Region::kWall;
  reconstruct::labelStrip(assembly, 1);
  const std::vector<Region> wanted = {Region::kWall, Region::kShell, Region::kWall,  Region::kWall,
                                      Region::kWall, Region::kWall,  Region::kShell, Region::kShell};
  EXPECT_EQ(assembly.region, wanted);
}

// The limit makes the field drop its nodes, and triangles be searched for meetings in blocks.
TEST(ReconstructSlow, GivesTheSameBytesBelowATightLimit) {
  const TriangleMesh sheet = shapes::sheet(12, 9);
  const double r = 0.9, cell = 0.045;
  const Solid whole = thicken(sheet, by(r, cell, 2));
  ASSERT_GT(whole.mesh.triangles.size(), 100'000u);
  const std::size_t least =
      heldBytes(sheet) + leanBytes(mostShellCrossings(shellShadows(OwnJob(sheet, r).job), cell));
  for (const int threads : {1, 2}) {
    RunContext context;
    context.setMemoryLimit(least);
    const Solid lean = thicken(sheet, by(r, cell, threads), context);
    EXPECT_EQ(lean.mesh.triangles, whole.mesh.triangles) << threads;
    EXPECT_EQ(lean.mesh.positions, whole.mesh.positions) << threads;
    EXPECT_GT(whole.report.predictedMemory, least);
  }
  RunContext context;
  context.setMemoryLimit(least - 1);
  EXPECT_THROW((void)thicken(sheet, by(r, cell, 2), context), Error);
}

// Fins whose gaps are narrower than two thicknesses: they are full of material. A copy that is stuck at the
// bottom of a gap does not end halfway to the sheet that it is stuck at.
TEST(Deepen, FillsGapsBetweenFinsOfOneTriangle) {
  constexpr double kGap = 1.3, kFin = 0.3, kHeight = 3, kWidth = 4;
  std::vector<Vec3> profile{{0, 0, 0}, {1, 0, 0}};
  for (double x = 1; profile.size() < 20; x += kFin + kGap)
    for (const Vec3& p :
         {Vec3(x, 0, kHeight), Vec3(x + kFin, 0, kHeight), Vec3(x + kFin, 0, 0), Vec3(x + kFin + kGap, 0, 0)})
      profile.push_back(p);
  profile.back().x() += 1;
  TriangleMesh fins;
  for (const Vec3& p : profile) {
    fins.positions.push_back(p);
    fins.positions.push_back(p + Vec3(0, kWidth, 0));
  }
  for (VertexId i = 0; i + 3 < fins.positions.size(); i += 2) {
    fins.triangles.push_back({i, i + 2, i + 3});
    fins.triangles.push_back({i, i + 3, i + 1});
  }
  Options options;
  options.thickness = 1;
  options.side = Side::kPositive;
  options.join = Join::kRound;
  const double filled = thicken(fins, options).report.volume;
  options.method = Method::kReconstruct;
  EXPECT_NEAR(filled, thicken(fins, options).report.volume, 0.01 * filled);
}

TEST(WorkingSet, FollowsFromTheLimit) {
  constexpr std::size_t kCrossings = 1'000'000, kHeld = std::size_t{50} << 20;
  RunContext context;
  EXPECT_FALSE(workingSetFor(kCrossings, kHeld, context).isLean);
  context.setMemoryLimit(kHeld + wholeBytes(kCrossings));
  EXPECT_FALSE(workingSetFor(kCrossings, kHeld, context).isLean);
  context.setMemoryLimit(kHeld + wholeBytes(kCrossings) - 1);
  const WorkingSet much = workingSetFor(kCrossings, kHeld, context);
  context.setMemoryLimit(kHeld + leanBytes(kCrossings));
  const WorkingSet little = workingSetFor(kCrossings, kHeld, context);
  EXPECT_TRUE(much.isLean && little.isLean);
  EXPECT_LT(little.nodes, much.nodes);
  EXPECT_LT(little.triangles, much.triangles);
}

TEST(MostShellCrossings, AreALittleMoreThanTheContourMakes) {
  const TriangleMesh sheet = shapes::sheet(12, 9);
  const Solid solid = thicken(sheet, by(0.9, 0.1));
  const double made = double(solid.report.shellTriangles) / 2;
  const auto expected = double(mostShellCrossings(shellShadows(OwnJob(sheet, 0.9).job), 0.1));
  EXPECT_GT(expected, made);
  EXPECT_LT(expected, 1.25 * made);
}

TEST(WidthWithRoom, IsWiderWhereTheLimitAsksForIt) {
  OwnJob own(valleys(), 0.25);
  const double width = 0.05, shadows = shellShadows(own.job);
  const std::size_t crossings = mostShellCrossings(shadows, width);
  const std::size_t fits = heldBytes(own.surface) + leanBytes(crossings);
  EXPECT_EQ(widthWithRoom(own.job, crossings, width), width);
  own.context.setMemoryLimit(fits);
  EXPECT_EQ(widthWithRoom(own.job, crossings, width), width);
  own.context.setMemoryLimit(fits - leanBytes(crossings) / 20);
  const double wider = widthWithRoom(own.job, crossings, width);
  EXPECT_GT(wider, width);
  EXPECT_TRUE(reconstruct::hasRoomForField(own.job, mostShellCrossings(shadows, wider)));
  own.options.cell = width;
  EXPECT_EQ(widthWithRoom(own.job, crossings, width), width) << "asked for by name";
}

// Pleats of a height of 3: sheets come together at an angle that no cell can tell apart near the fold.
TriangleMesh pleats(VertexId columns, VertexId rows, double length, double slope) {
  return shapes::parametric(columns, rows, [=](double u, double v) {
    const double x = length * u;
    return Vec3(slope * x, 3 * v, 3 * std::abs(x - 2 * std::round(x / 2)));
  });
}

TEST(ReconstructSlow, TakesFinerCellsOnlyWhereSheetsAreTooClose) {
  Options o;
  o.thickness = 1;
  o.method = Method::kReconstruct;
  o.simplify = Simplify::kOff;
  const TriangleMesh sharp = pleats(24, 6, 6, 0.4);
  const Solid solid = thicken(sharp, o);
  EXPECT_LT(solid.report.finestCell, 0.6 * solid.report.cell);
  o.cell = solid.report.finestCell;
  const Solid fine = thicken(sharp, o);
  EXPECT_LT(solid.report.triangles, fine.report.triangles / 2);
  EXPECT_NEAR(solid.report.volume, fine.report.volume, 0.002 * fine.report.volume);
}

TEST(ReconstructSlow, KeepsATightToleranceByFinerCellsAtCreases) {
  const TriangleMesh blunt = pleats(12, 4, 4, 1);
  Options o;
  o.thickness = 0.3;
  o.method = Method::kReconstruct;
  const Solid loose = thicken(blunt, o);
  EXPECT_EQ(loose.report.finestCell, loose.report.cell);
  o.tolerance = 0.03 * o.thickness;
  EXPECT_GT(loose.report.shellError.max * o.thickness, *o.tolerance) << "nothing is to be done";
  const Solid tight = thicken(blunt, o);
  EXPECT_LE(tight.report.shellErrorBound, *o.tolerance);
  EXPECT_LT(tight.report.finestCell, 0.6 * tight.report.cell);
  EXPECT_LT(tight.report.triangles, 1.2 * static_cast<double>(loose.report.triangles));
}

TEST(ReconstructSlow, KeepsATightToleranceWhereWallsMeetCreases) {
  // Waves end at the rim, and so do the creases of their offset.
  for (const auto& [height, waves, r] : {std::tuple{0.5, 3, 0.25}, {0.3, 4, 0.15}, {0.5, 4, 0.1}}) {
    Options o;
    o.thickness = r;
    o.tolerance = 0.05 * r;
    EXPECT_LE(thicken(shapes::corrugation(static_cast<VertexId>(16 * waves), height, waves), o)
                  .report.shellErrorBound,
              *o.tolerance)
        << height << " " << waves;
  }
}

TriangleMesh row(VertexId count) {
  return shapes::parametric(count, 1, [=](double u, double v) { return Vec3(count * u, v, 0); });
}

TEST(CutAround, TakesRingsOfWhatIsOpenable) {
  const TriangleMesh mesh = row(10);
  std::vector<std::uint8_t> keep(mesh.triangles.size(), 1), openable(keep);
  openable[11] = 0;
  const std::vector<TriangleId> cut{8, 9};
  reconstruct::cutAround(mesh, cut, openable, 2, keep);
  for (std::size_t t = 0; t < keep.size(); ++t) EXPECT_EQ(keep[t] == 0, t >= 4 && t < 14 && t != 11) << t;
}

// A swept strip, long along x, with a hole in its shell near either end.
struct TwoHoles {
  static constexpr double kThickness = 0.2, kWidth = 0.05;
  OwnJob own{shapes::parametric(60, 6, [](double u, double v) { return Vec3(20 * u, 2 * v, 0); }),
             kThickness};
  const TriangleMesh& surface = own.surface;
  reconstruct::Holes holes;

  TwoHoles() {
    holes.carried = sweep::sweep(own.job);
    sweep::SweepResult& swept = holes.carried;
    swept.up.resize(swept.mesh.positions.size(), Vec3::Zero());
    holes.left.assign(swept.region.size(), 0);
    for (std::size_t t = 0; t < swept.region.size(); ++t) {
      const Triangle& corners = swept.mesh.triangles[t];
      const bool isShell = swept.region[t] == Region::kShell;
      const bool isIn = std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
        const Vec3& p = swept.mesh.positions[v];
        return std::abs(std::abs(p.x() - 10) - 7) < 0.9 && std::abs(p.y() - 1) < 0.5;
      });
      holes.openable.push_back(isShell);
      holes.keep.push_back(!(isShell && isIn));
    }
  }

  // What a contour would have made, were it the window as it was.
  static Reconstruction unchanged(const Window& window) {
    Reconstruction made;
    made.mesh = window.part.carried.mesh;
    made.region = window.part.carried.region;
    made.openable = window.part.openable;
    made.origin.resize(made.mesh.positions.size());
    std::iota(made.origin.begin(), made.origin.end(), VertexId{0});
    return made;
  }
};

TEST(Windows, ShowWhatIsNearOneHole) {
  const TwoHoles of;
  const auto windows = windowsOf(of.own.job, of.holes, of.kWidth);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_FALSE(windows[0].zone.overlaps(windows[1].zone));
  const TriangleMesh& boundary = of.holes.carried.mesh;
  for (const Window& window : windows) {
    EXPECT_LT(window.source.size(), boundary.triangles.size() / 2);
    EXPECT_LT(window.surface.triangles.size(), of.surface.triangles.size() / 2);
    EXPECT_TRUE(std::equal(window.surface.triangles.begin(), window.surface.triangles.end(),
                           window.part.carried.mesh.triangles.begin()));
    std::size_t open = 0;
    for (std::size_t t = 0; t < window.part.keep.size(); ++t) {
      open += window.part.keep[t] == 0;
      const bool atEdge = std::any_of(window.part.carried.mesh.triangles[t].begin(),
                                      window.part.carried.mesh.triangles[t].end(),
                                      [&](VertexId v) { return window.fixed[v] != 0; });
      EXPECT_FALSE(atEdge && (window.part.openable[t] || !window.part.keep[t])) << t;
    }
    EXPECT_GT(open, 0u);
    EXPECT_FALSE(window.cut.edges.empty());
    // The rest of the rim is the hole's.
    std::vector<Triangle> kept;
    for (std::size_t t = 0; t < window.part.keep.size(); ++t)
      if (window.part.keep[t]) kept.push_back(window.part.carried.mesh.triangles[t]);
    for (const mesh::RimEdge& e : rimOf(window.vertex.size(), kept).edges)
      EXPECT_EQ(std::binary_search(window.cut.edges.begin(), window.cut.edges.end(),
                                   reconstruct::Cut::Edge{e.from, e.to}),
                !window.cut.zone.contains(window.part.carried.mesh.positions[e.from]));
  }
}

// What a window holds is the same where the surface goes on far away from it.
TEST(Windows, DependOnWhatIsInReachAlone) {
  TwoHoles near, far;
  for (std::size_t t = 0; t < near.holes.keep.size(); ++t)
    if (near.holes.carried.mesh.positions[near.holes.carried.mesh.triangles[t][0]].x() > 10)
      near.holes.keep[t] = 1;
  const auto one = windowsOf(near.own.job, near.holes, near.kWidth);
  const auto both = windowsOf(far.own.job, far.holes, far.kWidth);
  ASSERT_EQ(one.size(), 1u);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(one[0].surface.positions, both[0].surface.positions);
  EXPECT_EQ(one[0].surface.triangles, both[0].surface.triangles);
  EXPECT_EQ(one[0].part.carried.mesh.triangles, both[0].part.carried.mesh.triangles);
  EXPECT_EQ(one[0].cut.edges, both[0].cut.edges);
}

TEST(Windows, ArePutTogetherToTheWhole) {
  const TwoHoles of;
  const auto windows = windowsOf(of.own.job, of.holes, of.kWidth);
  ASSERT_EQ(windows.size(), 2u);
  const TriangleMesh& boundary = of.holes.carried.mesh;
  std::vector<std::optional<Reconstruction>> made{TwoHoles::unchanged(windows[0]), std::nullopt};
  EXPECT_TRUE(staysWithin(windows[0], *made[0]));
  Reconstruction whole = withWindows(of.surface, of.holes, windows, made);
  EXPECT_EQ(whole.mesh.triangles.size(), boundary.triangles.size());

  // A triangle of a hole is divided in the middle.
  Reconstruction& divided = *made[0];
  const auto open = std::find(windows[0].part.keep.begin(), windows[0].part.keep.end(), 0);
  const auto t = static_cast<std::size_t>(open - windows[0].part.keep.begin());
  const Triangle old = divided.mesh.triangles[t];
  const auto middle = static_cast<VertexId>(divided.mesh.positions.size());
  divided.mesh.positions.push_back(
      (divided.mesh.positions[old[0]] + divided.mesh.positions[old[1]] + divided.mesh.positions[old[2]]) / 3);
  divided.origin.push_back(mesh::kNone);
  divided.mesh.triangles[t] = {old[0], old[1], middle};
  for (const Triangle& more : {Triangle{old[1], old[2], middle}, {old[2], old[0], middle}}) {
    divided.mesh.triangles.push_back(more);
    divided.region.push_back(Region::kShell);
    divided.openable.push_back(1);
  }
  made[1] = TwoHoles::unchanged(windows[1]);
  whole = withWindows(of.surface, of.holes, windows, made);
  EXPECT_EQ(whole.mesh.triangles.size(), boundary.triangles.size() + 2);
  EXPECT_EQ(whole.mesh.positions.size(), boundary.positions.size() + 1);
  EXPECT_TRUE(rimOf(whole.mesh.positions.size(), whole.mesh.triangles).edges.empty());

  // Twice the same is once too often.
  const std::vector<Window> twice{windows[0], windows[0]};
  made[1] = made[0];
  EXPECT_EQ(withWindows(of.surface, of.holes, twice, made).mesh.triangles.size(),
            boundary.triangles.size() + 2);
  EXPECT_FALSE(made[1]);
  // Beyond its zone nothing may change.
  divided.mesh.positions[middle].x() += 20;
  EXPECT_FALSE(staysWithin(windows[0], divided));
}

// A slab with a cavity, and beside it a part that is inside out and one that has nothing of S: only what
// bounds something stays.
TEST(Windows, LeaveNothingInsideOut) {
  const TriangleMesh sheet = flat(6, 6);
  Reconstruction made;
  made.mesh = shapes::slab(sheet, 3);
  const std::size_t own = made.mesh.positions.size(), ofSlab = made.mesh.triangles.size();
  const auto add = [&](const TriangleMesh& part) {
    const auto first = static_cast<VertexId>(made.mesh.positions.size());
    made.mesh.positions.insert(made.mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const Triangle& t : part.triangles)
      made.mesh.triangles.push_back({first + t[0], first + t[2], first + t[1]});
  };
  add(shapes::box({8, 1, -2}, {9, 2, -1}));
  TriangleMesh crumb = shapes::box({8, 4, -2}, {9, 5, -1});
  for (Triangle& t : crumb.triangles) std::swap(t[1], t[2]);
  add(crumb);
  add(shapes::box({2, 2, -2}, {3, 3, -1}));
  made.region.assign(made.mesh.triangles.size(), Region::kShell);
  std::fill_n(made.region.begin(), sheet.triangles.size(), Region::kOriginal);
  made.openable.assign(made.region.size(), 1);

  reconstruct::dropMisplaced(made, sheet.positions.size(), 1);
  EXPECT_EQ(made.mesh.triangles.size(), ofSlab + 12);
  EXPECT_EQ(made.region.size(), ofSlab + 12);
  EXPECT_EQ(made.openable.size(), ofSlab + 12);
  EXPECT_EQ(made.mesh.positions.size(), own + 8);
  for (const Vec3& p : made.mesh.positions) EXPECT_LE(p.x(), 6);
}

TEST(Reconstruct, NamesTheWidthThatFitsTheMemory) {
  RunContext context;
  context.setMemoryLimit(std::size_t{64} << 20);
  try {
    (void)thicken(flat(10, 6), by(1, 0.01), context);
    FAIL() << "the limit was not obeyed";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kMemoryLimit);
    EXPECT_NE(std::string(e.what()).find("a cell width of"), std::string::npos) << e.what();
  }
}

TEST(Reconstruct, RefusesCellsOfHalfTheThickness) {
  Options o;
  o.method = Method::kReconstruct;
  o.thickness = 0.1;
  o.resolution = 32;
  try {
    (void)thicken(flat(10, 6), o);
    FAIL() << "Remark 1 was not kept";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kInvalidArgument);
  }
}

TEST(CellWidth, FollowsTheResolution) {
  Options o;
  o.thickness = 1;
  o.resolution = 60;
  EXPECT_DOUBLE_EQ(reconstruct::cellWidth(OwnJob(flat(10, 6), o).job, 60), 12.0 / 60);
}

}  // namespace
}  // namespace thicken
