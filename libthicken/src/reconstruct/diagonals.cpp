// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/diagonals.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "parallel/parallel_for.h"

namespace thicken::reconstruct {

using contour::Crossing;

namespace {

// Seen along the normal: whether the corners 1 and 3 lie on either side of the first diagonal, 0 and 2 of the
// second, and how high above the tangent plane each is where they cross.
struct Diagonals {
  std::array<bool, 2> divides{};
  std::array<double, 2> height{};
};

Diagonals measured(const std::array<Vec3, 4>& q, const Crossing& crossing) {
  const Vec3 &n = crossing.normal, first = q[2] - q[0], second = q[3] - q[1], between = q[1] - q[0];
  const double det = n.dot(first.cross(second));
  if (det == 0) return {};
  const double onFirst = n.dot(between.cross(second)) / det, onSecond = n.dot(between.cross(first)) / det;
  const auto within = [](double x) { return x > 0 && x < 1; };
  return {{within(onSecond), within(onFirst)},
          {std::abs(n.dot(q[0] + onFirst * first - crossing.at)),
           std::abs(n.dot(q[1] + onSecond * second - crossing.at))}};
}

bool secondIsBetter(const Diagonals& d) {
  return d.divides[1] && (!d.divides[0] || d.height[1] < d.height[0]);
}

}  // namespace

void chooseDiagonals(Assembly& assembly, const contour::DualSurface& dual,
                     std::span<const Crossing> crossings, std::span<const Vec3> target,
                     const RunContext& context, int threads) {
  const std::vector<std::uint32_t>& of = assembly.crossing;
  const auto at = [&](VertexId v) -> const Vec3& { return target[v - assembly.carrierVertices]; };
  parallel::parallelFor(of.size(), threads, context, 512, [&](std::size_t i) {
    if (of[i] == Assembly::kStrip || !dual.isQuad(of[i]) || i == 0 || of[i - 1] != of[i]) return;
    Triangle& a = assembly.mesh.triangles[assembly.carrierTriangles + i - 1];
    Triangle& b = assembly.mesh.triangles[assembly.carrierTriangles + i];
    const std::array<VertexId, 4> q{a[0], a[1], a[2], b[2]};
    if (!secondIsBetter(measured({at(q[0]), at(q[1]), at(q[2]), at(q[3])}, crossings[of[i]]))) return;
    a = {q[1], q[2], q[3]};
    b = {q[1], q[3], q[0]};
  });
}

}  // namespace thicken::reconstruct
