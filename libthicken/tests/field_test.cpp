// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>

#include "field/labels.h"
#include "field/surface_crossings.h"
#include "plain_shapes.h"
#include "sweep/sweep.h"

namespace thicken {
namespace {

UniformGrid gridAround(const TriangleMesh& mesh, double margin, double width) {
  Vec3 low = mesh.positions[0], high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 origin = low - Vec3(margin + 0.3141 * width, margin + 0.2718 * width, margin + 0.1414 * width);
  GridIndex cells{};
  for (int k = 0; k < 3; ++k) cells[k] = static_cast<int>((high[k] + margin - origin[k]) / width) + 1;
  return {origin, width, cells};
}

TEST(SurfaceCrossings, OfAClosedSurfaceCancelAlongEveryLine) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {3, 2, 1});
  const UniformGrid grid = gridAround(box, 0.5, 0.23);
  const auto crossings = surfaceCrossings(grid, box.positions, box.triangles, {}, 1);
  ASSERT_FALSE(crossings.empty());
  std::map<std::array<int, 3>, int> sum;  // by line: axis and the two other indices
  for (const SurfaceCrossing& c : crossings) {
    const int axis = static_cast<int>(c.edge & 3);
    const GridIndex n = UniformGrid::indexOf(c.edge >> 2);
    sum[{axis, n[(axis + 1) % 3], n[(axis + 2) % 3]}] += c.jump;
    EXPECT_GE(c.at, grid.coordinate(axis, n[axis]));
    EXPECT_LE(c.at, grid.coordinate(axis, n[axis] + 1));
  }
  for (const auto& [line, total] : sum) EXPECT_EQ(total, 0);
}

TEST(SurfaceCrossings, DoNotDependOnTheThreads) {
  const TriangleMesh sheet = shapes::sheet(12, 9);
  const UniformGrid grid = gridAround(sheet, 1, 0.17);
  const auto one = surfaceCrossings(grid, sheet.positions, sheet.triangles, {}, 1);
  const auto two = surfaceCrossings(grid, sheet.positions, sheet.triangles, {}, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].edge, two[i].edge);
    EXPECT_EQ(one[i].at, two[i].at);
  }
}

TEST(SurfaceCrossings, OfATriangleThatTouchesAGridLineAreRefused) {
  const UniformGrid grid({0, 0, 0}, 1, {4, 4, 4});
  const std::vector<Vec3> positions{{1, 1, 0.5}, {3, 1, 0.5}, {1, 3, 0.5}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  EXPECT_THROW((void)surfaceCrossings(grid, positions, triangles, {}, 1), GridTouches);
}

// The hierarchy must give every node the label that Definition 2 gives it by itself.
TEST(Labels, AreThoseOfDefinition2AtEveryNode) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  const double r = 1.1;
  const ClosestPointTree tree(sheet);
  const Membership membership(tree, tree, sheet.triangles.size(), r);
  const UniformGrid grid = gridAround(sheet, r + 0.5, 0.3);
  const Labels labels(grid, membership, {}, 2);
  std::size_t inside = 0;
  for (int k = 0; k < grid.cells()[2]; ++k)
    for (int j = 0; j < grid.cells()[1]; ++j)
      for (int i = 0; i < grid.cells()[0]; ++i) {
        const Vec3 p = grid.node({i, j, k});
        const bool expected = insideThickened(p, *tree.closest(p), r);
        EXPECT_EQ(labels.inside({i, j, k}), expected) << p.transpose();
        inside += expected;
      }
  EXPECT_GT(inside, 1000u);
}

}  // namespace
}  // namespace thicken
