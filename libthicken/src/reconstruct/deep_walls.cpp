// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/deep_walls.h"

#include <algorithm>

#include "exact/box_tree.h"
#include "exact/predicates.h"
#include "mesh/bounds.h"
#include "mesh/float_lattice.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::reconstruct {

using mesh::kNone;
using parallel::parallelFor;

namespace {

// A copy of the sweep that is this deep, in r, has nothing in its way.
constexpr double kFull = 0.98;
// Where a deep wall ends, in r: not beyond the shell, where the contour would have to turn around.
constexpr double kEnd = 0.9999;
// A longer way must gain this share of the distance that it would in the open.
constexpr double kKeep = 0.9;
constexpr double kStep = 1.12;
// mm of way that neighbours may differ by, per mm of rim.
constexpr double kSlope = 0.7;
constexpr int kHalvings = 4;
constexpr int kShortenings = 2;
constexpr int kMostLifts = 4;

}  // namespace

DeepWalls::DeepWalls(const job::Job& job, const sweep::SweepResult& swept)
    : job_(job),
      swept_(swept),
      lifts_(swept.mesh.positions.size(), 0),
      base_(lifts_.size(), kNone),
      way_(base_.size(), 0),
      share_(base_.size(), 0),
      at_(swept.mesh.positions) {
  listBottom();
  parallelFor(low_.size(), job_.threads, job_.context, 64, [&](std::size_t i) {
    way_[low_[i]] = deepest(low_[i], base_[low_[i]]);
    share_[low_[i]] = 1;
  });
  limitSlope();
  placeAll();
  for (int i = 0; i < kShortenings; ++i) shorten();
}

void DeepWalls::listBottom() {
  std::vector<Triangle> walls;
  for (std::size_t t = 0; t < swept_.region.size(); ++t)
    if (swept_.region[t] == Region::kWall) walls.push_back(swept_.mesh.triangles[t]);
  for (const Triangle& wall : walls)
    for (const VertexId v : wall)
      if (v >= job_.surface.positions.size() && base_[v] == kNone && swept_.base[v] != kNone) {
        base_[v] = swept_.base[v];
        low_.push_back(v);
      }
  for (const Triangle& wall : walls)
    for (int k = 0; k < 3; ++k) {
      const VertexId a = wall[k], b = wall[(k + 1) % 3];
      if (base_[a] != kNone && base_[b] != kNone) bottomEdges_.push_back({a, b});
    }
}

// Shortens walls that end deeper than the shell, at a lower vertex or half-way between two: the contour would
// have to turn around there.
void DeepWalls::shorten() {
  std::vector<std::array<VertexId, 2>> spans = bottomEdges_;
  for (const VertexId v : low_) spans.push_back({v, v});
  std::vector<double> share(spans.size(), 1);
  parallelFor(spans.size(), job_.threads, job_.context, 64, [&](std::size_t i) {
    const Vec3 middle = (at_[spans[i][0]] + at_[spans[i][1]]) / 2;
    const ClosestPoint c = *job_.tree.closest(middle);
    const double d = c.distance, end = kEnd * job_.thickness.at(c);
    if (d > end) share[i] = end / d;
  });
  std::vector<double> least(way_.size(), 1);
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (const VertexId v : spans[i]) least[v] = std::min(least[v], share[i]);
  for (const VertexId v : low_) {
    if (least[v] == 1) continue;
    way_[v] *= least[v];
    place(v);
  }
}

// How far the copy of `base` may go on in its direction and still gain distance, up to r.
double DeepWalls::deepest(VertexId low, VertexId base) const {
  const Vec3& from = job_.surface.positions[base];
  const Vec3 whole = swept_.mesh.positions[low] - from;
  const double way = whole.norm();
  const double gain = swept_.distance[low] / way, r = job_.thickness.at(base);
  if (!(way > 0)) return way;
  if (gain * way >= kFull * r) return way * kEnd * r / (gain * way);
  if (gain < 0.2) return way;
  const Vec3 direction = whole / way;
  const double end = kEnd * r / gain;
  double good = way;
  for (double next = std::min(end, way * kStep); next > good; next = std::min(end, next * kStep)) {
    const Vec3 p = from + next * direction;
    const auto c = job_.tree.closest(p);
    const bool behind = c->onRim || (p - c->point).dot(c->pseudonormal) < 0;
    if (!behind || c->distance < kKeep * gain * next) break;
    good = next;
  }
  return good;
}

void DeepWalls::limitSlope() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : bottomEdges_) {
      const double slack =
          kSlope * (job_.surface.positions[base_[a]] - job_.surface.positions[base_[b]]).norm();
      for (const auto& [low, high] : {std::pair{a, b}, std::pair{b, a}}) {
        const double most = way_[low] + slack;
        if (way_[high] <= most * (1 + 1e-9)) continue;
        way_[high] = most;
        changed = true;
      }
    }
  }
}

