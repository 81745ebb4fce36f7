// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <limits>

#include "thicken/check.h"

namespace thicken {
namespace {

TEST(Weld, MakesEqualCornersOneVertexInOrderOfFirstUse) {
  const TriangleMesh soup{{{9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                          {{3, 1, 2}, {4, 5, 6}}};
  const TriangleMesh mesh = weld(soup);
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}}));
}

TEST(Weld, TakesMinusZeroForZeroAndKeepsNextFloatsApart) {
  const TriangleMesh mesh = weld({{{0.0, -0.0, 0}, {-0.0, 0.0, 0}, {0, 0, 5e-324}}, {{0, 1, 2}}});
  EXPECT_EQ(mesh.positions.size(), 2u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 0, 1}}));
}

TEST(Weld, KeepsTrianglesThatCollapseAndCoordinatesThatAreNotNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TriangleMesh mesh = weld({{{nan, 0, 0}, {nan, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {2, 2, 2}}});
  EXPECT_EQ(mesh.positions.size(), 2u);
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 0, 1}, {1, 1, 1}}));
}

TEST(Weld, LeavesNothingOfNothing) {
  const TriangleMesh mesh = weld({{{1, 2, 3}}, {}});
  EXPECT_TRUE(mesh.positions.empty());
  EXPECT_TRUE(mesh.triangles.empty());
}

}  // namespace
}  // namespace thicken
