// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/thicken.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <set>

#include "analytic_surfaces.h"
#include "check/audit.h"
#include "measure/measure.h"
#include "mesh/float_lattice.h"
#include "mesh/topology.h"
#include "plain_shapes.h"

namespace thicken {

using measure::areaOf;
using mesh::isFloat;
using mesh::roundToFloat;

namespace {

using namespace shapes;  // NOLINT: the surfaces of the tests

Options by(double thickness, Side side = Side::kNegative) {
  Options o;
  o.thickness = thickness;
  o.side = side;
  return o;
}

// Every triangle by its coordinates, starting at its least corner: what a reader of a file sees.
using Corners = std::array<std::array<double, 3>, 3>;
std::multiset<Corners> cornersOf(const TriangleMesh& mesh) {
  std::multiset<Corners> all;
  for (const Triangle& t : mesh.triangles) {
    Corners c;
    for (int k = 0; k < 3; ++k) std::copy_n(mesh.positions[t[k]].data(), 3, c[k].begin());
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    all.insert(c);
  }
  return all;
}

void expectPromise(const Solid& solid, const TriangleMesh& surface, Side side = Side::kNegative) {
  EXPECT_TRUE(solid.report.audit.passed());
  const checking::AuditResult again = checking::audit(solid.mesh, surface, side, RunContext(), 1);
  EXPECT_TRUE(again.facts.passed());
  ASSERT_EQ(solid.region.size(), solid.mesh.triangles.size());
  ASSERT_EQ(solid.depth.size(), weld(surface).positions.size());
  if (side == Side::kBoth) return;
  const auto have = cornersOf(solid.mesh),
             want = cornersOf(side == Side::kPositive ? reversed(surface) : surface);
  EXPECT_TRUE(std::includes(have.begin(), have.end(), want.begin(), want.end()));
  for (std::size_t v = weld(surface).positions.size(); v < solid.mesh.positions.size(); ++v)
    EXPECT_TRUE(isFloat(solid.mesh.positions[v]));
}

struct Known {
  const char* name;
  TriangleMesh surface;
  double r;
  double behind, before;  // volumes of the two sides
};

std::vector<Known> knownVolumes() {
  std::vector<Known> all;
  all.push_back({"plane", plane(20, 10), 0.7, 70, 70});
  {
    const double radius = 5, angle = 2, height = 4, r = 0.8;
    const double slice = angle * height / 2;
    all.push_back({"cylinder patch", cylinderPatch(120, radius, angle, height), r,
                   slice * (radius * radius - (radius - r) * (radius - r)),
                   slice * ((radius + r) * (radius + r) - radius * radius)});
  }
  {
    // The cap is what the icosphere's triangles cover; its solid angle is measured on them.
    const double radius = 4, r = 0.5;
    TriangleMesh cap = sphere(5, radius, [](const Vec3& p) { return p.z() > 1.3; });
    double solidAngle = 0;
    for (const auto& [i, j, k] : cap.triangles) {
      const Vec3 a = cap.positions[i].normalized(), b = cap.positions[j].normalized(),
                 c = cap.positions[k].normalized();
      solidAngle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
    }
    const auto ball = [&](double x) { return solidAngle / 3 * x * x * x; };
    all.push_back(
        {"sphere cap", weld(cap), r, ball(radius) - ball(radius - r), ball(radius + r) - ball(radius)});
  }
  {
    // Steiner's formula without mean curvature: V = A·r + (r³/3)·∫K
    const double radius = 2, c = 1, turn = 1.5, r = 0.3;
    const auto area = [&](double u) {
      return (u * std::sqrt(u * u + c * c) + c * c * std::asinh(u / c)) / 2;
    };
    const double k = -turn * 2 * radius / std::sqrt(radius * radius + c * c);
    const double volume = turn * 2 * area(radius) * r + r * r * r / 3 * k;
    all.push_back({"helicoid", helicoid(90, radius, c, turn), r, volume, volume});
  }
  {
    // The turns of whole waves cancel: V = A·r on both sides, up to the least radius of curvature
    const double height = 0.1, r = 0.12;
    double length = 0;
    const int steps = 100000;
    for (int i = 0; i < steps; ++i)
      length += std::hypot(1, 2 * kPi * height * std::cos(2 * kPi * (i + 0.5) / steps)) / steps;
    all.push_back({"corrugation", corrugation(480, height, 3), r, 3 * length * r, 3 * length * r});
  }
  {
    // Behind the spiral lies its inner side; the turn of the tangent shortens the offset.
    const double inner = 1, gap = 0.5, turns = 3, r = 0.2;
    double length = 0;
    const int steps = 100000;
    for (int i = 0; i < steps; ++i)
      length +=
          std::hypot(inner + gap * turns * (i + 0.5) / steps, gap / (2 * kPi)) * 2 * kPi * turns / steps;
    const double slope = gap / (2 * kPi);
    const double turned = 2 * kPi * turns - std::atan2(slope, inner) * -1 -
                          std::atan2(slope, inner + gap * turns);  // of the tangent, from start to end
    all.push_back({"roll", roll(900, inner, gap, turns), r, length * r - turned * r * r / 2,
                   length * r + turned * r * r / 2});
  }
  {
    const double radius = 3, r = 0.4;
    const auto ball = [](double x) { return 4 * kPi / 3 * x * x * x; };
    all.push_back({"closed sphere", sphere(5, radius), r, ball(radius) - ball(radius - r),
                   ball(radius + r) - ball(radius)});
  }
  return all;
}

TEST(ThickenSlow, GivesTheKnownVolumeOnBothSides) {
  for (const Known& k : knownVolumes()) {
    SCOPED_TRACE(k.name);
    const Solid behind = thicken(k.surface, by(k.r));
    expectPromise(behind, k.surface);
    EXPECT_NEAR(behind.report.volume / k.behind, 1, 0.004);
    const Solid before = thicken(k.surface, by(k.r, Side::kPositive));
    expectPromise(before, k.surface, Side::kPositive);
    EXPECT_NEAR(before.report.volume / k.before, 1, 0.004);
    const Solid both = thicken(k.surface, by(k.r, Side::kBoth));
    expectPromise(both, k.surface, Side::kBoth);
    EXPECT_NEAR(both.report.volume / (k.behind + k.before), 1, 0.004);
  }
}

TEST(Thicken, CountsRegionsAndKeepsTheOrderOfS) {
  const TriangleMesh s = weld(plane(10, 10));
  Options options = by(1);
  options.simplify = Simplify::kOff;
  const Solid solid = thicken(s, options);
  EXPECT_EQ(solid.report.originalTriangles, s.triangles.size());
  EXPECT_EQ(solid.report.shellTriangles, s.triangles.size());
  EXPECT_EQ(solid.report.wallTriangles, 2u * 40u);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    EXPECT_EQ(solid.mesh.triangles[t], s.triangles[t]);
    EXPECT_EQ(solid.region[t], Region::kOriginal);
  }
  for (const double d : solid.depth) EXPECT_NEAR(d, 1, 1e-6);
  EXPECT_NEAR(solid.report.thinnestWall, 1, 1e-6);
  EXPECT_EQ(solid.report.thinShare, 0);
  EXPECT_LT(solid.report.shellError.max, 1e-6);
  EXPECT_TRUE(solid.report.warnings.empty());
}

TEST(Thicken, WarnsWhereTheSolidIsThinnerThanAsked) {
  // a gutter of radius 0.5, filled from inside: nothing deeper than its axis
  const TriangleMesh s = cylinderPatch(60, 0.5, kPi, 4);
  const Solid solid = thicken(s, by(2));
  expectPromise(solid, s);
  ASSERT_FALSE(solid.report.warnings.empty());
  EXPECT_LT(solid.report.thinnestWall, 0.6);
  EXPECT_GT(solid.report.thinShare, 0.5);
  // The rim is nearest to all that is not S: thin as it is, it is the solid that is defined.
  Options o = by(2);
  o.tolerance = 0.1;
  EXPECT_LE(thicken(s, o).report.shellErrorBound, 0.1);
}

TEST(Thicken, KeepsSheetsApartThatFaceEachOther) {
  // two parallel sheets closer than 2 r: backs together, then fronts together
  for (const bool backs : {true, false}) {
    TriangleMesh low = plane(12, 6), high = reversed(plane(12, 6));
    for (Vec3& p : high.positions) p.z() += 0.5;
    TriangleMesh s = together(low, high);
    if (backs) s = reversed(s);
    const Solid solid = thicken(s, by(2));
    expectPromise(solid, s);
    // A back facing a back: what is between is all there is. Fronts: the full thickness outside.
    if (backs) {
      EXPECT_LT(solid.report.volume, 36 * 0.5);
    } else {
      EXPECT_NEAR(solid.report.volume, 2 * 36 * 2, 1e-3);
    }
  }
}

// Two large triangles at a sharp fold, a thousandth of their edges thick: cells below half the thickness
// would be tens of millions, and their rims fans of thousands of slivers.
TEST(Thicken, LeavesLargeTrianglesAtASharpFoldToTheSweep) {
  TriangleMesh fold;
  fold.positions = {{0, 0, 0}, {10, 0, 0}, {5, 9, 0.5}, {5, 9, -0.5}};
  fold.triangles = {{0, 1, 2}, {1, 0, 3}};
  const Solid solid = thicken(fold, by(0.01));
  EXPECT_TRUE(solid.report.audit.passed());
  EXPECT_EQ(solid.report.method, Method::kSweep);
  EXPECT_LT(solid.report.triangles, 100u);
}

// Below a sharp ridge a mitre cut short would tilt the triangles on both sides of it, all the way down.
TEST(Thicken, KeepsTheThicknessBesideASharpRidge) {
  const double slope = 2.8, r = 0.02;
  const TriangleMesh roof =
      parametric(8, 8, [=](double u, double v) { return Vec3(4 * v, 4 * u, -slope * std::abs(4 * u - 2)); });
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    Options o = by(r, side);
    o.method = Method::kSweep;
    const Solid solid = thicken(roof, o);
    expectPromise(solid, roof, side);
    // The edge of a wall beside the ridge has the mitre inside of S, or lacks it outside.
    EXPECT_NEAR(solid.report.volume, r * areaOf(roof), 0.02 * r * areaOf(roof));
  }
}