void DeepWalls::place(VertexId v) {
  const Vec3& from = job_.surface.positions[base_[v]];
  const Vec3& there = swept_.mesh.positions[v];
  const double way = (there - from).norm();
  at_[v] =
      share_[v] == 0 ? there : mesh::roundToFloat(there + share_[v] * (way_[v] - way) / way * (there - from));
}

void DeepWalls::placeAll() {
  for (const VertexId v : low_) place(v);
}

std::vector<Vec3> DeepWalls::up() const {
  std::vector<Vec3> up = swept_.up;
  up.resize(at_.size(), Vec3::Zero());
  for (const VertexId v : low_) up[v] = job_.surface.positions[base_[v]] - at_[v];
  return up;
}

bool DeepWalls::lift(std::span<const VertexId> vertices, double step) {
  bool any = false;
  for (const VertexId v : vertices) {
    if (v >= base_.size() || base_[v] == kNone || lifts_[v] == kMostLifts || !(way_[v] > 2 * step)) continue;
    ++lifts_[v];
    way_[v] -= step;
    any = true;
  }
  if (!any) return false;
  limitSlope();
  // The walls of kept pieces of shell stay with them.
  const std::vector<Vec3> before = at_;
  placeAll();
  return at_ != before;
}

// The walls, and all else that is kept and that they may come near at any depth. The walls come first; the
// number says how many they are.
std::pair<std::vector<Triangle>, std::size_t> DeepWalls::nearWalls(std::span<const std::uint8_t> keep) const {
  std::vector<Triangle> near, others;
  std::vector<Triangle> reach;  // of each wall, with where its lower vertices hang
  for (TriangleId t = 0; t < keep.size(); ++t) {
    // The walls are clear of S since the first fit.
    if (!keep[t] || (fitted_ && swept_.region[t] == Region::kOriginal)) continue;
    const Triangle& corners = swept_.mesh.triangles[t];
    if (swept_.region[t] != Region::kWall) {
      others.push_back(corners);
      continue;
    }
    near.push_back(corners);
    reach.push_back(corners);
    for (int k = 0; k < 3; ++k)
      if (const VertexId v = corners[k]; base_[v] != kNone)
        reach.push_back({v, base_[v], corners[(k + 1) % 3]});
  }
  const std::size_t walls = near.size();
  const exact::BoxTree tree(at_, reach, job_.threads);
  std::vector<std::uint8_t> isNear(others.size(), 0);
  parallelFor(others.size(), job_.threads, job_.context, 1024, [&](std::size_t i) {
    mesh::Bounds own;
    for (const VertexId v : others[i]) own.add(at_[v]);
    isNear[i] = !tree.near(own.low, own.high).empty();
  });
  for (std::size_t i = 0; i < others.size(); ++i)
    if (isNear[i]) near.push_back(others[i]);
  return {std::move(near), walls};
}

void DeepWalls::fit(std::span<const std::uint8_t> keep) {
  if (low_.empty()) return;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t] || swept_.region[t] != Region::kShell) continue;
    for (const VertexId v : swept_.mesh.triangles[t])
      if (base_[v] != kNone) {
        share_[v] = 0;
        place(v);
      }
  }
  // All but the walls is clear of each other since the sweep.
  const auto [triangles, walls] = nearWalls(keep);
  std::vector<std::uint8_t> fixed(triangles.size(), 1);
  std::fill_n(fixed.begin(), walls, std::uint8_t{0});
  for (int round = 0; round <= kHalvings; ++round) {
    const exact::BoxTree tree(at_, triangles, job_.threads);
    std::vector<TriangleId> bad;
    for (const auto& [a, b] : tree.meetingPairs(at_, triangles, fixed, job_.context, job_.threads)) {
      bad.push_back(a);
      bad.push_back(b);
    }
    for (TriangleId t = 0; t < walls; ++t)
      if (exact::collinear(at_[triangles[t][0]], at_[triangles[t][1]], at_[triangles[t][2]]))
        bad.push_back(t);
    if (bad.empty()) {
      fitted_ = true;
      return;
    }
    std::vector<VertexId> drawn;
    for (const TriangleId t : bad)
      for (const VertexId v : triangles[t])
        if (base_[v] != kNone && share_[v] > 0) drawn.push_back(v);
    mesh::sortUnique(drawn);
    for (const VertexId v : drawn) {
      share_[v] = round + 1 >= kHalvings ? 0 : share_[v] / 2;
      place(v);
    }
  }
  // Something still meets: all walls go back to where the sweep has them, and there nothing does.
  for (const VertexId v : low_) share_[v] = 0;
  placeAll();
}

}  // namespace thicken::reconstruct
