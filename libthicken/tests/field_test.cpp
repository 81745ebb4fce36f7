// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <map>

#include "contour/follow.h"
#include "contour/rim_walk.h"
#include "field/node_field.h"
#include "field/surface_crossings.h"
#include "jobs.h"
#include "mesh/topology.h"
#include "plain_shapes.h"

namespace thicken {

using contour::EdgePart;
using field::GridIndex;
using field::KeyIndex;
using field::Membership;
using field::NodeField;
using field::Probe;
using field::Standing;
using field::SurfaceCrossing;
using field::SurfaceCrossings;
using field::UniformGrid;
using mesh::rimOf;

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

std::vector<GridIndex> allNodes(const UniformGrid& grid) {
  std::vector<GridIndex> nodes;
  for (int k = 0; k < grid.cells()[2]; ++k)
    for (int j = 0; j < grid.cells()[1]; ++j)
      for (int i = 0; i < grid.cells()[0]; ++i) nodes.push_back({i, j, k});
  return nodes;
}

TEST(SurfaceCrossings, OfAClosedSurfaceCancelAlongEveryLine) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {3, 2, 1});
  const UniformGrid grid = gridAround(box, 0.5, 0.23);
  const SurfaceCrossings surface(grid, box.positions, box.triangles, 1);
  std::map<std::array<int, 3>, int> sum;  // by line: axis and the two other indices
  std::size_t count = 0;
  for (const GridIndex& n : allNodes(grid))
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<SurfaceCrossing> crossings;
      surface.addTo(crossings, UniformGrid::key(n, axis));
      for (const SurfaceCrossing& c : crossings) {
        sum[{axis, n[(axis + 1) % 3], n[(axis + 2) % 3]}] += c.jump;
        EXPECT_GE(c.at, grid.coordinate(axis, n[axis]));
        EXPECT_LE(c.at, grid.coordinate(axis, n[axis] + 1));
        ++count;
      }
    }
  EXPECT_GT(count, 300u);
  for (const auto& [line, total] : sum) EXPECT_EQ(total, 0);
}

TEST(SurfaceCrossings, OfAPlaneAreWhereItIs) {
  const UniformGrid grid({0, 0, 0}, 1, {4, 4, 4});
  const std::vector<Vec3> positions{{0.5, 0.5, 1.25}, {3.5, 0.5, 1.25}, {0.5, 3.5, 1.25}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const SurfaceCrossings surface(grid, positions, triangles, 1);
  std::vector<SurfaceCrossing> crossings;
  surface.addTo(crossings, UniformGrid::key({1, 1, 0}, 2));
  surface.addTo(crossings, UniformGrid::key({1, 1, 1}, 0));
  surface.addTo(crossings, UniformGrid::key({3, 3, 1}, 2));
  EXPECT_TRUE(crossings.empty());
  surface.addTo(crossings, UniformGrid::key({1, 1, 1}, 2));
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].at, 1.25);
  EXPECT_EQ(crossings[0].jump, -1);
}

TEST(SurfaceCrossings, OfATriangleThatTouchesAGridLineAreRefused) {
  const UniformGrid grid({0, 0, 0}, 1, {4, 4, 4});
  const std::vector<Vec3> positions{{1, 1, 0.5}, {3, 1, 0.5}, {1, 3, 0.5}};
  const std::vector<Triangle> triangles{{0, 1, 2}};
  const SurfaceCrossings surface(grid, positions, triangles, 1);
  std::vector<SurfaceCrossing> crossings;
  EXPECT_THROW(surface.addTo(crossings, UniformGrid::key({1, 1, 0}, 2)), field::GridTouches);
}

