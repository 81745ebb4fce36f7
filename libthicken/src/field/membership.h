// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Definition 2 at a point, for a surface that has been extended: the carrier Ŝ is S with further
// triangles that are already known to bound the solid (the wall next to the rim, pieces of shell).
// If the closest face is one of Ŝ's own, its side classifies the point. Otherwise, and outside a kept piece
// of shell, Definition 2 does: another sheet's material may begin there at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "job/thickness.h"
#include "thicken/closest_point.h"
#include "thicken/result.h"

namespace thicken::field {

/// Why a point is in the solid or not.
enum class Standing : std::uint8_t {
  kInside,
  kFar,    ///< behind S, farther than r: beyond the inner shell
  kFront,  ///< before S
  kRim,    ///< its closest point lies on the rim, or before the wall: beyond the cross-section
};

struct Probe {
  Standing standing = Standing::kFar;
  double distance = 0;          ///< to S, mm
  double thickness = 0;         ///< there, mm
  double excess = 0;            ///< mm, of the distance over it
  Vec3 slope = Vec3::Zero();    ///< of the thickness there
  double carrierDistance = 0;   ///< to Ŝ, mm; at most `distance`
  Vec3 closest = Vec3::Zero();  ///< on S
  TriangleId triangle = 0;      ///< of S, holds `closest`
  [[nodiscard]] bool inside() const { return standing == Standing::kInside; }
};

class Membership {
 public:
  /// The first `surfaceTriangles` triangles of the carrier are those of the surface, in its order. `surface`
  /// The first `surfaceTriangles` triangles of the carrier are those of the surface, in its order. `surface`
  /// is their tree. The other triangles get a tree of their own. `region`, per triangle of the carrier, marks
  /// pieces of shell (empty: none). `covered`, per triangle of the surface: 1 if such a piece ends its
  /// material, at any depth (empty: none). `surface`, `thickness` and `covered` must outlive this.
  Membership(const TriangleMesh& carrier, const ClosestPointTree& surface, std::size_t surfaceTriangles,
             const job::Thickness& thickness, std::span<const Region> region = {},
             std::span<const std::uint8_t> covered = {}, int threads = 1);

  [[nodiscard]] Probe probe(const Vec3& p) const;
  [[nodiscard]] const job::Thickness& thickness() const { return thickness_; }
  [[nodiscard]] const ClosestPointTree& surface() const { return surface_; }

 private:
  [[nodiscard]] bool isShell(TriangleId beyond) const;
  [[nodiscard]] bool isCovered(TriangleId onSurface) const;
  [[nodiscard]] Standing beforeCarrier(const Vec3& p, const ClosestPoint& onSurface, TriangleId beyond) const;

  const ClosestPointTree& surface_;
  std::size_t atRim_ = 0;       ///< so many triangles of beyond_ are S's
  std::vector<Region> region_;  ///< of the others; empty: no shell
  std::span<const std::uint8_t> covered_;
  ClosestPointTree beyond_;
  const job::Thickness& thickness_;
};

}  // namespace thicken::field
