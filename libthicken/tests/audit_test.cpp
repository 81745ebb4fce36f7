// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/audit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>

#include "check/nesting.h"
#include "plain_shapes.h"

namespace thicken {

using checking::AuditResult;

namespace {

using shapes::box;
using shapes::reversed;
using shapes::sheet;
using shapes::slab;
using shapes::together;

AuditResult auditOf(const TriangleMesh& solid, const TriangleMesh& surface, Side side = Side::kNegative,
                    int threads = 2) {
  return checking::audit(solid, surface, side, RunContext(), threads);
}

// The names of the verdicts that are negative, in the order of AuditFacts.
std::string failures(const AuditResult& result) {
  const AuditFacts& f = result.facts;
  std::string list;
  const auto add = [&list](bool verdict, const char* name) {
    if (!verdict) list += std::string(list.empty() ? "" : " ") + name;
  };
  add(f.closed, "closed");
  add(f.edgeManifold, "edgeManifold");
  add(f.vertexManifold, "vertexManifold");
  add(f.oriented, "oriented");
  add(f.nonDegenerate, "nonDegenerate");
  add(f.intersectionFree, "intersectionFree");
  add(f.positiveVolume, "positiveVolume");
  add(f.surfaceKept, "surfaceKept");
  EXPECT_EQ(f.passed(), list.empty());
  EXPECT_EQ(result.defects.empty(), list.empty());
  return list;
}

class AuditTest : public ::testing::Test {
 protected:
  static constexpr double kDepth = 0.5;
  TriangleMesh surface_ = sheet(5, 4);
  TriangleMesh solid_ = slab(surface_, kDepth);
  const VertexId copies_ = static_cast<VertexId>(surface_.positions.size());
  const std::size_t sheetTriangles_ = surface_.triangles.size();

  // (x, y) of the sheet
  static VertexId at(VertexId x, VertexId y) { return 6 * y + x; }
};

TEST_F(AuditTest, PassesAGoodSolidOnEitherSide) {
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "");
  TriangleMesh above = slab(surface_, -kDepth);
  EXPECT_EQ(failures(auditOf(reversed(above), surface_, Side::kPositive)), "");
  EXPECT_EQ(failures(auditOf(solid_, surface_, Side::kPositive)), "surfaceKept");
}

TEST_F(AuditTest, PassesASolidAroundTheSurfaceThatKeepsItsRim) {
  TriangleMesh upper = surface_;
  for (Vec3& p : upper.positions) p += Vec3(0, 0, kDepth);
  // the copy above, the copy below, and walls through the rim of the surface between them
  TriangleMesh solid = together(surface_, slab(upper, 2 * kDepth));
  solid.triangles.clear();
  const VertexId top = copies_, bottom = 2 * copies_;
  for (const Triangle& t : surface_.triangles) {
    solid.triangles.push_back({top + t[0], top + t[1], top + t[2]});
    solid.triangles.push_back({bottom + t[0], bottom + t[2], bottom + t[1]});
  }
  for (const mesh::RimEdge& e : mesh::rimOf(copies_, surface_.triangles).edges) {
    for (const auto& [over, under] : {std::pair{top, VertexId{0}}, std::pair{VertexId{0}, bottom}}) {
      solid.triangles.push_back({over + e.to, over + e.from, under + e.from});
      solid.triangles.push_back({over + e.to, under + e.from, under + e.to});
    }
  }
  EXPECT_EQ(failures(auditOf(solid, surface_, Side::kBoth)), "");
  EXPECT_EQ(failures(auditOf(solid, surface_, Side::kNegative)), "surfaceKept");
  solid.positions[at(0, 2)] += Vec3(0.01, 0, 0);
  EXPECT_EQ(failures(auditOf(solid, surface_, Side::kBoth)), "surfaceKept");
}

TEST_F(AuditTest, SeesAHole) {
  solid_.triangles.erase(solid_.triangles.begin() + static_cast<std::ptrdiff_t>(sheetTriangles_) + 12);
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_EQ(failures(result), "closed");
  EXPECT_EQ(result.defects[0].edges.size(), 3u);
}

TEST_F(AuditTest, SeesAFlippedTriangle) {
  Triangle& t = solid_.triangles[sheetTriangles_ + 12];
  std::swap(t[0], t[1]);
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_EQ(failures(result), "oriented");
  EXPECT_EQ(result.defects[0].code, ErrorCode::kNotOriented);
}

TEST_F(AuditTest, SeesADuplicateTriangle) {
  solid_.triangles.push_back(solid_.triangles[sheetTriangles_ + 12]);
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_EQ(failures(result), "nonDegenerate");
  EXPECT_EQ(result.defects[0].triangles.back(), solid_.triangles.size() - 1);
}

TEST_F(AuditTest, SeesAMovedVertexOfTheSurface) {
  solid_.positions[at(2, 2)][2] = std::nextafter(solid_.positions[at(2, 2)][2], 9.0);
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_EQ(failures(result), "surfaceKept");
  EXPECT_EQ(result.defects[0].count, 6u);
}

TEST_F(AuditTest, SeesATriangleOfTheSurfaceTurnedOver) {
  std::swap(surface_.triangles[7][0], surface_.triangles[7][1]);
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "surfaceKept");
}

