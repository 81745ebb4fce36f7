// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include "contour/rim_walk.h"
#include "mesh/topology.h"

namespace thicken {

using contour::RimWay;
using field::UniformGrid;

namespace {

// A triangle whose three edges are the rim.
std::vector<RimWay> waysOf(const std::vector<Vec3>& positions, const UniformGrid& grid) {
  const std::vector<Triangle> triangles{{0, 1, 2}};
  return contour::rimWays(grid, positions, mesh::rimOf(positions.size(), triangles));
}

TEST(RimWays, OfALoopWithinOneCellAreOneVisit) {
  const UniformGrid grid({0, 0, 0}, 1, {4, 4, 4});
  const auto ways = waysOf({{1.2, 1.2, 1.5}, {1.8, 1.3, 1.5}, {1.4, 1.9, 1.5}}, grid);
  ASSERT_EQ(ways.size(), 1u);
  ASSERT_EQ(ways[0].size(), 1u);
  EXPECT_EQ(ways[0][0].vertices.size(), 3u);
}

TEST(RimWays, LoseExcursions) {
  // Vertex 1 stands in the next cell; the rim comes and goes through one face.
  const UniformGrid grid({0, 0, 0}, 1, {4, 4, 4});
  const auto ways = waysOf({{1.2, 1.2, 1.5}, {2.3, 1.3, 1.5}, {1.4, 1.9, 1.5}}, grid);
  ASSERT_EQ(ways[0].size(), 1u);
  EXPECT_EQ(ways[0][0].vertices.size(), 3u);
}

TEST(RimWays, PassFromCellToNeighbourAllTheWayRound) {
  const UniformGrid grid({0, 0, 0}, 1, {8, 8, 8});
  const auto ways = waysOf({{0.3, 0.35, 0.6}, {6.2, 1.4, 3.7}, {2.1, 5.8, 1.9}}, grid);
  ASSERT_EQ(ways.size(), 1u);
  const RimWay& way = ways[0];
  ASSERT_GT(way.size(), 12u);
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    vertices += way[i].vertices.size();
    const contour::RimVisit& next = way[(i + 1) % way.size()];
    const int axis = static_cast<int>(way[i].exit.face & 3);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(next.cell[k] - way[i].cell[k], k == axis ? way[i].exit.sign : 0);
    EXPECT_NE(next.cell, way[(i + way.size() - 1) % way.size()].cell) << "an excursion remains";
    for (int k = 0; k < 3; ++k)
      if (k != axis) {
        EXPECT_GE(way[i].exit.at[k], way[i].cell[k]);
        EXPECT_LE(way[i].exit.at[k], way[i].cell[k] + 1);
      }
  }
  EXPECT_EQ(vertices, 3u);
}

}  // namespace
}  // namespace thicken
