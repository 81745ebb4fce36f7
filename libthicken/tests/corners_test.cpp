// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/corners.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "jobs.h"
#include "measure/offset_error.h"
#include "mesh/normals.h"
#include "mesh/topology.h"
#include "plain_shapes.h"
#include "sweep/sweep.h"
#include "thicken/thicken.h"

namespace thicken {

using measure::OffsetError;
using mesh::faceNormals;
using mesh::vertexTriangles;

namespace {

// A coarse sheet whose inner vertices have six planes each: no point is at one distance from all of them.
TriangleMesh rugged(VertexId columns, VertexId rows, unsigned seed) {
  TriangleMesh mesh = shapes::flatSheet(columns, rows, 0);
  std::mt19937 random(seed);
  for (Vec3& p : mesh.positions) p.z() = double(random() % 1000) / 1000 * 0.5;
  return mesh;
}

// The share of the shell's area, by samples, that is off by more than `most` · r.
double shareOff(const TriangleMesh& surface, double r, double most) {
  const OwnJob own(surface, r);
  const ClosestPointTree& tree = own.tree;
  const sweep::SweepResult swept = sweep::sweep(own.job);
  const auto normal = faceNormals(surface.positions, surface.triangles, 1);
  const auto around = vertexTriangles(surface.positions.size(), surface.triangles);
  const OffsetError error(own.job, normal, around, Join::kMitre);
  double off = 0, all = 0;
  for (std::size_t t = 0; t < swept.region.size(); ++t) {
    if (swept.region[t] != Region::kShell) continue;
    const auto& [a, b, c] = swept.mesh.triangles[t];
    const Vec3 &p = swept.mesh.positions[a], &q = swept.mesh.positions[b], &s = swept.mesh.positions[c];
    const double area = (q - p).cross(s - p).norm();
    const Vec3 middle = (p + q + s) / 3;
    const auto near = tree.closest(middle);
    all += area;
    if (!near->onRim && std::abs(error.at(middle, *near).mm) > most * r) off += area;
  }
  return off / all;
}

TEST(Corners, KeepCopiesOfLargeTrianglesParallelToThem) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const TriangleMesh surface = rugged(8, 8, seed);
    EXPECT_LT(shareOff(surface, 0.02, 0.01), 0.03) << "seed " << seed;
  }
}

TEST(Corners, AreClosedAndClearAtAnyThickness) {
  for (const unsigned seed : {4u, 5u, 6u})
    for (const double r : {0.01, 0.05, 0.2, 0.6}) {
      Options o;
      o.thickness = r;
      o.method = Method::kSweep;
      const TriangleMesh surface = rugged(6, 7, seed);
      const Solid solid = thicken(surface, o);  // throws where the audit finds anything
      EXPECT_LT(solid.report.triangles, 8 * surface.triangles.size()) << "seed " << seed << ", r " << r;
    }
}

TEST(Corners, AreNotMadeWhereOnePointServesAllPlanes) {
  const TriangleMesh box = shapes::box({0, 0, 0}, {1, 2, 3});
  Options o;
  o.thickness = 0.05;
  o.method = Method::kSweep;
  EXPECT_EQ(thicken(box, o).report.triangles, 2 * box.triangles.size());
}

TEST(OffsetError, CountsMitresUpToTheirLimit) {
  // Two planes at a right angle, the edge along y.
  TriangleMesh edge;
  edge.positions = {{0, 0, 0}, {0, 4, 0}, {4, 2, 0}, {0, 2, 4}};
  edge.triangles = {{0, 2, 1}, {0, 1, 3}};
  const auto normal = faceNormals(edge.positions, edge.triangles, 1);
  const auto around = vertexTriangles(edge.positions.size(), edge.triangles);
  const OwnJob own(edge, 1);
  const auto at = [&](Join join, const Vec3& p) {
    return OffsetError(own.job, normal, around, join).at(p, *own.tree.closest(p)).mm;
  };
  const Vec3 tip(-1, 2, -1), below(1.5, 2, -1), inside(-0.5, 2, -0.5), outside(-1.5, 2, -1);
  EXPECT_NEAR(at(Join::kMitre, tip), 0, 1e-12);
  EXPECT_NEAR(at(Join::kRound, tip), std::sqrt(2) - 1, 1e-12);
  for (const Join join : {Join::kMitre, Join::kRound}) {
    EXPECT_NEAR(at(join, below), 0, 1e-12);
    EXPECT_NEAR(at(join, inside), std::sqrt(0.5) - 1, 1e-12);
  }
  EXPECT_NEAR(at(Join::kMitre, outside), 0.5, 1e-12);
  EXPECT_NEAR(at(Join::kMitre, {-2, 2, -2}), 2 * std::sqrt(2) - 1, 1e-12) << "beyond the limit";
}

}  // namespace
}  // namespace thicken