TEST_F(AuditTest, TakesATriangleThatStartsAtAnotherCorner) {
  std::rotate(surface_.triangles[7].begin(), surface_.triangles[7].begin() + 1, surface_.triangles[7].end());
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "");
}

TEST_F(AuditTest, SeesThatTheShellRunsThroughTheSurface) {
  solid_.positions[copies_ + at(2, 2)][2] += 1.5 * kDepth;
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "intersectionFree");
}

TEST_F(AuditTest, SeesATouch) {
  const Vec3 middle =
      (surface_.positions[at(2, 2)] + surface_.positions[at(3, 2)] + surface_.positions[at(3, 3)]) / 4 +
      surface_.positions[at(2, 2)] / 4;
  solid_.positions[copies_ + at(2, 2)] = middle;  // rounded: may lie a little above or below
  solid_.positions[copies_ + at(2, 2)][2] += 1e-9;
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "intersectionFree");
}

TEST_F(AuditTest, SeesASolidInsideOut) {
  EXPECT_EQ(failures(auditOf(reversed(solid_), reversed(surface_))), "oriented positiveVolume");
}

TEST_F(AuditTest, SeesVerticesOfOnePlaceThatTouch) {
  // a vertex of the shell in the place of one of the surface: the mesh is non-manifold there once it is
  // welded
  solid_.positions[copies_ + at(2, 2)] = solid_.positions[at(2, 2)];
  EXPECT_EQ(failures(auditOf(solid_, surface_)), "vertexManifold");
}

TEST_F(AuditTest, SeesATriangleThatCollapses) {
  solid_.positions[copies_ + at(2, 2)] = solid_.positions[copies_ + at(3, 2)];
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_EQ(failures(result), "nonDegenerate");
  EXPECT_EQ(result.defects[0].count, 2u);
}

TEST_F(AuditTest, SeesATriangleWithCornersOnALine) {
  const TriangleMesh cube = box({0, 0, 0}, {2, 2, 2});
  TriangleMesh split = cube;
  split.positions.emplace_back(1, 0, 0);  // on the edge 0-1, which {0, 3, 1} and {0, 1, 5} share
  split.triangles[0] = {0, 3, 1};
  split.triangles[4] = {0, 8, 5};
  split.triangles.push_back({8, 1, 5});
  split.triangles.push_back({0, 1, 8});
  // its neighbours touch along that line without a common edge
  EXPECT_EQ(failures(auditOf(split, {})), "nonDegenerate intersectionFree");
}