TEST(Thicken, PassesOverFoldsThatLieFlat) {
  const std::vector<std::array<double, 2>> profile = {{0, 0},        {1, 0.01},    {2, 0},
                                                      {1.9, -0.001}, {3, -0.0005}, {4, 0}};
  const auto columns = static_cast<VertexId>(profile.size() - 1);
  const TriangleMesh s = parametric(columns, 6, [&](double u, double v) {
    const auto& [x, z] = profile[static_cast<std::size_t>(std::lround(u * columns))];
    return Vec3(x, 4 * v, z);
  });
  ASSERT_TRUE(check(s).valid());
  for (const Side side : {Side::kNegative, Side::kPositive}) {
    const Solid solid = thicken(s, by(0.3, side));
    expectPromise(solid, s, side);
    EXPECT_GT(solid.report.volume, 0.4 * 16 * 0.3) << "the fold must not eat up the thickness around it";
  }
}

// An ear of the rim that is folded below the sheet: the wall of the sheet's rim would cut the ear.
TEST(Thicken, PassesAroundEarsFoldedBelowTheRim) {
  for (const double drop : {-0.02, 0.02}) {
    TriangleMesh s = plane(6, 6);
    const VertexId from = 2, to = 3;  // an edge of the rim y = 0
    s.positions.emplace_back(2.5, 0.6, drop);
    s.triangles.push_back({to, from, static_cast<VertexId>(s.positions.size() - 1)});
    ASSERT_TRUE(check(s).valid());
    for (const Side side : {Side::kNegative, Side::kPositive}) {
      const Solid solid = thicken(s, by(0.5, side));
      expectPromise(solid, s, side);
      EXPECT_GT(solid.report.volume, 0.8 * 36 * 0.5);
    }
  }
}

