// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "exact/float_box.h"
#include "exact/pair_search.h"
#include "exact/predicates.h"
#include "exact/triangle_pair.h"

namespace thicken {
namespace {

using exact::BoxTree;
using exact::TrianglePair;
using Pairs = std::vector<TrianglePair>;
using Marks = std::vector<std::uint8_t>;

// A soup of small triangles in the unit cube, some of which share vertices, some of which have no area.
class BoxTreeTest : public ::testing::Test {
 protected:
  TriangleMesh soup(std::size_t triangles, double size) {
    TriangleMesh mesh;
    for (std::size_t t = 0; t < triangles; ++t) {
      const VertexId v = static_cast<VertexId>(mesh.positions.size());
      const Vec3 centre(uniform(), uniform(), uniform());
      for (int k = 0; k < 3; ++k)
        mesh.positions.push_back(centre + size * Vec3(uniform(), uniform(), uniform()));
      mesh.triangles.push_back({v, v + 1, v + 2});
      if (t % 5 == 1) mesh.triangles.back()[0] = v - 1;
      if (t % 11 == 3) mesh.triangles.back()[2] = v;
    }
    return mesh;
  }
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  Marks marks(std::size_t count, double share) {
    Marks m(count);
    for (auto& x : m) x = uniform() < share;
    return m;
  }

  std::mt19937_64 random_{3};
  RunContext context_;
};

Pairs bruteForce(const TriangleMesh& mesh, const Marks& active = {}, const Marks& fixed = {}) {
  Pairs pairs;
  const auto counts = [&](TriangleId t) {
    const Triangle& c = mesh.triangles[t];
    return (active.empty() || active[t]) &&
           !exact::collinear(mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]);
  };
  for (TriangleId a = 0; a < mesh.triangles.size(); ++a)
    for (TriangleId b = a + 1; b < mesh.triangles.size() && counts(a); ++b)
      if (counts(b) && (fixed.empty() || !fixed[a] || !fixed[b]) &&
          exact::meet(mesh.positions, mesh.triangles[a], mesh.triangles[b]))
        pairs.emplace_back(a, b);
  return pairs;
}

TEST_F(BoxTreeTest, AnswersDoNotDependOnAGivenOrder) {
  const TriangleMesh mesh = soup(300, 0.2);
  const auto pairsOf = [&](const BoxTree& tree) {
    return tree.meetingPairs(mesh.positions, mesh.triangles, {}, context_, 1);
  };
  const BoxTree made(mesh.positions, mesh.triangles, 1);
  std::vector<TriangleId> order = made.order();
  ASSERT_EQ(order.size(), mesh.triangles.size());
  std::shuffle(order.begin(), order.end(), random_);
  const BoxTree shuffled(mesh.positions, mesh.triangles, 1, {}, order);
  EXPECT_EQ(shuffled.order(), order);
  EXPECT_EQ(pairsOf(shuffled), pairsOf(made));

  order[7] = order[8];  // names a triangle twice and another not at all
  EXPECT_EQ(BoxTree(mesh.positions, mesh.triangles, 1, {}, order).order(), made.order());
  order[7] = 300;
  EXPECT_EQ(BoxTree(mesh.positions, mesh.triangles, 1, {}, order).order(), made.order());
  order.pop_back();
  EXPECT_EQ(BoxTree(mesh.positions, mesh.triangles, 1, {}, order).order(), made.order());
  Marks active(300, 1);
  active[4] = 0;  // named, and not in
  const BoxTree some(mesh.positions, mesh.triangles, 1, active, made.order());
  EXPECT_EQ(some.order().size(), 299u);
}

TEST_F(BoxTreeTest, FindsThePairsThatBruteForceFinds) {
  for (const std::size_t count : {0, 1, 2, 3, 4, 5, 9, 63, 500}) {
    const TriangleMesh mesh = soup(count, 0.2);
    const Pairs expected = bruteForce(mesh);
    if (count == 500) {
      EXPECT_GT(expected.size(), 100u);
    }
    for (const int threads : {1, 2, 4}) {
      const BoxTree tree(mesh.positions, mesh.triangles, threads);
      EXPECT_EQ(tree.meetingPairs(mesh.positions, mesh.triangles, {}, context_, threads), expected);
    }
  }
}

TEST_F(BoxTreeTest, LeavesOutInactiveTrianglesAndPairsOfFixedOnes) {
  const TriangleMesh mesh = soup(600, 0.2);
  const Marks active = marks(600, 0.7), fixed = marks(600, 0.6);
  const BoxTree tree(mesh.positions, mesh.triangles, 2, active);
  EXPECT_EQ(tree.meetingPairs(mesh.positions, mesh.triangles, fixed, context_, 2),
            bruteForce(mesh, active, fixed));
  EXPECT_TRUE(tree.meetingPairs(mesh.positions, mesh.triangles, Marks(600, 1), context_, 2).empty());
}

TEST_F(BoxTreeTest, RetestsWhatMoved) {
  TriangleMesh mesh = soup(800, 0.15);
  const Marks active = marks(800, 0.9), fixed = marks(800, 0.3);
  BoxTree tree(mesh.positions, mesh.triangles, 2, active);
  for (const double share : {0.01, 0.05, 0.2, 0.9}) {
    std::vector<char> vertexMoved(mesh.positions.size(), 0);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      if (uniform() > share / 3) continue;
      vertexMoved[v] = 1;
      mesh.positions[v] += 0.5 * Vec3(uniform(), uniform(), uniform());
    }
    std::vector<TriangleId> moved;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
      for (const VertexId v : mesh.triangles[t])
        if (vertexMoved[v]) {
          moved.push_back(t);
          break;
        }
    ASSERT_FALSE(moved.empty());
    tree.refit(mesh.positions, mesh.triangles, moved);

    const Pairs all = bruteForce(mesh, active, fixed);
    EXPECT_EQ(tree.meetingPairs(mesh.positions, mesh.triangles, fixed, context_, 2), all);
    Pairs expected;
    const auto hasMoved = [&moved](TriangleId t) {
      return std::binary_search(moved.begin(), moved.end(), t);
    };
    for (const TrianglePair& pair : all)
      if (hasMoved(pair.first) || hasMoved(pair.second)) expected.push_back(pair);
    ASSERT_FALSE(expected.empty());
    for (const int threads : {1, 3})
      EXPECT_EQ(tree.meetingPairsWith(moved, mesh.positions, mesh.triangles, fixed, context_, threads),
                expected);
  }
  EXPECT_TRUE(tree.meetingPairsWith({}, mesh.positions, mesh.triangles, fixed, context_, 1).empty());
}