TEST_F(AuditTest, SeesAThirdTriangleAtAnEdge) {
  // two boxes that share an edge, as one mesh
  TriangleMesh pair = together(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(failures(auditOf(pair, {})), "edgeManifold");
}

TEST_F(AuditTest, TakesSolidsSideBySide) {
  const TriangleMesh two = together(solid_, box({20, 0, 0}, {21, 1, 1}));
  EXPECT_EQ(failures(auditOf(two, surface_)), "");
  const TriangleMesh wrong = together(solid_, reversed(box({20, 0, 0}, {21, 1, 1})));
  EXPECT_EQ(failures(auditOf(wrong, surface_)), "oriented");
}

TEST_F(AuditTest, DecidesTheSenseOfNestedShells) {
  const TriangleMesh outer = box({0, 0, 0}, {9, 9, 9}), cavity = reversed(box({1, 1, 1}, {8, 8, 8})),
                     core = box({2, 2, 2}, {7, 7, 7});
  EXPECT_EQ(failures(auditOf(together(outer, cavity), {})), "");
  EXPECT_EQ(failures(auditOf(together(cavity, outer), {})), "");
  EXPECT_EQ(failures(auditOf(together(together(core, cavity), outer), {})), "");
  EXPECT_EQ(failures(auditOf(together(outer, core), {})), "oriented");
  EXPECT_EQ(failures(auditOf(together(together(outer, cavity), reversed(core)), {})), "oriented");
  EXPECT_EQ(failures(auditOf(together(reversed(outer), reversed(cavity)), {})), "oriented positiveVolume");
}

TEST_F(AuditTest, RefusesNothingAndWhatIsNotFinite) {
  EXPECT_FALSE(auditOf({}, {}).facts.passed());
  EXPECT_EQ(auditOf({}, {}).defects.at(0).code, ErrorCode::kEmpty);
  solid_.positions[copies_][0] = std::numeric_limits<double>::quiet_NaN();
  const AuditResult result = auditOf(solid_, surface_);
  EXPECT_FALSE(result.facts.passed());
  EXPECT_EQ(result.defects.at(0).code, ErrorCode::kNotFinite);
}

TEST_F(AuditTest, AnswersTheSameForAnyNumberOfThreads) {
  solid_.positions[copies_ + at(2, 2)][2] += 1.5 * kDepth;
  const AuditResult one = auditOf(solid_, surface_, Side::kNegative, 1),
                    four = auditOf(solid_, surface_, Side::kNegative, 4);
  ASSERT_EQ(one.defects.size(), four.defects.size());
  for (std::size_t i = 0; i < one.defects.size(); ++i) {
    EXPECT_EQ(one.defects[i].sentence, four.defects[i].sentence);
    EXPECT_EQ(one.defects[i].triangles, four.defects[i].triangles);
  }
}

// A polyhedron with ridges and flat places around its lowest vertex, turned at random: corners of a
// small grid put many of its vertices at equal coordinates.
TEST(Nesting, DecidesTheSenseOfAnyShellFromItsLowestVertex) {
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> height(1, 3), size(2, 4);
  for (int i = 0; i < 300; ++i) {
    TriangleMesh top = sheet(static_cast<VertexId>(size(random)), static_cast<VertexId>(size(random)));
    for (Vec3& p : top.positions) p[2] = height(random);
    TriangleMesh solid = slab(top, 5);
    for (std::size_t v = top.positions.size(); v < solid.positions.size(); ++v) solid.positions[v][2] = 0;
    // an exact turn: axes exchanged and mirrored; an odd number of those turns the shell inside out
    int axes[3] = {0, 1, 2};
    std::shuffle(axes, axes + 3, random);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 3; ++k) turn(k, axes[k]) = height(random) == 1 ? -1 : 1;
    for (Vec3& p : solid.positions) p = turn * p;
    const mesh::HalfEdges edges(solid.positions.size(), solid.triangles);
    const mesh::Components shells = mesh::componentsOf(solid.positions.size(), solid.triangles);
    ASSERT_EQ(shells.count, 1u);
    const VertexId lowest = checking::lowestVertices(solid, shells)[0];
    EXPECT_EQ(checking::facesOutward(solid, edges, lowest), turn.determinant() > 0) << i;
    EXPECT_EQ(failures(auditOf(turn.determinant() > 0 ? solid : reversed(solid), {})), "");
  }
}

TEST(Nesting, CountsShellsEvenWhereEveryRayMeetsEdgesAndVertices) {
  // shells in shells with common centre: rays from their corners along an axis run through diagonals
  TriangleMesh solid;
  constexpr int kShells = 12;
  for (int i = 0; i < kShells; ++i) {
    TriangleMesh ball;  // an octahedron: its vertices lie on the axes, its edges in the planes between them
    const double r = kShells - i;
    for (int k = 0; k < 3; ++k)
      for (const double s : {-r, r}) {
        Vec3 p = Vec3::Zero();
        p[k] = s;
        ball.positions.push_back(p);
      }
    for (const VertexId x : {0u, 1u})
      for (const VertexId y : {2u, 3u})
        for (const VertexId z : {4u, 5u}) {
          Triangle t{x, y, z};
          if ((x + y + z) % 2 == 0) std::swap(t[1], t[2]);
          ball.triangles.push_back(t);
        }
    solid = together(solid, i % 2 == 0 ? ball : reversed(ball));
  }
  EXPECT_EQ(failures(auditOf(solid, {})), "");
  for (std::size_t t = 40; t < 48; ++t) std::swap(solid.triangles[t][1], solid.triangles[t][2]);
  EXPECT_EQ(failures(auditOf(solid, {})), "oriented");
}

TEST(Nesting, StaysCheapForThousandsOfShells) {
  TriangleMesh solid;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 low(3 * (i % 20), 3 * (i / 20 % 20), 3 * (i / 400));
    const TriangleMesh one = box(low, low + Vec3(2, 2, 2));
    const auto first = static_cast<VertexId>(solid.positions.size());
    solid.positions.insert(solid.positions.end(), one.positions.begin(), one.positions.end());
    for (const Triangle& t : one.triangles)
      solid.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  EXPECT_EQ(failures(auditOf(solid, {})), "");
}

}  // namespace
}  // namespace thicken
