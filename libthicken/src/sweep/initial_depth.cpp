// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/initial_depth.h"

#include <algorithm>
#include <cmath>

#include "parallel_for.h"

namespace thicken {

namespace {

// Share of its way that a copy must keep as distance from S. Below 1, since a bumpy surface bends
// towards its own offset without harm.
constexpr double kKeep = 0.85;
// Against a sheet that turns its own front or back this way the halfway surface is the limit of
// Definition 2 and the other sheet's copy comes as far.
constexpr double kKeepFacing = 1.0;
// Depths tried first, ascending. A clear ball of radius 0.85·h around depth h covers the way from
// 0.15·h to 1.85·h, so that these chain up from next to S to the whole depth.
constexpr double kChain[] = {1.0 / 512, 1.0 / 64, 1.0 / 8, 1.0};
constexpr int kBisections = 6;

bool clear(const ClosestPointTree& tree, const Vec3& base, const Copy& copy, double h) {
  const Vec3 p = base + h * copy.offset;
  // The planes of the triangles around v are this far at best.
  const double reach = h * copy.length * std::min(1.0, copy.safety);
  const auto near = tree.closest(p, kKeepFacing * reach);
  if (!near) return true;
  if (near->distance < kKeep * reach) return false;
  // `near` is closer than the whole way: fine where it is the same sheet, bumpy.
  return near->pseudonormal.dot(copy.offset) * (p - near->point).dot(near->pseudonormal) >= 0;
}

double initialDepth(const ClosestPointTree& tree, const Vec3& base, const Copy& copy) {
  double good = 0, bad = 0;
  for (const double h : kChain) {
    if (!clear(tree, base, copy, h)) {
      bad = h;
      break;
    }
    good = h;
  }
  if (bad == 0) return 1;
  if (good == 0) return bad / 8;  // the exact tests decide from here on
  for (int i = 0; i < kBisections; ++i) {
    const double h = std::sqrt(good * bad);
    (clear(tree, base, copy, h) ? good : bad) = h;
  }
  return good;
}

}  // namespace

void setInitialDepths(SweptMesh& mesh, const ClosestPointTree& tree, const RunContext& context, int threads) {
  parallelFor(mesh.copies.size(), threads, context, 256, [&](std::size_t i) {
    Copy& c = mesh.copies[i];
    if (!c.dropped) c.depth = initialDepth(tree, mesh.positions[c.base], c);
  });
}

}  // namespace thicken
