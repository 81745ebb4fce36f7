// SPDX-License-Identifier: LGPL-2.1-or-later
#include "job/rim_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "analytic_surfaces.h"
#include "job/thickness.h"
#include "plain_shapes.h"
#include "refusals.h"
#include "thicken/error.h"
#include "thicken/thicken.h"

namespace thicken {

using job::distancesToRim;

namespace {

constexpr double kR = 2;

struct Profile {
  std::optional<double> thickness, width, round;
};

Options options(const Profile& profile, Side side = Side::kNegative) {
  Options o;
  o.thickness = kR;
  o.side = side;
  o.threads = 2;
  o.rimThickness = profile.thickness;
  o.rimWidth = profile.width;
  o.rimRound = profile.round;
  return o;
}

// A square of 10 mm in triangles of 0.5.
TriangleMesh plane() {
  return shapes::plane(20, 10);
}
double toRimOfPlane(const Vec3& p) {
  return std::max(0.0, std::min({p.x(), p.y(), 10 - p.x(), 10 - p.y()}));
}

// What the thickness is to be `d` from the rim, written another way than the library has it.
double asked(double r, double d, const Profile& profile) {
  if (profile.thickness) r += (*profile.thickness - r) * std::max(0.0, 1 - d / *profile.width);
  if (profile.round && d < *profile.round) {
    const double angle = std::acos(1 - d / *profile.round);  // around the middle of the circle, from the wall
    r -= *profile.round * (1 - std::sin(angle));
  }
  return r;
}

bool warnsOf(const Solid& solid, const std::string& words) {
  return std::ranges::any_of(solid.report.warnings,
                             [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

TEST(RimDistance, IsThatToTheNearestEdgeOfTheRim) {
  // Three quarters of a ring with a hole; straight edges cut its arcs off by less than 0.01 mm.
  const double angle = 1.5 * shapes::kPi;
  const TriangleMesh ring = shapes::parametric(60, 12, [&](double u, double v) {
    const double radius = 5 + 4 * v;
    return Vec3(radius * std::cos(angle * u), radius * std::sin(angle * u), 0);
  });
  const std::vector<double> distance = distancesToRim(ring, 100, 1);
  for (VertexId v = 0; v < distance.size(); ++v) {
    const Vec3& p = ring.positions[v];
    double ends = 100;
    if (p.x() > 0) ends = std::min(ends, std::abs(p.y()));
    if (p.y() < 0) ends = std::min(ends, std::abs(p.x()));
    EXPECT_NEAR(distance[v], std::min({p.norm() - 5, 9 - p.norm(), ends}), 0.02) << p.transpose();
  }
  // Within a reach, the same, and nothing far beyond.
  const std::vector<double> near = distancesToRim(ring, 1, 1);
  for (VertexId v = 0; v < distance.size(); ++v) {
    if (distance[v] <= 1) {
      EXPECT_EQ(near[v], distance[v]);
    } else if (distance[v] > 2) {
      EXPECT_TRUE(std::isinf(near[v]));
    }
  }
}

TEST(RimDistance, IsAlongTheSurfaceAndNotToAnotherSheet) {
  const TriangleMesh sheets = shapes::together(shapes::plane(10, 10), [] {
    TriangleMesh small = shapes::plane(2, 2);
    for (Vec3& p : small.positions) p += Vec3(4, 4, 0.1);
    return small;
  }());
  EXPECT_NEAR(distancesToRim(sheets, 100, 1)[5 * 11 + 5], 5, 1e-12);
}

// In a plane Definition 2 has the shell right below every point of S, whatever the slope.
TEST(RimProfile, OfAPlaneIsWhatTheFormulasSay) {
  const TriangleMesh sheet = plane();
  for (const Profile& profile : {Profile{{}, {}, 1}, Profile{{}, {}, 1.9}, Profile{1, 2, {}},
                                 Profile{3, 1, {}}, Profile{1.5, 3, 1}, Profile{0.5, 0.25, {}}})
    for (const Side side : {Side::kNegative, Side::kPositive, Side::kBoth}) {
      const Solid solid = thicken(sheet, options(profile, side));
      double worst = 0, highest = 0;
      std::size_t count = 0;
      for (std::size_t t = 0; t < solid.region.size(); ++t)
        if (solid.region[t] == Region::kShell)
          for (const VertexId v : solid.mesh.triangles[t]) {
            const Vec3& p = solid.mesh.positions[v];
            const double d = toRimOfPlane(p);
            // between the corners of S the thickness is linear
            if (std::abs(d * 2 - std::round(d * 2)) > 1e-6) continue;
            worst = std::max(worst, std::abs(std::abs(p.z()) - asked(kR, d, profile)));
            if (d == 0) highest = std::max(highest, std::abs(p.z()));
            ++count;
          }
      EXPECT_GT(count, 500u);
      EXPECT_LT(worst, 2e-4) << name(side);
      EXPECT_NEAR(highest, profile.thickness.value_or(kR) - profile.round.value_or(0), 1e-6);
      EXPECT_EQ(solid.report.thinShare, 0);
      ASSERT_TRUE(solid.report.thicknessMap && solid.report.rim);
      EXPECT_EQ(solid.report.thicknessMap->lowered, 0u);
      EXPECT_EQ(solid.report.rim->thickness, profile.thickness);
      EXPECT_EQ(solid.report.rim->width, profile.width);
      EXPECT_EQ(solid.report.rim->round, profile.round);
      EXPECT_NEAR(*solid.report.rim->row, 0.5, 1e-12);
    }
}

// Below an edge of S that is convex the closest point jumps, and with it the thickness: by more where it is
// steep.
TEST(RimProfile, IsFollowedByEveryMethodOnACurvedSurface) {
  const TriangleMesh cap = shapes::sphere(3, 10, [](const Vec3& p) { return p.z() > 2; });
  for (const Method method : {Method::kAuto, Method::kSweep, Method::kReconstruct}) {
    Options o = options({1.4, 3, {}});
    o.method = method;
    const Solid solid = thicken(cap, o);
    EXPECT_LT(solid.report.shellError.p99, 0.02) << name(method);
    EXPECT_LT(solid.report.thinShare, 0.01) << name(method);
  }
}

TEST(RimProfile, ComesOnTopOfAMapAndIsNotLowered) {
  const TriangleMesh sheet = plane();
  Options o = options({1, 2, 0.5});
  for (const Vec3& p : sheet.positions) o.thicknessMap.push_back(1 + 0.05 * p.x());
  std::optional<ThicknessFacts> facts;
  std::optional<RimFacts> rim;
  const job::Thickness r = job::thicknessOf(sheet, o, o.thicknessMap, facts, rim);
  for (VertexId v = 0; v < sheet.positions.size(); ++v) {
    const Vec3& p = sheet.positions[v];
    EXPECT_NEAR(r.at(v), asked(kR * (1 + 0.05 * p.x()), toRimOfPlane(p), {1, 2, 0.5}), 1e-12);
  }
  EXPECT_NEAR(facts->steepest, 0.1, 1e-9);
  EXPECT_EQ(facts->lowered, 0u);
  // 1 mm at the rim but 0.5 of it rounded off; what is thicker is off the rim.
  EXPECT_NEAR(facts->least, 0.5, 1e-12);
}

TEST(RimProfile, IsThatOfTheGapSurfacesRim) {
  const TriangleMesh sheet = plane();
  Options o = options({1, 2, {}});
  o.gap = 1.5;
  const Solid solid = thicken(sheet, o);
  ASSERT_TRUE(solid.gapSurface && solid.report.rim);
  const Solid plain = thicken(sheet, options({1, 2, {}}));
  EXPECT_NEAR(solid.report.volume, plain.report.volume, 0.01 * plain.report.volume);
  for (const Vec3& p : solid.mesh.positions)
    if (toRimOfPlane(p) < 1e-6) {
      EXPECT_GE(p.z(), -2.5 - 1e-6) << "1 mm thick at the rim, from 1.5 on";
    }
}

TEST(RimProfile, IsProvedWithinATolerance) {
  // Where r changes as fast along S as here, the proof has to know which triangles closest points are on.
  Options o = options({{}, {}, 1});
  o.tolerance = 0.1;
  const Solid solid = thicken(shapes::plane(10, 5), o);
  ASSERT_TRUE(solid.report.shellErrorBound);
  EXPECT_LE(*solid.report.shellErrorBound, 0.1);
}

TEST(RimProfile, ThatTheTrianglesAreTooLargeForIsReported) {
  const TriangleMesh sheet = plane();  // its triangles are 0.5 mm wide
  const std::string coarse = "the profile of the rim is coarser than asked";
  EXPECT_FALSE(warnsOf(thicken(sheet, options({{}, {}, 1.2})), coarse));
  EXPECT_FALSE(warnsOf(thicken(sheet, options({1, 0.6, {}})), coarse));
  const Solid round = thicken(sheet, options({{}, {}, 0.8}));
  EXPECT_TRUE(warnsOf(round, coarse));
  EXPECT_TRUE(warnsOf(round, "0.5 mm from it"));
  EXPECT_TRUE(warnsOf(thicken(sheet, options({1, 0.4, {}})), coarse));
}

TEST(RimProfile, OfASurfaceWithoutARimIsNone) {
  const TriangleMesh ball = shapes::sphere(2, 10);
  const Solid solid = thicken(ball, options({{}, {}, 1})), plain = thicken(ball, options({}));
  EXPECT_EQ(solid.mesh.positions, plain.mesh.positions);
  EXPECT_EQ(solid.mesh.triangles, plain.mesh.triangles);
  EXPECT_TRUE(warnsOf(solid, "has no rim"));
  ASSERT_TRUE(solid.report.rim);
  EXPECT_FALSE(solid.report.rim->row);
}

TEST(RimProfile, IsRefusedWhereItMakesNoSense) {
  const TriangleMesh sheet = plane();
  for (const auto& [profile, words] :
       {std::pair{Profile{1, {}, {}}, "belong together"}, std::pair{Profile{{}, 1, {}}, "belong together"},
        std::pair{Profile{0, 1, {}}, "thickness of the rim"},
        std::pair{Profile{1, -1, {}}, "width of the rim"},
        std::pair{Profile{{}, {}, std::nan("")}, "radius of the rim"},
        std::pair{Profile{{}, {}, 2}, "less than the thickness there, 2 mm"},
        std::pair{Profile{1, 1, 1}, "less than the thickness there, 1 mm"}})
    EXPECT_NE(refusalOf(sheet, options(profile)).find(words), std::string::npos) << words;
  // A strip of one row of triangles has all corners on its rim.
  EXPECT_NE(refusalOf(shapes::cylinderPatch(4, 10, 1, 5), options({{}, {}, 1})).find("on its rim"),
            std::string::npos);
}

}  // namespace
}  // namespace thicken
