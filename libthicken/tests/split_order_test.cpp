// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The orders that trees over triangles are made with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "bvh/area_split.h"
#include "exact/box_order.h"
#include "mesh/half_edges.h"

namespace thicken {

using bvh::AreaSplit;

namespace {

// Small triangles, each with corners of its own; `levels`: different coordinates that their places have.
TriangleMesh scattered(std::size_t count, int levels) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> level(0, levels - 1);
  TriangleMesh mesh;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 p(level(random), level(random), level(random));
    const auto first = static_cast<VertexId>(mesh.positions.size());
    for (const Vec3& d : {Vec3(0, 0, 0), Vec3(0.25, 0, 0), Vec3(0, 0.25, 0.125)})
      mesh.positions.push_back(p + d);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

std::vector<TriangleId> allOf(const TriangleMesh& mesh) {
  std::vector<TriangleId> ids(mesh.triangles.size());
  for (TriangleId t = 0; t < ids.size(); ++t) ids[t] = t;
  return ids;
}

TEST(SplitOrder, LeafOrderParsAtTheMedian) {
  for (const int levels : {1, 3, 100000}) {
    const TriangleMesh mesh = scattered(4099, levels);
    const std::vector<TriangleId> order = exact::leafOrder(mesh.positions, mesh.triangles, allOf(mesh), 1);
    EXPECT_EQ(order, exact::leafOrder(mesh.positions, mesh.triangles, allOf(mesh), 2));
    std::vector<TriangleId> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, allOf(mesh));
    const std::uint32_t leaves = (4099 + exact::kLeafSize - 1) / exact::kLeafSize;
    const std::size_t half = exact::kLeafSize * exact::Subtree{0, 0, leaves}.left().count;
    bool parted = false;  // along some axis
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](TriangleId t) { return mesh.positions[mesh.triangles[t][0]][k]; };
      double most = -1, least = levels;
      for (std::size_t i = 0; i < order.size(); ++i)
        (i < half ? most : least) = i < half ? std::max(most, at(order[i])) : std::min(least, at(order[i]));
      parted = parted || most <= least;
    }
    EXPECT_TRUE(parted) << levels;
  }
}

void expectAround(const AreaSplit& split, const AreaSplit::Range& r, const TriangleMesh& mesh) {
  for (std::uint32_t i = r.begin; i < r.end; ++i)
    for (const VertexId v : mesh.triangles[split.triangle(i)])
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(mesh.positions[v][k], r.box.low[k]);
        EXPECT_LE(mesh.positions[v][k], r.box.high[k]);
      }
}

TEST(SplitOrder, AreaSplitKeepsAllAndKnowsTheirBoxes) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{30}, std::size_t{20000}}) {
    const TriangleMesh mesh = scattered(count, 50);
    AreaSplit one(mesh.positions, mesh.triangles, Vec3::Zero(), 1);
    AreaSplit two(mesh.positions, mesh.triangles, Vec3::Zero(), 2);
    const auto [left, right] = one.split(one.whole(), 1);
    const auto [otherLeft, otherRight] = two.split(two.whole(), 2);
    EXPECT_EQ(left.begin, 0u);
    EXPECT_EQ(left.end, right.begin);
    EXPECT_EQ(right.end, count);
    EXPECT_GT(left.size(), 0u);
    EXPECT_GT(right.size(), 0u);
    EXPECT_EQ(left.end, otherLeft.end);
    EXPECT_EQ(right.end, otherRight.end);
    expectAround(one, left, mesh);
    expectAround(one, right, mesh);
    std::vector<TriangleId> ids;
    for (std::uint32_t i = 0; i < count; ++i) {
      ids.push_back(one.triangle(i));
      EXPECT_EQ(ids.back(), two.triangle(i));
    }
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(ids, allOf(mesh));
  }
}

TEST(SplitOrder, AreaSplitOfWhatCoincidesHalves) {
  const TriangleMesh mesh = scattered(9, 1);
  AreaSplit split(mesh.positions, mesh.triangles, Vec3::Zero(), 1);
  const auto [left, right] = split.split(split.whole());
  EXPECT_EQ(left.size(), 4u);
  EXPECT_EQ(right.size(), 5u);
}

TEST(SplitOrder, UsesOfEdgesAreFoundInSmallAndLargeFans) {
  for (const VertexId spokes : {3u, 40u}) {
    std::vector<Triangle> fan;
    for (VertexId i = 1; i < spokes; ++i) fan.push_back({0, i, i + 1});
    fan.push_back({0, 2, 1});  // a second one that leaves towards 2
    const mesh::HalfEdges edges(spokes + 1, fan);
    EXPECT_EQ(edges.uses(0, 1).size(), 1u);
    EXPECT_EQ(edges.uses(0, 2).size(), 2u);
    EXPECT_EQ(edges.uses(0, spokes).size(), 0u);
    EXPECT_EQ(edges.uses(spokes, 0).size(), 1u);
  }
}

}  // namespace
}  // namespace thicken
