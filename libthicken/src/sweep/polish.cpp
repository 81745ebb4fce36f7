// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/polish.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <span>

#include "bvh/spatial_order.h"
#include "measure/shell_samples.h"
#include "mesh/buckets.h"
#include "parallel/parallel_for.h"
#include "sweep/nearby.h"

namespace thicken::sweep {

using measure::kShellSamples;
using measure::OffsetError;
using mesh::Buckets;
using parallel::parallelFor;

namespace {

constexpr int kRounds = 4;
// Farthest that a copy is moved, as a share of r: the exact tests rely on the direction it had.
constexpr double kReach = 0.1;
// Copies of a lesser safety (SweepDirection) stay where they are.
constexpr double kSafe = 0.35;
// Share of the least-squares step that is taken: neighbours move as well.
constexpr double kStep = 0.7;
constexpr double kDamping = 0.02;
// Points of the shell nearer than this share of r are cut off by another sheet or a fold, not by the
// coarseness of the copy.
constexpr double kCutOff = 0.9;

struct Sample {
  Vec3 away = Vec3::Zero();  // gradient of the error; zero for a sample that does not count
  double excess = 0;         // mm, beyond its definition
  double thickness = 0;      // mm, there
  TriangleId nearest = 0;    // of S
};

// Whether the points of a triangle are so near their place that another look changes nothing.
bool isSettled(std::span<const Sample> samples) {
  constexpr double kSettled = 3e-4;
  return std::all_of(samples.begin(), samples.end(),
                     [&](const Sample& s) { return std::abs(s.excess) < kSettled * s.thickness; });
}

// A quadric of one copy: where the points of the shell around it would be r away.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  void add(const Sample& s, double share, double area) {
    a += area * share * share * s.away * s.away.transpose();
    b -= area * share * s.excess * s.away;
  }
  [[nodiscard]] Vec3 step() const {
    const double weight = a.trace();
    if (!(weight > 0)) return Vec3::Zero();
    const Eigen::Matrix3d damped = a + kDamping * weight * Eigen::Matrix3d::Identity();
    return damped.inverse() * b;  // which the damping makes safe
  }
};

bool isWhole(const SweptMesh& mesh, VertexId v) {
  return mesh.isCopy(v) && mesh.copyOf(v).depth == 1;
}

std::vector<TriangleId> wholeTriangles(const SweptMesh& mesh) {
  std::vector<TriangleId> ids;
  for (auto t = static_cast<TriangleId>(mesh.surfaceTriangles); t < mesh.triangles.size(); ++t) {
    const Triangle& s = mesh.triangles[t];
    if (mesh.region[t] == Region::kShell &&
        std::all_of(s.begin(), s.end(), [&](VertexId v) { return isWhole(mesh, v); }))
      ids.push_back(t);
  }
  return ids;
}

// The triangles `shell` by their copies, as 3 · place in `shell` + corner.
Buckets<std::uint32_t> cornersOfCopies(const SweptMesh& mesh, std::span<const TriangleId> shell,
                                       int threads) {
  return mesh::intoBuckets<std::uint32_t>(shell.size(), mesh.copies.size(), threads,
                                          [&](std::size_t i, const auto& put) {
                                            for (std::uint32_t corner = 0; corner < 3; ++corner)
                                              put(mesh.triangles[shell[i]][corner] - mesh.surfaceVertices,
                                                  3 * static_cast<std::uint32_t>(i) + corner);
                                          });
}

}  // namespace

void polish(SweptMesh& mesh, const job::Job& job, const OffsetError& error) {
  const RunContext& context = job.context;
  const int threads = job.threads;
  const auto shell = wholeTriangles(mesh);
  const std::size_t each = measure::shellSamplesPerTriangle(shell.size());
  std::vector<Sample> samples(each * shell.size());
  std::vector<double> area(shell.size());  // twice
  const Buckets<std::uint32_t> corners = cornersOfCopies(mesh, shell, threads);
  const std::vector<TriangleId> above = trianglesAbove(shell, mesh, threads);
  parallelFor(samples.size(), threads, context, 8192,
              [&](std::size_t i) { samples[i].nearest = above[i / each]; });
  bvh::SpatialOrder order(above, job.tree, threads);
  std::vector<Vec3> start(mesh.copies.size());
  parallelFor(start.size(), threads, context, 8192, [&](std::size_t i) { start[i] = mesh.copies[i].offset; });
  std::vector<std::uint8_t> open(shell.size(), 1);  // whether a triangle is looked at
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) {  // they stay so: their points are not looked at again
      parallelFor(shell.size(), threads, context, 4096, [&](std::size_t i) {
        open[i] = open[i] != 0 && !isSettled(std::span(samples).subspan(each * i, each));
      });
      order.eraseIf([&](std::uint32_t i) { return open[i] == 0; });
    }
    order.query<measure::kMostShellSamples>(
        job.tree, each, threads, context,
        [&](std::uint32_t i, std::size_t k, ClosestPointTree::Query& query) {
          const Triangle& t = mesh.triangles[shell[i]];
          const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
          if (k == 0) area[i] = (b - a).cross(c - a).norm();
          const auto& w = kShellSamples[k];
          query.point = w[0] * a + w[1] * b + w[2] * c;
          query.hint = samples[each * i + k].nearest;
          return true;
        },
        [&](std::uint32_t i, std::size_t k, const Vec3& p, const ClosestPoint& c) {
          const double r = job.thickness.at(c);
          const bool counts = !c.onRim && c.distance > kCutOff * r;
          const OffsetError::Error off = error.at(p, c);
          samples[each * i + k] = {counts ? off.gradient : Vec3(Vec3::Zero()), off.mm, r, c.triangle};
        });
    // Each copy sums up in the order of the triangles, so that its place does not depend on the threads.
    parallelFor(mesh.copies.size(), threads, context, 1024, [&](std::size_t i) {
      Copy& c = mesh.copies[i];
      if (c.depth != 1 || c.dropped || c.exact || c.safety < kSafe) return;
      const auto around =
          std::span(corners.values).subspan(corners.offset[i], corners.offset[i + 1] - corners.offset[i]);
      if (std::ranges::none_of(around, [&](std::uint32_t corner) { return open[corner / 3] != 0; })) return;
      Quadric quadric;
      for (const std::uint32_t at : around) {
        const std::size_t triangle = at / 3, corner = at % 3;
        for (std::size_t k = 0; k < each; ++k)
          quadric.add(samples[each * triangle + k], kShellSamples[k][corner], area[triangle]);
      }
      const Vec3 moved = c.offset + kStep * quadric.step() - start[i];
      const double reach = kReach * job.thickness.at(c.base);
      c.offset = start[i] + moved * std::min(1.0, reach / std::max(moved.norm(), reach * 1e-9));
      c.length = c.offset.norm();
      mesh.place(i);
    });
  }
}

}  // namespace thicken::sweep
