// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thicken {

using mesh::componentsOf;
using mesh::kNone;
using mesh::neighbours;
using mesh::rimOf;

namespace {

// A grid of (columns + 1) × (rows + 1) vertices; triangles 2·cell and 2·cell + 1, cells row by row.
std::vector<Triangle> grid(VertexId columns, VertexId rows) {
  std::vector<Triangle> triangles;
  for (VertexId y = 0; y < rows; ++y) {
    for (VertexId x = 0; x < columns; ++x) {
      const VertexId a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({a, d, c});
    }
  }
  return triangles;
}

TEST(Topology, ListsTheTrianglesAroundAVertex) {
  const std::vector<Triangle> triangles = grid(2, 1);  // 0 1 2 / 3 4 5
  const mesh::VertexTriangles around = mesh::vertexTriangles(7, triangles);
  const auto of = [&around](VertexId v) {
    const auto span = around.of(v);
    return std::vector<TriangleId>(span.begin(), span.end());
  };
  EXPECT_EQ(of(0), (std::vector<TriangleId>{0, 1}));
  EXPECT_EQ(of(1), (std::vector<TriangleId>{0, 2, 3}));
  EXPECT_EQ(of(5), (std::vector<TriangleId>{2, 3}));
  EXPECT_TRUE(of(6).empty());
}

TEST(Topology, FindsTheNeighbourAcrossEachEdge) {
  const auto result = neighbours(6, grid(2, 1));
  EXPECT_EQ(result[0], (std::array<TriangleId, 3>{kNone, 3, 1}));
  EXPECT_EQ(result[1], (std::array<TriangleId, 3>{0, kNone, kNone}));
  EXPECT_EQ(result[3], (std::array<TriangleId, 3>{2, kNone, 0}));
}

TEST(Topology, FollowsEachRimFromItsSmallestVertex) {
  std::vector<Triangle> triangles = grid(3, 3);
  triangles.erase(triangles.begin() + 8, triangles.begin() + 10);  // the middle cell: 5 6 / 9 10
  const mesh::Rim rim = rimOf(16, triangles);
  ASSERT_EQ(rim.loops(), 2u);
  const auto vertices = [&rim](std::size_t loop) {
    std::vector<VertexId> v;
    for (std::uint32_t e = rim.loopStart[loop]; e < rim.loopStart[loop + 1]; ++e)
      v.push_back(rim.edges[e].from);
    return v;
  };
  EXPECT_EQ(vertices(0), (std::vector<VertexId>{0, 1, 2, 3, 7, 11, 15, 14, 13, 12, 8, 4}));
  EXPECT_EQ(vertices(1), (std::vector<VertexId>{5, 9, 10, 6}));
  for (const mesh::RimEdge& e : rim.edges) {
    const Triangle& t = triangles[e.triangle];
    const auto from = std::find(t.begin(), t.end(), e.from);
    ASSERT_NE(from, t.end());
    EXPECT_EQ(t[(from - t.begin() + 1) % 3], e.to);
  }
}

TEST(Topology, FindsNoRimOnAClosedSurface) {
  const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_EQ(rimOf(4, tetrahedron).loops(), 0u);
  for (const auto& n : neighbours(4, tetrahedron))
    for (const TriangleId t : n) EXPECT_NE(t, kNone);
}

TEST(Topology, NumbersComponentsByTheirFirstTriangle) {
  const mesh::Components two =
      componentsOf(9, std::vector<Triangle>{{6, 7, 8}, {0, 1, 2}, {8, 3, 4}, {2, 1, 5}});
  EXPECT_EQ(two.count, 2u);
  EXPECT_EQ(two.ofTriangle, (std::vector<std::uint32_t>{0, 1, 0, 1}));
  EXPECT_EQ(componentsOf(0, {}).count, 0u);
}

TEST(Topology, IsQuickAroundAVertexOfVeryManyTriangles) {
  constexpr VertexId kFan = 100000;
  std::vector<Triangle> fan;
  for (VertexId k = 1; k < kFan; ++k) fan.push_back({0, k, k + 1});
  EXPECT_EQ(neighbours(kFan + 1, fan)[500], (std::array<TriangleId, 3>{499, kNone, 501}));
  EXPECT_EQ(rimOf(kFan + 1, fan).edges.size(), kFan + 1);
}

}  // namespace
}  // namespace thicken
