// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/membership.h"

#include <cmath>
#include <limits>
#include <vector>

namespace thicken::field {

namespace {

// That a piece of shell may be off by, in r, twice what one is kept with (shell_plan.h): the space between it
// and the thickness is neither material before it nor a void behind it, where a contour would be a second
// layer. docs/limits.md tells what that means for the solid.
constexpr double kOff = 0.02;

bool behind(const Vec3& p, const ClosestPoint& c) {
  return (p - c.point).dot(c.pseudonormal) < 0;
}

// The carrier's triangles from `from` on, after those of the surface that share a vertex with them: so the
// normals of shared vertices and edges are the carrier's. Orders are kept.
TriangleMesh beyondSurface(const TriangleMesh& carrier, std::size_t from, std::size_t& shared) {
  std::vector<std::uint8_t> isBeyond(carrier.positions.size(), 0);
  for (std::size_t t = from; t < carrier.triangles.size(); ++t)
    for (const VertexId v : carrier.triangles[t]) isBeyond[v] = 1;
  TriangleMesh beyond;
  for (std::size_t t = 0; t < from; ++t) {
    const auto& [a, b, c] = carrier.triangles[t];
    if (isBeyond[a] || isBeyond[b] || isBeyond[c]) beyond.triangles.push_back(carrier.triangles[t]);
  }
  shared = beyond.triangles.size();
  beyond.triangles.insert(beyond.triangles.end(),
                          carrier.triangles.begin() + static_cast<std::ptrdiff_t>(from),
                          carrier.triangles.end());
  constexpr VertexId kUnused = std::numeric_limits<VertexId>::max();
  std::vector<VertexId> to(carrier.positions.size(), kUnused);
  for (const Triangle& t : beyond.triangles)
    for (const VertexId v : t) to[v] = 0;
  for (std::size_t v = 0; v < to.size(); ++v) {
    if (to[v] == kUnused) continue;
    to[v] = static_cast<VertexId>(beyond.positions.size());
    beyond.positions.push_back(carrier.positions[v]);
  }
  for (Triangle& t : beyond.triangles)
    for (VertexId& v : t) v = to[v];
  return beyond;
}

}  // namespace

Membership::Membership(const TriangleMesh& carrier, const ClosestPointTree& surface,
                       std::size_t surfaceTriangles, const job::Thickness& thickness,
                       std::span<const Region> region, std::span<const std::uint8_t> covered, int threads)
    : surface_(surface),
      covered_(covered),
      beyond_(beyondSurface(carrier, surfaceTriangles, atRim_), threads),
      thickness_(thickness) {
  if (!region.empty())
    region_.assign(region.begin() + static_cast<std::ptrdiff_t>(surfaceTriangles), region.end());
}

bool Membership::isShell(TriangleId beyond) const {
  return !region_.empty() && beyond >= atRim_ && region_[beyond - atRim_] == Region::kShell;
}

bool Membership::isCovered(TriangleId onSurface) const {
  return !covered_.empty() && covered_[onSurface] != 0;
}

// Before a wall is the cross-section. Before a piece of shell nothing is behind the sheet that it belongs to,
// but another sheet may be so near that this is in its material, if that does not end at a piece of its own.
Standing Membership::beforeCarrier(const Vec3& p, const ClosestPoint& onSurface, TriangleId beyond) const {
  if (!isShell(beyond)) return Standing::kRim;
  const bool inside = !onSurface.onRim && !isCovered(onSurface.triangle) &&
                      onSurface.distance < (1 - kOff) * thickness_.at(onSurface) && behind(p, onSurface);
  return inside ? Standing::kInside : Standing::kFar;
}

Probe Membership::probe(const Vec3& p) const {
  const ClosestPoint c = *surface_.closest(p);
  ClosestPoint onCarrier = c;
  bool onSurface = true;
  const double asNear = std::nextafter(c.distance, std::numeric_limits<double>::infinity());
  if (const auto beyond = beyond_.closest(p, asNear); beyond && (c.onRim || beyond->distance < c.distance)) {
    onCarrier = *beyond;
    onSurface = beyond->triangle < atRim_;
  }
  Probe result;
  result.distance = c.distance;
  result.carrierDistance = onCarrier.distance;
  result.closest = c.point;
  result.triangle = c.triangle;
  const double r = thickness_.at(c);
  result.thickness = r;
  result.slope = thickness_.slope(c);
  result.excess = c.distance - r;
  const bool far = c.distance > r;
  if (onCarrier.onRim)
    result.standing = c.onRim         ? Standing::kRim
                      : !behind(p, c) ? Standing::kFront
                      : far           ? Standing::kFar
                                      : Standing::kInside;
  else if (!behind(p, onCarrier))
    result.standing = onSurface ? Standing::kFront : beforeCarrier(p, c, onCarrier.triangle);
  else if (!onSurface && isShell(onCarrier.triangle))
    result.standing =
        c.distance > (1 + kOff) * r && !isCovered(c.triangle) ? Standing::kFar : Standing::kInside;
  else
    result.standing = far ? Standing::kFar : Standing::kInside;
  return result;
}

}  // namespace thicken::field
