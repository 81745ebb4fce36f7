// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/collapse.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/clear_fans.h"
#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "measure/error_bound.h"
#include "mesh/float_lattice.h"

namespace thicken::simplify {

using mesh::Bounds;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Share of the volume of a part that it keeps at least. Parts thinner than the error that is allowed, such as
// cavities, could turn inside out.
constexpr double kLeastVolume = 0.5;

// Triangles around a vertex, at most: more make exact tests slow and needles likely.
constexpr std::size_t kMostAround = 24;

bool has(const Triangle& t, VertexId v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

Bounds boundsOf(const std::array<Vec3, 3>& corner) {
  Bounds b;
  for (const Vec3& p : corner) b.add(p);
  return b;
}

}  // namespace

double aspectOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double twiceArea = (b - a).cross(c - a).norm();
  return twiceArea > 0 ? longest2 / twiceArea : kInfinite;
}

Collapse::Collapse(const job::Job& job, TriangleMesh& mesh, mesh::LinkedMesh& links,
                   std::span<const Region> region, const ShellDefinition& definition, ShellTargets& targets,
                   const Vec3& center, const Limits& limits)
    : job_(job),
      alone_{job.surface, job.tree, job.thickness, job.options, silent_, 1, job.watch},
      mesh_(mesh),
      links_(links),
      region_(region),
      fixed_(job.surface.positions.size()),
      definition_(definition),
      targets_(targets),
      center_(center),
      limits_(limits),
      boxes_(mesh.positions, mesh.triangles, job.threads),
      age_(mesh.positions.size(), 0) {
  countCreases();
  const mesh::Components parts = mesh::componentsOf(mesh.positions.size(), mesh.triangles, job.threads);
  part_ = parts.ofTriangle;
  apex_.assign(parts.count, Vec3::Zero());
  for (TriangleId t = 0; t < part_.size(); ++t) apex_[part_[t]] = mesh.positions[mesh.triangles[t][0]];
  volume_.assign(parts.count, 0);
  for (TriangleId t = 0; t < part_.size(); ++t) volume_[part_[t]] += volumeBelow(part_[t], mesh.triangles[t]);
  leastVolume_ = volume_;
  for (double& least : leastVolume_) least *= kLeastVolume;
}

// Six times that between a triangle and a place on its part. From farther away the volume of a crumb would be
// no more than rounding.
double Collapse::volumeBelow(std::uint32_t part, const Triangle& t) const {
  const auto [p, q, s] = cornersOf(t);
  const Vec3& apex = apex_[part];
  return (p - apex).dot((q - apex).cross(s - apex));
}

