// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "plain_shapes.h"

namespace thicken {
namespace {

using shapes::sheet;

std::vector<ErrorCode> codes(const CheckResult& result) {
  std::vector<ErrorCode> list;
  for (const Defect& d : result.defects) list.push_back(d.code);
  return list;
}

// The one defect that is expected.
Defect onlyDefect(const TriangleMesh& mesh, ErrorCode code) {
  const CheckResult result = check(mesh);
  EXPECT_EQ(codes(result), std::vector<ErrorCode>{code});
  EXPECT_FALSE(result.valid());
  if (result.defects.empty()) return {};
  EXPECT_FALSE(result.defects[0].sentence.empty());
  return result.defects[0];
}

bool mentions(const Defect& d, const std::string& words) {
  return d.sentence.find(words) != std::string::npos;
}

TEST(Check, FindsNothingWrongWithASheet) {
  const CheckResult result = check(sheet(6, 4));
  EXPECT_TRUE(result.valid());
  EXPECT_EQ(result.facts.triangles, 48u);
  EXPECT_EQ(result.facts.vertices, 35u);
  EXPECT_EQ(result.facts.rims, 1u);
  EXPECT_EQ(result.facts.components, 1u);
  EXPECT_FALSE(result.facts.closed);
}

TEST(Check, MeasuresTheSurface) {
  const TriangleMesh mesh =
      shapes::together(shapes::box({0, 0, 0}, {1, 2, 3}), shapes::box({5, 0, 0}, {6, 1, 1}));
  const CheckResult result = check(mesh);
  EXPECT_TRUE(result.valid());
  EXPECT_TRUE(result.facts.closed);
  EXPECT_EQ(result.facts.rims, 0u);
  EXPECT_EQ(result.facts.components, 2u);
  EXPECT_NEAR(result.facts.area, 22 + 6, 1e-12);
  EXPECT_NEAR(result.facts.diagonal, std::sqrt(36 + 4 + 9), 1e-12);
  const double diagonals = 2 * (std::sqrt(5) + std::sqrt(10) + std::sqrt(13)) + 6 * std::sqrt(2);
  EXPECT_NEAR(result.facts.meanEdge, 2 * (4 * 6 + 4 * 3 + diagonals) / 72, 1e-12);
}

TEST(Check, CountsRims) {
  TriangleMesh mesh = sheet(5, 5);
  mesh.triangles.erase(mesh.triangles.begin() + 24, mesh.triangles.begin() + 26);  // the middle cell
  const CheckResult result = check(mesh);
  EXPECT_TRUE(result.valid());
  EXPECT_EQ(result.facts.rims, 2u);
}

TEST(Check, RefusesNothingAtAll) {
  onlyDefect({}, ErrorCode::kEmpty);
  onlyDefect({{{1, 2, 3}}, {}}, ErrorCode::kEmpty);
}

TEST(Check, NamesVerticesThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(), 1e39}) {
    TriangleMesh mesh = sheet(3, 3);
    mesh.positions[5][1] = bad;
    mesh.positions[9][2] = bad;
    const Defect d = onlyDefect(mesh, ErrorCode::kNotFinite);
    EXPECT_EQ(d.vertices, (std::vector<VertexId>{5, 9}));
    EXPECT_EQ(d.count, 2u);
  }
  TriangleMesh unused = sheet(2, 2);
  unused.positions.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_TRUE(check(unused).valid());
}

TEST(Check, NamesEdgesOfThreeTriangles) {
  TriangleMesh mesh = sheet(2, 2);  // edge 1-4 is between the cells of the lower row
  mesh.positions.emplace_back(1, 0.5, 2);
  mesh.triangles.push_back({1, 4, 9});
  const Defect d = onlyDefect(mesh, ErrorCode::kNotManifold);
  ASSERT_EQ(d.edges.size(), 1u);
  EXPECT_EQ(d.edges[0], (std::array<VertexId, 2>{1, 4}));
  EXPECT_TRUE(d.vertices.empty());
  EXPECT_TRUE(mentions(d, "3 triangles (0, 8, 3)")) << d.sentence;
  EXPECT_NEAR((d.place - 0.5 * (mesh.positions[1] + mesh.positions[4])).norm(), 0, 1e-12);
}