TEST(KeyIndex, NumbersKeysAsTheyArrive) {
  KeyIndex index;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const auto [number, isNew] = index.insert(i * 0x100000001u);
    EXPECT_TRUE(isNew);
    EXPECT_EQ(number, i);
  }
  EXPECT_EQ(index.insert(77 * 0x100000001u), (std::pair{77u, false}));
  EXPECT_EQ(index.find(4999 * 0x100000001u), 4999u);
  EXPECT_EQ(index.find(3), KeyIndex::kAbsent);
}

TEST(NodeField, HasTheLabelsOfDefinition2) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  const double r = 1.1;
  const ClosestPointTree tree(sheet);
  const Membership membership(sheet, tree, sheet.triangles.size(), thick(r));
  const UniformGrid grid = gridAround(sheet, r + 0.5, 0.3);
  NodeField field(grid);
  for (const GridIndex& n : allNodes(grid)) (void)field.want(UniformGrid::key(n));
  field.evaluate(membership, {}, 2);
  std::uint32_t number = 0, inside = 0;
  for (const GridIndex& n : allNodes(grid)) {
    const Vec3 p = grid.node(n);
    const NodeField::Sample& sample = field[number++];
    EXPECT_EQ(sample.inside(), insideThickened(p, *tree.closest(p), r)) << p.transpose();
    inside += sample.inside();
  }
  EXPECT_GT(inside, 1000u);
}

// S with a wall of triangles along its rim: the closest point of the whole, as one tree of the whole has it.
TEST(Membership, AnswersAsOneTreeOfTheCarrier) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  const double r = 1.1;
  TriangleMesh carrier = sheet;
  for (const mesh::RimEdge& e : rimOf(sheet.positions.size(), sheet.triangles).edges) {
    const auto low = static_cast<VertexId>(carrier.positions.size());
    const Vec3 middle = (sheet.positions[e.from] + sheet.positions[e.to]) / 2;
    carrier.positions.push_back(middle - Vec3(0.1, 0.05, 0.8));
    carrier.triangles.push_back({e.to, e.from, low});
  }
  const ClosestPointTree tree(sheet), whole(carrier);
  const Membership membership(carrier, tree, sheet.triangles.size(), thick(r));
  const UniformGrid grid = gridAround(sheet, r + 0.5, 0.3);
  std::size_t onWall = 0;
  for (const GridIndex& n : allNodes(grid)) {
    const Vec3 p = grid.node(n);
    const ClosestPoint c = *whole.closest(p);
    const Probe probe = membership.probe(p);
    EXPECT_EQ(probe.carrierDistance, c.distance);
    EXPECT_EQ(probe.distance, tree.closest(p)->distance);
    if (c.onRim) continue;
    const bool behind = (p - c.point).dot(c.pseudonormal) < 0;
    EXPECT_EQ(probe.standing == Standing::kFront || probe.standing == Standing::kRim, !behind)
        << p.transpose();
    onWall += c.triangle >= sheet.triangles.size();
  }
  EXPECT_GT(onWall, 100u);
}

// A piece of the upper sheet's shell, between sheets that face each other: what begins before it is the lower
// sheet's material, or nothing.
TEST(Membership, SeesAnotherSheetsMaterialBeforeAPieceOfShell) {
  const double r = 1;
  for (const double gap : {1.5, 2.2}) {
    TriangleMesh sheets =
        shapes::together(shapes::flatSheet(10, 8, 0), shapes::reversed(shapes::flatSheet(10, 8, -gap)));
    TriangleMesh carrier = sheets;
    const auto first = static_cast<VertexId>(carrier.positions.size());
    for (const auto& [x, y] : {std::pair{3, 3}, {7, 3}, {5, 6}}) carrier.positions.emplace_back(x, y, -r);
    carrier.triangles.push_back({first, first + 2, first + 1});  // faces down, away from its sheet
    const ClosestPointTree tree(sheets);
    const auto standingWith = [&](Region region) {
      std::vector<Region> regions(carrier.triangles.size(), Region::kOriginal);
      regions.back() = region;
      return Membership(carrier, tree, sheets.triangles.size(), thick(r), regions)
          .probe({5, 4, -r - 0.05})
          .standing;
    };
    EXPECT_EQ(standingWith(Region::kWall), Standing::kRim);
    EXPECT_EQ(standingWith(Region::kShell), gap < 2 * r ? Standing::kInside : Standing::kFar) << gap;
  }
}

