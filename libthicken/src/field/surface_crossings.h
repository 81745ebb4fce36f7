// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exact signed crossings of a triangle surface with the edges of a grid. Around a face of the grid they sum
// to the rim's passages through that face. So the contour's border is the surface's rim, whatever the labels
// of the nodes are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "field/uniform_grid.h"

namespace thicken::field {

struct SurfaceCrossing {
  std::uint64_t edge;  ///< UniformGrid::key(node, axis)
  double at;           ///< coordinate along the axis, mm (rounded; the edge is exact)
  int jump;            ///< what inside − outside changes by in the axis' direction: −1 leaves the solid
};

/// Finds crossings edge by edge. Most edges that a contour asks for are far from all triangles, and a surface
/// crosses many that it never asks for.
class SurfaceCrossings {
 public:
  /// `positions` and `triangles` must outlive this.
  SurfaceCrossings(const UniformGrid& grid, std::span<const Vec3> positions,
                   std::span<const Triangle> triangles, int threads)
      : grid_(grid), positions_(positions), triangles_(triangles), tree_(positions, triangles, threads) {}

  /// Appends those on `edge` (UniformGrid::key(node, axis)), in no order. Throws GridTouches where a sign is
  /// 0.
  void addTo(std::vector<SurfaceCrossing>& out, std::uint64_t edge) const;

 private:
  UniformGrid grid_;
  std::span<const Vec3> positions_;
  std::span<const Triangle> triangles_;
  exact::BoxTree tree_;
};

/// The crossings of a surface and of what a carrier has beyond it.
class CarrierCrossings {
 public:
  /// Both must outlive this.
  CarrierCrossings(const SurfaceCrossings& surface, const SurfaceCrossings& beyond)
      : surface_(surface), beyond_(beyond) {}

  /// Those on one edge, along it.
  [[nodiscard]] std::vector<SurfaceCrossing> of(std::uint64_t edge) const;

 private:
  const SurfaceCrossings &surface_, &beyond_;
};

}  // namespace thicken::field