void Collapse::countCreases() {
  creases_.assign(mesh_.positions.size(), 0);
  for (TriangleId t = 0; t < mesh_.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (region_[links_.neighbour(t, k)] != region_[t]) {
        std::uint8_t& count = creases_[mesh_.triangles[t][k]];  // each end once, from one of the sides
        count = static_cast<std::uint8_t>(std::min(count + 1, 3));
      }
}

// Block after block, so that what is looked at is in the processor's caches; then what is between the blocks,
// and what could not be collapsed before others were.
void Collapse::run() {
  constexpr std::size_t kBlock = 8192;  // triangles
  const std::vector<TriangleId> order = boxes_.order();
  block_.assign(mesh_.positions.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (const VertexId v : mesh_.triangles[order[i]]) block_[v] = static_cast<std::uint32_t>(i / kBlock);
  for (std::size_t begin = 0; begin < order.size(); begin += kBlock)
    collapseAmong(std::span(order).subspan(begin, std::min(kBlock, order.size() - begin)));
  std::ranges::fill(block_, 0);
  collapseAmong(order);
  turnCaps();
}

void Collapse::collapseAmong(std::span<const TriangleId> triangles) {
  for (const TriangleId t : triangles) {
    if (links_.isGone(t)) continue;
    for (int k = 0; k < 3; ++k) {
      const VertexId a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
      if (a < b) push(a, b, t, links_.neighbour(t, k));
    }
  }
  constexpr std::size_t kBetweenChecks = 256;
  for (std::size_t i = 0;; ++i) {
    if (i % kBetweenChecks == 0) {
      job_.context.throwIfCancelled();
      job_.context.count();
    }
    const std::optional<EdgeQueue::Entry> next = queue_.pop();
    if (!next) return;
    if (age_[next->a] == next->ageOfA && age_[next->b] == next->ageOfB) tryEdge(next->a, next->b);
  }
}

// Of two ends that both may go, either may: S and the ends of creases stay, and others stay on their crease.
bool Collapse::isRemovable(VertexId v, bool alongCrease) const {
  return v >= fixed_ && (creases_[v] == 0 || (creases_[v] == 2 && alongCrease));
}

// Lengths decide where planes do not: short edges first. Edges as long as they are apart count as much as a
// tenth of the error that is allowed.
double Collapse::costOf(double quadric, double length2) const {
  const double share = 0.1 * limits_.error / job_.thickness.least();
  return quadric + share * share * length2 * length2;
}

void Collapse::push(VertexId a, VertexId b, TriangleId left, TriangleId right) {
  if (block_[a] != block_[b] || (!targets_.isDense[left] && !targets_.isDense[right])) return;
  const bool alongCrease = region_[left] != region_[right];
  const bool aMay = isRemovable(a, alongCrease), bMay = isRemovable(b, alongCrease);
  if (!aMay && !bMay) return;
  Quadric q = targets_.quadric[a];
  q += targets_.quadric[b];
  const Vec3 &pa = mesh_.positions[a], &pb = mesh_.positions[b];
  double least = kInfinite;
  if (bMay) least = std::min(least, q.at(pa - center_));
  if (aMay) least = std::min(least, q.at(pb - center_));
  if (aMay && bMay && !alongCrease) least = std::min(least, q.at(q.leastNear((pa + pb) / 2 - center_)));
  // Planes that are passed at this distance, in the mean, are not followed.
  constexpr double kHopeless = 2;
  const double far = kHopeless * limits_.error;
  if (least > far * far * q.weight) return;
  const VertexId low = std::min(a, b), high = std::max(a, b);
  queue_.push(costOf(least, (pa - pb).squaredNorm()), {low, high, age_[low], age_[high]});
}

void Collapse::pushAround(VertexId v) {
  links_.starOf(v, starA_);
  for (const TriangleId t : starA_) {
    const int k = links_.cornerOf(t, v);
    push(v, mesh_.triangles[t][(k + 1) % 3], t, links_.neighbour(t, k));
  }
}

bool Collapse::tryEdge(VertexId a, VertexId b) {
  edge_ = {a, b};
  links_.starOf(a, starA_);
  links_.starOf(b, starB_);
  if (starA_.size() + starB_.size() > kMostAround + 4) return false;
  if (!links_.canCollapse(a, b, starA_, starB_)) return false;
  gatherNone();
  for (const TriangleId t : starA_) gather(t, has(mesh_.triangles[t], b));
  for (const TriangleId t : starB_)
    if (!has(mesh_.triangles[t], a)) gather(t, false);
  const bool alongCrease = region_[gone_[0]] != region_[gone_[1]];
  const bool aMay = isRemovable(a, alongCrease), bMay = isRemovable(b, alongCrease);
  const Vec3 pa = mesh_.positions[a], pb = mesh_.positions[b];
  Quadric q = targets_.quadric[a];
  q += targets_.quadric[b];
  if (aMay && bMay && !alongCrease && !anyLoose_) {
    const Vec3 least = mesh::roundToFloat(center_ + q.leastNear((pa + pb) / 2 - center_));
    if (tryAt(a, b, least, true)) return true;
  }
  const bool bFirst = !aMay || (bMay && q.at(pa - center_) <= q.at(pb - center_));  // b goes
  if (bFirst && bMay && tryAt(a, b, pa, false)) return true;
  if (aMay && tryAt(b, a, pb, false)) return true;
  return !bFirst && bMay && tryAt(a, b, pa, false);
}

void Collapse::gatherNone() {
  changed_.clear();
  gone_.clear();
  facing_ = {Vec3::Zero(), Vec3::Zero()};
  oldAspect_ = volumeBefore_ = 0;
  anyLoose_ = false;
  allLoose_ = true;
}

void Collapse::gather(TriangleId t, bool goes) {
  const auto [p, q, s] = cornersOf(mesh_.triangles[t]);
  const Vec3 normal = (q - p).cross(s - p);
  oldAspect_ = std::max(oldAspect_, aspectOf(p, q, s));
  volumeBefore_ += volumeBelow(part_[t], mesh_.triangles[t]);
  anyLoose_ |= targets_.isLoose[t] != 0;
  allLoose_ &= targets_.isLoose[t] != 0;  // walls always are
  facing_[region_[t] == Region::kWall] += normal;
  if (goes)
    gone_.push_back(t);
  else
    changed_.push_back({t, mesh_.triangles[t], normal, false});
}

bool Collapse::tryAt(VertexId keep, VertexId go, const Vec3& place, bool isNew) {
  for (Changed& c : changed_) {
    c.corners = mesh_.triangles[c.id];
    for (VertexId& v : c.corners)
      if (v == go) v = keep;
  }
  const Vec3 old = std::exchange(mesh_.positions[keep], place);
  if (areRight(keep, isNew)) {
    apply(keep, go);
    return true;
  }
  mesh_.positions[keep] = old;
  return false;
}

bool Collapse::areRight(VertexId keep, bool isNew) {
  return areWellShaped() && keepsVolume() && coverTargets() && followDefinition(keep, isNew) &&
         areClear(keep) && areProved();
}

// No triangle turns by more than some 70 degrees, is without area, or is a needle among others that are none.
// The normal of a needle says little: one that turns may face as all of them did together.
bool Collapse::areWellShaped() const {
  constexpr double kTurn = 0.3;
  const double most = std::max(kNeedle, oldAspect_);
  for (const Changed& c : changed_) {
    const auto [p, q, s] = cornersOf(c.corners);
    const Vec3 normal = (q - p).cross(s - p);
    const Vec3& facing = facing_[region_[c.id] == Region::kWall];
    if (!(normal.dot(c.normal) > kTurn * normal.norm() * c.normal.norm() ||
          normal.dot(facing) > kTurn * normal.norm() * facing.norm()))
      return false;
    if (aspectOf(p, q, s) > most || exact::collinear(p, q, s)) return false;
  }
  return true;
}

bool Collapse::keepsVolume() {
  const std::uint32_t part = part_[changed_[0].id];
  change_ = -volumeBefore_;
  for (const Changed& c : changed_) change_ += volumeBelow(part, c.corners);
  const double volume = volume_[part] + change_, least = leastVolume_[part];
  return least > 0 ? volume >= least : volume <= least;
}

// Every target is near a triangle that takes the place of its own.
bool Collapse::coverTargets() {
  moves_.clear();
  farthest_ = 0;
  prepared_.clear();
  for (const Changed& c : changed_) prepared_.emplace_back(cornersOf(c.corners), c.corners);
  const auto cover = [&](TriangleId t, std::size_t guess) {
    for (std::uint32_t i = targets_.first[t]; i != ShellTargets::kEnd; i = targets_.targets[i].next) {
      const double most2 = double(targets_.targets[i].most) * targets_.targets[i].most;
      double least = kInfinite;
      std::size_t at = 0;
      for (std::size_t k = 0; k < prepared_.size(); ++k) {
        const std::size_t j = guess + k < prepared_.size() ? guess + k : guess + k - prepared_.size();
        const bvh::TriangleClosest c =
            bvh::closestOnTriangle(targets_.targets[i].at, prepared_[j], std::min(least, most2));
        if (c.squaredDistance >= least) continue;
        least = c.squaredDistance;
        at = j;
        if (c.feature == Feature::kFace && least <= most2) break;  // straight above it
      }
      guess = at;
      if (!(least <= most2)) return false;
      farthest_ = std::max(farthest_, least);
      moves_.push_back({i, static_cast<std::uint32_t>(at)});
    }
    return true;
  };
  // What lost its triangle is the most likely to be left alone.
  for (const TriangleId t : gone_)
    if (!cover(t, 0)) return false;
  for (std::size_t j = 0; j < changed_.size(); ++j)
    if (!cover(changed_[j].id, j)) return false;
  return true;
}

// The error at the new vertex and in the middles of the new triangles; what is between them, targets hold.
// Only where none of what was there follows the definition, and beside walls, is what comes held by targets
// alone.
bool Collapse::followDefinition(VertexId keep, bool isNew) {
  if (isNew) {
    const auto place = definition_.at(mesh_.positions[keep]);
    if (std::abs(place.error) > limits_.error || place.isLoose) return false;
  }
  for (Changed& c : changed_) {
    c.isLoose = true;
    if (region_[c.id] == Region::kWall) continue;
    const auto [p, q, s] = cornersOf(c.corners);
    c.isLoose = allLoose_;
    if (!isLookedAt({p, q, s}, job_.thickness.least())) continue;
    const auto place = definition_.at((p + q + s) / 3);
    const bool isOff = !place.isWall && (place.isLoose || std::abs(place.error) > limits_.error);
    if (place.isWall ? !anyLoose_ : isOff && !allLoose_) return false;
    c.isLoose = place.isWall || isOff;
  }
  return true;
}

// Exact: no two of the new triangles meet, nor one of them another.
bool Collapse::areClear(VertexId keep) {
  bounds_.clear();
  Bounds all;
  for (const Changed& c : changed_) {
    bounds_.push_back(boundsOf(cornersOf(c.corners)));
    all.add(bounds_.back());
  }
  fan_.clear();
  for (const Changed& c : changed_) fan_.push_back(c.corners);
  if (!exact::isClearFan(mesh_.positions, keep, fan_))
    for (std::size_t i = 0; i < changed_.size(); ++i)
      for (std::size_t j = i + 1; j < changed_.size(); ++j)
        if (exact::meet(mesh_.positions, fan_[i], fan_[j])) return false;
  boxes_.near(all.low, all.high, near_);
  for (const TriangleId t : near_) {
    if (std::ranges::find(gone_, t) != gone_.end()) continue;
    if (std::ranges::any_of(changed_, [t](const Changed& c) { return c.id == t; })) continue;
    const Bounds own = boundsOf(cornersOf(mesh_.triangles[t]));
    for (std::size_t i = 0; i < changed_.size(); ++i)
      if (bounds_[i].overlaps(own) && exact::meet(mesh_.positions, changed_[i].corners, mesh_.triangles[t]))
        return false;
  }
  return true;
}

bool Collapse::areProved() const {
  if (!limits_.proved) return true;
  TriangleMesh part;
  for (const Changed& c : changed_) {
    if (region_[c.id] != Region::kShell) continue;
    const auto first = static_cast<VertexId>(part.positions.size());
    for (const VertexId v : c.corners) part.positions.push_back(mesh_.positions[v]);
    part.triangles.push_back({first, first + 1, first + 2});
  }
  const std::vector<Region> shell(part.triangles.size(), Region::kShell);
  return measure::shellBeyond(alone_, part, shell, *limits_.proved).empty();
}

void Collapse::apply(VertexId keep, VertexId go) {
  links_.collapse(keep, go, go == edge_[0] ? starA_ : starB_);
  boxes_.drop(gone_);
  take();
  targets_.quadric[keep] += targets_.quadric[go];
  ++age_[keep];
  ++age_[go];
  pushAround(keep);
}

void Collapse::take() {
  for (const TriangleId t : gone_) targets_.first[t] = ShellTargets::kEnd;
  std::vector<TriangleId> moved;
  for (const Changed& c : changed_) {
    targets_.first[c.id] = ShellTargets::kEnd;
    targets_.isLoose[c.id] = c.isLoose;
    moved.push_back(c.id);
  }
  for (const Move& m : moves_) {
    std::uint32_t& first = targets_.first[changed_[m.to].id];
    targets_.targets[m.target].next = std::exchange(first, m.target);
  }
  volume_[part_[moved[0]]] += change_;
  largest_ = std::max(largest_, std::sqrt(farthest_));
  boxes_.refit(mesh_.positions, mesh_.triangles, moved);
}

}  // namespace thicken::simplify