TEST_F(BoxTreeTest, FindsTheSamePairsInBlocks) {
  const TriangleMesh mesh = soup(2000, 0.12);
  const Marks active = marks(mesh.triangles.size(), 0.9), fixed = marks(mesh.triangles.size(), 0.3);
  const exact::PairSearch whole(mesh, exact::PairSearch::kAll, 2, active);
  const Pairs expected = whole.all(fixed, context_, 2);
  ASSERT_GT(expected.size(), 1000u);
  for (const std::size_t most : {200, 700, 1999}) {
    const exact::PairSearch blocks(mesh, most, 2, active);
    for (const int threads : {1, 2}) EXPECT_EQ(blocks.all(fixed, context_, threads), expected) << most;
    EXPECT_GT(blocks.all({}, context_, 2, 100).size(), 100u);
  }
}

TEST_F(BoxTreeTest, RetestsWhatMovedInBlocks) {
  TriangleMesh mesh = soup(2000, 0.12);
  const Marks active = marks(mesh.triangles.size(), 0.9), fixed = marks(mesh.triangles.size(), 0.3);
  exact::PairSearch whole(mesh, exact::PairSearch::kAll, 2, active), blocks(mesh, 700, 2, active);
  for (const double share : {0.002, 0.1, 0.8}) {
    std::vector<TriangleId> moved;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
      if (uniform() < share) moved.push_back(t);
    for (const TriangleId t : moved)
      for (const VertexId v : mesh.triangles[t]) mesh.positions[v] += 0.01 * Vec3(uniform(), uniform(), 0);
    // Those that share a vertex with them have moved, too.
    Marks hasMoved(mesh.positions.size(), 0);
    for (const TriangleId t : moved)
      for (const VertexId v : mesh.triangles[t]) hasMoved[v] = 1;
    moved.clear();
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
      if (std::ranges::any_of(mesh.triangles[t], [&](VertexId v) { return hasMoved[v] != 0; }))
        moved.push_back(t);
    EXPECT_EQ(blocks.withMoved(moved, fixed, context_, 2), whole.withMoved(moved, fixed, context_, 2));
  }
}

TEST_F(BoxTreeTest, StopsSoonAfterTheLimit) {
  TriangleMesh mesh = soup(1500, 2);  // everything meets everything
  const BoxTree tree(mesh.positions, mesh.triangles, 2);
  const Pairs some = tree.meetingPairs(mesh.positions, mesh.triangles, {}, context_, 2, 1000);
  EXPECT_GT(some.size(), 1000u);
  EXPECT_LT(some.size(), 2000u);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end()));
  for (const auto& [a, b] : some)
    EXPECT_TRUE(exact::meet(mesh.positions, mesh.triangles[a], mesh.triangles[b]));
}

TEST_F(BoxTreeTest, FindsTouchesThatFloatsWouldRoundAway) {
  // two triangles that touch at a coordinate between two floats
  const double x = 1.0 + 0x1p-40;
  const TriangleMesh mesh{{{0, 0, 0}, {x, 0, 0}, {0, 1, 0}, {x, 0, 0}, {3, 0, 1}, {3, 1, 0}},
                          {{0, 1, 2}, {3, 4, 5}}};
  const BoxTree tree(mesh.positions, mesh.triangles, 1);
  EXPECT_EQ(tree.meetingPairs(mesh.positions, mesh.triangles, {}, context_, 1).size(), 1u);
}

TEST_F(BoxTreeTest, BuildsOverCoordinatesThatAreNotNumbers) {
  TriangleMesh mesh = soup(100, 0.2);
  for (std::size_t v = 0; v < mesh.positions.size(); v += 7)
    mesh.positions[v][v % 3] = v % 2 ? std::numeric_limits<double>::quiet_NaN() : 1e300;
  EXPECT_NO_THROW(BoxTree(mesh.positions, mesh.triangles, 2));
}

TEST(FloatBox, HoldsTheDoubleThatItWasMadeFor) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-200, 200);
  for (int i = 0; i < 10000; ++i) {
    const double x = std::ldexp(mantissa(random), exponent(random));
    EXPECT_LE(static_cast<double>(exact::floatBelow(x)), x);
    EXPECT_GE(static_cast<double>(exact::floatAbove(x)), x);
    const double y = static_cast<float>(x);
    if (std::isfinite(y)) {
      EXPECT_GE(exact::floatBelow(y), std::nextafter(static_cast<float>(y), -INFINITY));
    }
  }
  for (const double x : {0.0, -0.0, 1e-300, -1e-300, 3.5e38, -3.5e38}) {
    EXPECT_LE(static_cast<double>(exact::floatBelow(x)), x);
    EXPECT_GE(static_cast<double>(exact::floatAbove(x)), x);
  }
}

}  // namespace
}  // namespace thicken
