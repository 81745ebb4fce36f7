// SPDX-License-Identifier: LGPL-2.1-or-later
#include "job/thickness.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "job/rim_profile.h"
#include "mesh/topology.h"
#include "mesh/vertex_values.h"
#include "parallel/parallel_for.h"

namespace thicken::job {

using mesh::slopeOver;

namespace {

// Lowers values until no triangle is steeper than kSteepest, lowest triangles first: what is low stays.
// Returns how many it lowered.
std::size_t flatten(const TriangleMesh& surface, std::vector<double>& r) {
  constexpr double kEnough = 1 + 1e-9;
  using Entry = std::pair<double, TriangleId>;  // least value, triangle
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto leastOf = [&](TriangleId t) {
    const auto& [a, b, c] = surface.triangles[t];
    return std::min({r[a], r[b], r[c]});
  };
  const auto steepnessOf = [&](TriangleId t) { return slopeOver(surface, surface.triangles[t], r).norm(); };
  for (TriangleId t = 0; t < surface.triangles.size(); ++t)
    if (steepnessOf(t) > kSteepest * kEnough) open.emplace(leastOf(t), t);
  if (open.empty()) return 0;
  const mesh::VertexTriangles around = mesh::vertexTriangles(surface.positions.size(), surface.triangles);
  std::vector<std::uint8_t> lowered(r.size(), 0);
  while (!open.empty()) {
    const auto [was, t] = open.top();
    open.pop();
    const double least = leastOf(t);
    if (was != least || steepnessOf(t) <= kSteepest * kEnough) continue;
    // The highest corner alone where that does, as far as it has to; else all but the lowest.
    Triangle corners = surface.triangles[t];
    std::sort(corners.begin(), corners.end(), [&](VertexId a, VertexId b) { return r[a] < r[b]; });
    const auto [low, middle, high] = corners;
    double above = std::exchange(r[high], r[middle]), below = r[middle];
    const bool highAlone = steepnessOf(t) <= kSteepest;
    for (int i = 0; highAlone && i < 60; ++i) {
      r[high] = (above + below) / 2;
      (steepnessOf(t) <= kSteepest ? below : above) = r[high];
    }
    r[high] = below;
    if (!highAlone) r[middle] = r[high] = least + (r[middle] - least) * (kSteepest / steepnessOf(t));
    for (const VertexId v : {middle, high}) {
      lowered[v] |= static_cast<std::uint8_t>(v == high || !highAlone);
      for (const TriangleId other : around.of(v)) open.emplace(leastOf(other), other);
    }
  }
  return static_cast<std::size_t>(std::count(lowered.begin(), lowered.end(), 1));
}

}  // namespace

Thickness::Thickness(const TriangleMesh& surface, std::vector<double> r)
    : least_(*std::min_element(r.begin(), r.end())), most_(*std::max_element(r.begin(), r.end())) {
  if (least_ == most_) return;
  std::vector<Vec3> slope;
  for (const Triangle& t : surface.triangles) slope.push_back(slopeOver(surface, t, r));
  field_ = std::make_shared<const Field>(Field{surface, std::move(r), std::move(slope)});
}

double Thickness::at(TriangleId t, const Vec3& p) const {
  if (!field_) return most_;
  const auto& [a, b, c] = field_->surface.triangles[t];
  const auto [low, high] = std::minmax({field_->r[a], field_->r[b], field_->r[c]});
  return std::clamp(field_->r[a] + field_->slope[t].dot(p - field_->surface.positions[a]), low, high);
}

Vec3 Thickness::slope(const ClosestPoint& c) const {
  if (!field_ || c.feature == Feature::kVertex) return Vec3::Zero();
  if (c.feature == Feature::kFace) return field_->slope[c.triangle];
  const Triangle& t = field_->surface.triangles[c.triangle];
  const Vec3 along =
      (field_->surface.positions[t[(c.corner + 1) % 3]] - field_->surface.positions[t[c.corner]])
          .stableNormalized();
  return along.dot(field_->slope[c.triangle]) * along;
}

Thickness Thickness::of(const TriangleMesh& part, std::span<const VertexId> vertex) const {
  if (!field_) return *this;
  std::vector<double> r;
  for (VertexId v = 0; v < part.positions.size(); ++v) r.push_back(field_->r[vertex[v]]);
  return {part, std::move(r)};
}

Thickness thicknessOf(const TriangleMesh& surface, const Options& options, std::span<const double> factors,
                      std::optional<ThicknessFacts>& facts, std::optional<RimFacts>& rim) {
  if (factors.empty() && !hasRimProfile(options)) return Thickness(options.thickness);
  std::vector<double> r;
  if (factors.empty()) r.assign(surface.positions.size(), options.thickness);
  for (const double factor : factors) r.push_back(options.thickness * factor);
  facts.emplace();
  for (const Triangle& t : surface.triangles)
    facts->steepest = std::max(facts->steepest, slopeOver(surface, t, r).norm());
  facts->lowered = flatten(surface, r);
  if (hasRimProfile(options))
    rim = addRimProfile(surface, options, parallel::threadCount(options.threads), r);
  Thickness thickness(surface, std::move(r));
  facts->least = thickness.least();
  facts->most = thickness.most();
  return thickness;
}

}  // namespace thicken::job