TEST(Check, NamesVerticesOfTwoFans) {
  TriangleMesh mesh = sheet(2, 2);
  // remove the two cells on one diagonal: the others touch in the middle vertex
  mesh.triangles.erase(mesh.triangles.begin() + 6, mesh.triangles.end());
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 2);
  const Defect d = onlyDefect(mesh, ErrorCode::kNotManifold);
  EXPECT_EQ(d.vertices, std::vector<VertexId>{4});
  EXPECT_TRUE(d.edges.empty());
  EXPECT_EQ(d.count, 1u);
  EXPECT_EQ(d.place, mesh.positions[4]);
}

TEST(Check, NamesTheTrianglesToTurnOver) {
  TriangleMesh mesh = sheet(4, 4);
  for (const TriangleId t : {4u, 5u, 20u}) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  const Defect d = onlyDefect(mesh, ErrorCode::kNotOriented);
  EXPECT_EQ(d.triangles, (std::vector<TriangleId>{4, 5, 20}));
  EXPECT_TRUE(mentions(d, "turn over 3 triangles")) << d.sentence;
  EXPECT_EQ(d.count, d.edges.size());
  // where most are the wrong way round, the others are
  const Defect inverse = onlyDefect(shapes::reversed(mesh), ErrorCode::kNotOriented);
  EXPECT_EQ(inverse.triangles, d.triangles);
}

TEST(Check, TellsAOneSidedSurfaceFromOneToTurnOver) {
  const Defect d = onlyDefect(shapes::moebius(24), ErrorCode::kNotOriented);
  EXPECT_TRUE(mentions(d, "one-sided")) << d.sentence;
  EXPECT_TRUE(d.triangles.empty());
  EXPECT_FALSE(d.edges.empty());
}

TEST(Check, NamesTrianglesWithoutArea) {
  TriangleMesh mesh = sheet(3, 3);
  // a triangle with its corners on a line, and one with a corner twice
  const auto v = static_cast<VertexId>(mesh.positions.size());
  const Vec3 step(0.25, -0.5, 0.125);
  for (int k = 0; k < 3; ++k) mesh.positions.push_back(Vec3(9, 9, 9) + (k == 1 ? 3 : k) * step);
  mesh.triangles.push_back({v, v + 1, v + 2});
  mesh.triangles.push_back({0, 0, 1});
  const Defect d = onlyDefect(mesh, ErrorCode::kDegenerate);
  EXPECT_EQ(d.triangles, (std::vector<TriangleId>{18, 19}));
  EXPECT_EQ(d.count, 2u);
}

TEST(Check, NamesDuplicateTrianglesInEitherSense) {
  TriangleMesh mesh = sheet(3, 3);
  const Triangle t = mesh.triangles[7];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  mesh.triangles.push_back({t[1], t[0], t[2]});
  const Defect d = onlyDefect(mesh, ErrorCode::kDegenerate);
  EXPECT_EQ(d.triangles, (std::vector<TriangleId>{18, 19}));
  EXPECT_TRUE(mentions(d, "triangle 18")) << d.sentence;
  EXPECT_TRUE(mentions(d, "triangle 7")) << d.sentence;
}

TEST(Check, NamesPairsThatMeet) {
  TriangleMesh mesh = sheet(3, 3);
  const TriangleMesh spike{{{1.4, 1.5, -2}, {1.5, 1.4, -2}, {1.45, 1.5, 2}}, {{0, 1, 2}}};
  const Defect d = onlyDefect(shapes::together(mesh, spike), ErrorCode::kSelfIntersecting);
  ASSERT_GE(d.triangles.size(), 2u);
  EXPECT_EQ(d.triangles.size(), 2 * d.count);
  for (std::size_t i = 0; i < d.triangles.size(); i += 2) {
    EXPECT_LT(d.triangles[i], 18u);
    EXPECT_EQ(d.triangles[i + 1], 18u);
  }
  EXPECT_NEAR(d.place[0], 1.45, 0.1);
  EXPECT_NEAR(d.place[1], 1.45, 0.1);
}