TEST(Thicken, HollowsNestedClosedSurfaces) {
  // a ball with a ball-shaped cavity: both surfaces get a skin within the material
  const TriangleMesh s = together(sphere(4, 5), reversed(sphere(4, 2)));
  const Solid solid = thicken(s, by(0.5));
  expectPromise(solid, s);
  const auto ball = [](double x) { return 4 * kPi / 3 * x * x * x; };
  EXPECT_NEAR(solid.report.volume / (ball(5) - ball(4.5) + ball(2.5) - ball(2)), 1, 0.01);
  EXPECT_EQ(solid.report.components, 4u);
}

TEST(Thicken, GivesTheSameBytesForAnyNumberOfThreads) {
  std::mt19937 random(11);
  const TriangleMesh s = heightField(40, random, 0.2, 0.5);
  Options o = by(0.1);
  o.threads = 1;
  const Solid one = thicken(s, o);
  expectPromise(one, s);
  for (const int threads : {2, 3, 4}) {
    o.threads = threads;
    const Solid many = thicken(s, o);
    EXPECT_EQ(many.mesh.triangles, one.mesh.triangles);
    EXPECT_EQ(many.mesh.positions, one.mesh.positions);
    EXPECT_EQ(many.region, one.region);
    EXPECT_EQ(many.depth, one.depth);
  }
}

TEST(Thicken, KeepsDoublesOrRoundsThemAsAsked) {
  TriangleMesh s = plane(4, 1);
  for (Vec3& p : s.positions) p += Vec3(0.1, 1.0 / 3, 1e-9);
  const Solid kept = thicken(s, by(0.2));
  expectPromise(kept, s);
  EXPECT_EQ(kept.mesh.positions[0], s.positions[0]);
  Options o = by(0.2);
  o.precision = Precision::kSingle;
  const Solid rounded = thicken(s, o);
  EXPECT_EQ(rounded.mesh.positions[0], roundToFloat(s.positions[0]));
  for (const Vec3& p : rounded.mesh.positions) EXPECT_TRUE(isFloat(p));
}

