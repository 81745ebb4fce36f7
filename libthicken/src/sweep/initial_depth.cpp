// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/initial_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "bvh/spatial_order.h"
#include "sweep/nearby.h"

namespace thicken::sweep {

using bvh::SpatialOrder;

namespace {

// Share of its way that a copy must keep as distance from S. Below 1, since a bumpy surface bends
// towards its own offset without harm.
constexpr double kKeep = 0.85;
// Against a sheet that turns its own front or back this way the halfway surface is the limit of
// Definition 2 and the other sheet's copy comes as far.
constexpr double kKeepFacing = 1.0;
// Depths tried first. A clear ball of radius 0.85·h around depth h covers the way from
// 0.15·h to 1.85·h, so that these chain up from next to S to the whole depth.
constexpr std::array kChain = {1.0 / 512, 1.0 / 64, 1.0 / 8, 1.0};
// The order that they are tried in: what is free around the first tells most about the others.
constexpr std::array<std::size_t, kChain.size()> kTried = {3, 1, 0, 2};
constexpr int kBisections = 6;

// A copy on its way down.
struct Way {
  Copy* copy;
  double good = 0, bad = 0;  // depths that are clear and not; 0: none yet
  double next = 0;           // to be tried
  std::array<bool, kChain.size()> clear = {};
  std::array<double, kChain.size()> free = {};  // mm around each of the chain; 0: not asked for

  // The planes of the triangles around v are this far at best.
  [[nodiscard]] double reach(double depth) const {
    return depth * copy->length * std::min(1.0, copy->safety);
  }
  [[nodiscard]] bool isClear(const Vec3& p, const ClosestPoint& near) const {
    if (!std::isfinite(near.distance)) return true;
    if (near.distance < kKeep * reach(next)) return false;
    // `near` is closer than the whole way: fine where it is the same sheet, bumpy.
    return near.pseudonormal.dot(copy->offset) * (p - near.point).dot(near.pseudonormal) >= 0;
  }
  // Whether the ball of another depth that is clear holds the one around this depth.
  [[nodiscard]] bool isKnownToBeClear(double depth) const {
    for (std::size_t k = 0; k < kChain.size(); ++k)
      if (clear[k] && free[k] - std::abs(kChain[k] - depth) * copy->length >= kKeep * reach(depth))
        return true;
    return false;
  }
};

// Tries the next depth of copies that are close together; calls take(way, clear, free).
template <class Take>
void tryNext(std::span<Way> ways, const SweptMesh& mesh, const ClosestPointTree& tree, Take take) {
  std::array<ClosestPointTree::Query, SpatialOrder::kTogether> queries;
  std::array<ClosestPoint, SpatialOrder::kTogether> answers;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const Way& w = ways[k];
    queries[k].point = mesh.positions[w.copy->base] + w.next * w.copy->offset;
    queries[k].within = kKeepFacing * w.reach(w.next);
  }
  tree.closest(std::span(queries).first(ways.size()), answers);
  for (std::size_t k = 0; k < ways.size(); ++k)
    take(ways[k], ways[k].isClear(queries[k].point, answers[k]),
         std::min(queries[k].within, answers[k].distance));
}

// Moves the ways that `stays` is true of to the front, and returns them.
template <class Stays>
std::span<Way> sift(std::span<Way> ways, Stays stays) {
  return ways.first(static_cast<std::size_t>(std::partition(ways.begin(), ways.end(), stays) - ways.begin()));
}

// Tries the chain, as far as it is not known: each way is left between the last of its depths that follow on
// each other from S and are clear, and the next.
void tryChain(std::span<Way> ways, const SweptMesh& mesh, const ClosestPointTree& tree) {
  for (const std::size_t k : kTried) {
    for (Way& w : ways) w.clear[k] = w.isKnownToBeClear(kChain[k]);
    const std::span<Way> asked = sift(ways, [k](const Way& w) { return !w.clear[k]; });
    for (Way& w : asked) w.next = kChain[k];
    tryNext(asked, mesh, tree, [k](Way& w, bool clear, double free) {
      w.clear[k] = clear;
      w.free[k] = free;
    });
  }
  for (Way& w : ways)
    for (std::size_t k = 0; k < kChain.size() && w.bad == 0; ++k) (w.clear[k] ? w.good : w.bad) = kChain[k];
}

void setDepths(const std::span<Way> ways, const SweptMesh& mesh, const ClosestPointTree& tree) {
  tryChain(ways, mesh, tree);
  // Where nothing is clear the exact tests decide.
  for (Way& w : ways) w.copy->depth = w.bad == 0 ? 1 : w.bad / 8;
  const std::span<Way> open = sift(ways, [](const Way& w) { return w.bad != 0 && w.good != 0; });
  for (int i = 0; i < kBisections && !open.empty(); ++i) {
    for (Way& w : open) w.next = std::sqrt(w.good * w.bad);
    tryNext(open, mesh, tree, [](Way& w, bool clear, double) { (clear ? w.good : w.bad) = w.next; });
  }
  for (Way& w : open) w.copy->depth = w.good;
}

}  // namespace

void setInitialDepths(SweptMesh& mesh, const job::Job& job, std::span<const std::uint8_t> which) {
  const SpatialOrder order(trianglesAtCopies(mesh), job.tree, job.threads);
  order.forGroups(job.threads, job.context, [&](std::span<const std::uint32_t> copies) {
    std::array<Way, SpatialOrder::kTogether> ways;
    std::size_t count = 0;
    for (const std::uint32_t i : copies)
      if ((which.empty() || which[i]) && !mesh.copies[i].dropped) ways[count++] = {&mesh.copies[i]};
    setDepths(std::span(ways).first(count), mesh, job.tree);
  });
}

}  // namespace thicken::sweep