TEST(Check, FindsATouchInASinglePoint) {
  const TriangleMesh touching{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}, {0, 0, 1}, {1, 0, 1}},
                              {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_EQ(onlyDefect(touching, ErrorCode::kSelfIntersecting).count, 1u);
}

TEST(Check, FindsEveryKindAtOnce) {
  TriangleMesh mesh = sheet(8, 8);
  std::swap(mesh.triangles[60][1], mesh.triangles[60][2]);  // not oriented
  mesh.triangles.push_back(mesh.triangles[100]);            // duplicate
  const auto v = static_cast<VertexId>(mesh.positions.size());
  mesh.positions.emplace_back(0.5, 0.5, 5);
  mesh.triangles.push_back({30, 31, v});  // a third triangle at an edge, and it cuts through others
  const TriangleMesh spike{{{5.4, 5.5, -2}, {5.5, 5.4, -2}, {5.45, 5.5, 2}}, {{0, 1, 2}}};
  mesh = shapes::together(mesh, spike);
  EXPECT_EQ(codes(check(mesh)),
            (std::vector<ErrorCode>{ErrorCode::kDegenerate, ErrorCode::kNotManifold, ErrorCode::kNotOriented,
                                    ErrorCode::kSelfIntersecting}));
  mesh.positions[0][0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(codes(check(mesh)), (std::vector<ErrorCode>{ErrorCode::kNotFinite, ErrorCode::kDegenerate,
                                                        ErrorCode::kNotManifold, ErrorCode::kNotOriented}));
}

// Random triangles through one ball: nearly every one of 2 · 10⁸ pairs meets.
TriangleMesh tangle(std::size_t triangles) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-1, 1);
  TriangleMesh mesh;
  for (VertexId t = 0; t < triangles; ++t) {
    for (int k = 0; k < 3; ++k) mesh.positions.emplace_back(u(random), u(random), u(random));
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

TEST(Check, StaysQuickAndSmallWhereEverythingMeetsEverything) {
  const TriangleMesh mesh = tangle(20000);
  const CheckResult one = check(mesh, {}, 1), four = check(mesh, {}, 4);
  ASSERT_EQ(one.defects.size(), 1u);
  ASSERT_EQ(four.defects.size(), 1u);
  EXPECT_EQ(one.defects[0].triangles.size(), Defect::kMaxListed);
  EXPECT_EQ(one.defects[0].triangles, four.defects[0].triangles);
  EXPECT_EQ(one.defects[0].sentence, four.defects[0].sentence);
  EXPECT_EQ(one.defects[0].count, four.defects[0].count);
  EXPECT_TRUE(mentions(one.defects[0], "more than")) << one.defects[0].sentence;
}

TEST(Check, StaysQuickWhereOneTriangleIsRepeatedVeryOften) {
  TriangleMesh mesh = sheet(1, 1);
  mesh.triangles.resize(200000, mesh.triangles[0]);
  const Defect d = onlyDefect(mesh, ErrorCode::kDegenerate);
  EXPECT_EQ(d.count, 200000u - 2);
  EXPECT_EQ(d.triangles.size(), Defect::kMaxListed);
}

TEST(Check, AnswersTheSameForAnyNumberOfThreads) {
  TriangleMesh mesh = shapes::together(sheet(40, 40), sheet(40, 40));
  for (std::size_t v = 1681; v < mesh.positions.size(); ++v) mesh.positions[v] += Vec3(0.31, 0.17, 0.05);
  const CheckResult one = check(mesh, {}, 1), three = check(mesh, {}, 3);
  ASSERT_EQ(one.defects.size(), 1u);
  ASSERT_EQ(three.defects.size(), 1u);
  EXPECT_GT(one.defects[0].count, 100u);
  EXPECT_EQ(one.defects[0].triangles, three.defects[0].triangles);
  EXPECT_EQ(one.defects[0].sentence, three.defects[0].sentence);
  EXPECT_EQ(one.facts.area, three.facts.area);
}

TEST(Check, StopsWhenItIsCancelled) {
  RunContext context;
  context.cancel();
  try {
    (void)check(sheet(30, 30), context);
    FAIL() << "a cancelled check has to throw";
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kCancelled);
  }
}

}  // namespace
}  // namespace thicken