// --- properties over generated surfaces ---

struct Moved {
  const char* name;
  double scale;
  bool rotate;
};

class ThickenProperty : public ::testing::TestWithParam<int> {};

TEST_P(ThickenProperty, PromiseHoldsAndFollowsMotionAndScale) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  std::uniform_real_distribution<double> unit(0, 1);
  // As noisy as it can be without meeting itself: many vertices have no even direction.
  TriangleMesh s;
  for (double noise = 1.6; s.triangles.empty() || !check(s).valid(); noise *= 0.8)
    s = heightField(14, random, 0.25, noise);
  const double r = 0.02 + 0.2 * unit(random);
  double reference = 0;
  for (const Moved& move : {Moved{"as is", 1, false}, Moved{"turned", 1, true}, Moved{"tiny", 1e-3, true},
                            Moved{"huge", 1e3, false}}) {
    SCOPED_TRACE(move.name);
    TriangleMesh m = s;
    const Eigen::Quaterniond q =
        move.rotate ? Eigen::Quaterniond(unit(random), unit(random), -unit(random), unit(random)).normalized()
                    : Eigen::Quaterniond::Identity();
    for (Vec3& p : m.positions) p = roundToFloat(move.scale * (q * p));
    if (!check(m).valid()) continue;
    for (const Side side : {Side::kNegative, Side::kPositive}) {
      const Solid solid = thicken(m, by(r * move.scale, side));
      expectPromise(solid, m, side);
      if (side == Side::kPositive) continue;
      const double volume = solid.report.volume / std::pow(move.scale, 3);
      if (reference == 0) reference = volume;
      EXPECT_NEAR(volume / reference, 1, 0.05);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Seeds, ThickenProperty, ::testing::Range(0, 12));

// --- refusals ---

ErrorCode codeOf(const TriangleMesh& s, const Options& o, RunContext context = {}) {
  try {
    (void)thicken(s, o, context);
  } catch (const Error& e) {
    EXPECT_FALSE(std::string(e.what()).empty());
    return e.code();
  }
  ADD_FAILURE() << "was not refused";
  return ErrorCode::kInternal;
}

TEST(ThickenRefuses, OptionsOutOfRange) {
  const TriangleMesh s = plane(3, 1);
  for (const double r : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(codeOf(s, by(r)), ErrorCode::kInvalidArgument);
  Options o = by(1);
  o.cell = 0.5;
  EXPECT_EQ(codeOf(s, o), ErrorCode::kInvalidArgument) << "Remark 1: w < r/2";
  o = by(1);
  o.tolerance = 0.1;
  o.resolution = 64;
  EXPECT_EQ(codeOf(s, o), ErrorCode::kInvalidArgument);
  o = by(1);
  o.threads = -1;
  EXPECT_EQ(codeOf(s, o), ErrorCode::kInvalidArgument);
}

TEST(ThickenRefuses, InvalidSurfacesWithTheirDefects) {
  EXPECT_EQ(codeOf({}, by(1)), ErrorCode::kEmpty);
  EXPECT_EQ(codeOf(moebius(20), by(0.05)), ErrorCode::kNotOriented);
  TriangleMesh crossing = together(plane(2, 1), plane(2, 1));
  for (std::size_t v = 9; v < 18; ++v)
    crossing.positions[v] = Vec3(crossing.positions[v].x(), 0.4, crossing.positions[v].y() - 0.5);
  EXPECT_EQ(codeOf(crossing, by(0.1)), ErrorCode::kSelfIntersecting);
  TriangleMesh broken = plane(2, 1);
  broken.positions[4].x() = std::nan("");
  EXPECT_EQ(codeOf(broken, by(0.1)), ErrorCode::kNotFinite);
}

TEST(ThickenRefuses, WhatSinglePrecisionCannotHold) {
  TriangleMesh far = plane(3, 1);
  for (Vec3& p : far.positions) p += Vec3(4e6, 0, 0);
  EXPECT_EQ(codeOf(far, by(0.1)), ErrorCode::kNoSolid);
  TriangleMesh huge = plane(3, 3e38);
  EXPECT_EQ(codeOf(huge, by(1e38)), ErrorCode::kNotFinite);
}

TEST(ThickenRefuses, MoreMemoryThanTheLimit) {
  RunContext context;
  context.setMemoryLimit(1 << 20);
  EXPECT_EQ(codeOf(plane(100, 1), by(0.1), context), ErrorCode::kMemoryLimit);
}

TEST(ThickenRefuses, ToGoOnOnceCancelled) {
  RunContext context;
  context.cancel();
  EXPECT_EQ(codeOf(plane(50, 1), by(0.1), context), ErrorCode::kCancelled);
}

}  // namespace
}  // namespace thicken