// A piece of shell that is far from the thickness ends the material of the sheet that it belongs to all the
// same: no second layer begins before it, nor a void behind it.
TEST(Membership, EndsMaterialAtAPieceOfItsOwnShellHoweverDeep) {
  const double r = 1;
  const TriangleMesh sheet = shapes::flatSheet(10, 8, 0);
  const ClosestPointTree tree(sheet);
  for (const double depth : {0.4, 1.5}) {
    TriangleMesh carrier = sheet;
    const auto first = static_cast<VertexId>(carrier.positions.size());
    for (const auto& [x, y] : {std::pair{3, 3}, {7, 3}, {5, 6}}) carrier.positions.emplace_back(x, y, -depth);
    carrier.triangles.push_back({first, first + 2, first + 1});
    std::vector<Region> regions(carrier.triangles.size(), Region::kOriginal);
    regions.back() = Region::kShell;
    const auto standing = [&](double z, std::span<const std::uint8_t> covered) {
      return Membership(carrier, tree, sheet.triangles.size(), thick(r), regions, covered)
          .probe({5.1, 4.2, z})
          .standing;
    };
    const std::vector<std::uint8_t> all(sheet.triangles.size(), 1);
    EXPECT_EQ(standing(-depth + 0.05, all), Standing::kInside);
    EXPECT_EQ(standing(-depth - 0.05, all), Standing::kFar);
    // Another sheet's piece ends nothing of this one's.
    EXPECT_EQ(standing(-depth + 0.05, {}), depth < r ? Standing::kInside : Standing::kFar);
    EXPECT_EQ(standing(-depth - 0.05, {}), depth < r ? Standing::kInside : Standing::kFar);
  }
}

// What is forgotten is at least what changes.
TEST(NodeField, ForgetsWhatATriangleMayHaveChanged) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  const double r = 1.1;
  TriangleMesh more = sheet;
  const auto first = static_cast<VertexId>(more.positions.size());
  more.positions.insert(more.positions.end(), {{1, 1, -0.6}, {3, 1, -0.6}, {1, 3, -0.6}});
  more.triangles.push_back({first, first + 1, first + 2});
  const ClosestPointTree tree(sheet);
  const Membership before(sheet, tree, sheet.triangles.size(), thick(r));
  const Membership after(more, tree, sheet.triangles.size(), thick(r));
  const UniformGrid grid = gridAround(sheet, r + 0.5, 0.3);
  NodeField field(grid);
  for (const GridIndex& n : allNodes(grid)) (void)field.want(UniformGrid::key(n));
  field.evaluate(before, {}, 2);
  TriangleMesh added{more.positions, {more.triangles.back()}};
  field.forget(ClosestPointTree(added), {}, {}, 2);
  std::size_t forgotten = 0, changed = 0;
  std::uint32_t number = 0;
  for (const GridIndex& n : allNodes(grid)) {
    const NodeField::Sample& sample = field[number++];
    const Probe now = after.probe(grid.node(n));
    const bool known = sample.state == NodeField::State::kKnown;
    forgotten += !known;
    changed += now.standing != sample.standing;
    if (known) {
      EXPECT_EQ(now.standing, sample.standing);
    }
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(forgotten, field.size() / 4);
}

