// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Carrier and contour as one triangle mesh: quads split, strips between the contour's border and the
// carrier's rim filled with the least area.
#pragma once

#include "contour/dual_surface.h"
#include "reconstruct/carrier.h"

namespace thicken::reconstruct {

struct Assembly {
  VertexId firstDivided = 0;         ///< of the carrier (Carrier)
  std::size_t carrierVertices = 0;   ///< the contour's vertices follow: those of the dual surface in
  std::size_t carrierTriangles = 0;  ///< its order, then one in the middle of each face that is fanned
  std::size_t dualVertices = 0;
  TriangleMesh mesh;
  std::vector<Region> region;      ///< per triangle
  std::vector<TriangleId> source;  ///< per triangle of the carrier (Carrier)
  static constexpr std::uint32_t kStrip = 0xffffffffu;
  std::vector<std::uint32_t> crossing;  ///< per triangle of the contour: its crossing, or kStrip
  std::vector<std::uint32_t> middleOf;  ///< per middle vertex: its crossing
  [[nodiscard]] bool isStrip(TriangleId t) const {
    return t >= carrierTriangles && crossing[t - carrierTriangles] == kStrip;
  }
};

[[nodiscard]] Assembly assemble(const Carrier& carrier, const contour::DualSurface& dual,
                                const std::vector<contour::Crossing>& crossings,
                                const std::vector<contour::RimWay>& ways, int threads);

}  // namespace thicken::reconstruct