TEST(NodeField, ForgetsWhatIsNextToAMarkedTriangle) {
  const TriangleMesh sheet = shapes::sheet(10, 8);
  const ClosestPointTree tree(sheet), farAway(shapes::flatSheet(1, 1, 100));
  const UniformGrid grid = gridAround(sheet, 1.5, 0.3);
  NodeField field(grid);
  for (const GridIndex& n : allNodes(grid)) (void)field.want(UniformGrid::key(n));
  field.evaluate(Membership(sheet, tree, sheet.triangles.size(), thick(1)), {}, 2);
  std::vector<std::uint8_t> marked(sheet.triangles.size(), 0);
  marked[7] = 1;
  field.forget(farAway, marked, {}, 2);
  std::size_t forgotten = 0;
  for (std::uint32_t i = 0; i < field.size(); ++i) {
    EXPECT_EQ(field[i].state == NodeField::State::kUnknown, field[i].closest == 7);
    forgotten += field[i].closest == 7;
  }
  EXPECT_GT(forgotten, 0u);
}

class FollowContour : public ::testing::Test {
 protected:
  FollowContour() {
    for (const contour::RimWay& way :
         contour::rimWays(grid_, sheet_.positions, rimOf(sheet_.positions.size(), sheet_.triangles)))
      for (const contour::RimVisit& visit : way) rimCells_.push_back(visit.cell);
  }

  [[nodiscard]] std::vector<contour::Crossing> follow(NodeField& field, int threads) const {
    const auto placing = [&](const EdgePart& part) {
      return contour::placed(part, grid_, field, membership_);
    };
    return contour::followContour(grid_, rimCells_, {}, crossed_, membership_, field, placing, {}, threads);
  }

  const TriangleMesh sheet_ = shapes::sheet(10, 8);
  const double r_ = 1.1;
  const ClosestPointTree tree_{sheet_};
  const Membership membership_{sheet_, tree_, sheet_.triangles.size(), thick(r_)};
  const UniformGrid grid_ = gridAround(sheet_, r_ + 0.5, 0.3);
  const SurfaceCrossings surface_{grid_, sheet_.positions, sheet_.triangles, 2};
  const SurfaceCrossings nothing_{grid_, sheet_.positions, {}, 1};
  const field::CarrierCrossings crossed_{surface_, nothing_};
  std::vector<GridIndex> rimCells_;
};

// Followed from the rim, an open sheet's contour is all that a search of the whole grid finds.
TEST_F(FollowContour, FindsWhatASearchOfEveryEdgeFinds) {
  NodeField field(grid_);
  const auto found = follow(field, 2);
  NodeField whole(grid_);
  for (const GridIndex& n : allNodes(grid_)) (void)whole.want(UniformGrid::key(n));
  whole.evaluate(membership_, {}, 2);
  std::size_t expected = 0;
  for (const GridIndex& n : allNodes(grid_))
    for (int axis = 0; axis < 3; ++axis) {
      GridIndex up = n;
      if (++up[axis] >= grid_.cells()[axis]) continue;
      std::vector<EdgePart> here;
      const std::uint64_t edge = UniformGrid::key(n, axis);
      contour::crossEdge(grid_, whole, edge, whole.want(UniformGrid::key(n)),
                         whole.want(UniformGrid::key(up)), crossed_.of(edge), here);
      expected += here.size();
    }
  EXPECT_GT(expected, 500u);
  EXPECT_EQ(found.size(), expected);
  EXPECT_LT(field.size(), whole.size() / 2);
}

TEST_F(FollowContour, FindsTheSameWhereTheFieldDropsItsNodes) {
  NodeField all(grid_);
  const auto expected = follow(all, 1);
  for (const std::size_t most : {1, 100, 1000})
    for (const int threads : {1, 2}) {
      NodeField few(grid_, most);
      const auto found = follow(few, threads);
      ASSERT_EQ(found.size(), expected.size()) << most;
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].edge, expected[i].edge);
        EXPECT_EQ(found[i].at, expected[i].at);
        EXPECT_EQ(found[i].normal, expected[i].normal);
      }
      EXPECT_EQ(few.size(), 0u);
      EXPECT_GT(few.nodes(), all.nodes());
    }
}

}  // namespace
}  // namespace thicken
