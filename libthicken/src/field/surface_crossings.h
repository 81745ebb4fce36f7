// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exact signed crossings of a triangle surface with the edges of a grid. They are what makes the
// contour's boundary the surface's rim for any labels of the nodes: around a face of the grid the
// crossings sum up to the rim's passages through that face.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/key_filter.h"
#include "field/uniform_grid.h"
#include "thicken/run_context.h"

namespace thicken {

struct SurfaceCrossing {
  std::uint64_t edge;  ///< UniformGrid::key(node, axis)
  double at;           ///< coordinate along the axis, mm (rounded; the edge is exact)
  int jump;            ///< what inside − outside changes by in the axis' direction: −1 leaves the solid
};

/// All crossings, sorted by edge, then along it. Throws GridTouches where a sign is 0.
[[nodiscard]] std::vector<SurfaceCrossing> surfaceCrossings(const UniformGrid& grid,
                                                            std::span<const Vec3> positions,
                                                            std::span<const Triangle> triangles,
                                                            const RunContext& context, int threads);

/// Crossings by the edge that they lie on. Nearly all edges that are asked for have none.
class CrossedEdges {
 public:
  /// Of two sets of crossings, each in the order of surfaceCrossings().
  CrossedEdges(std::span<const SurfaceCrossing> one, std::span<const SurfaceCrossing> other, int threads);

  /// Those on one edge, along it.
  [[nodiscard]] std::span<const SurfaceCrossing> of(std::uint64_t edge) const {
    return filter_.mayHave(edge) ? found(edge) : std::span<const SurfaceCrossing>();
  }

 private:
  [[nodiscard]] std::span<const SurfaceCrossing> found(std::uint64_t edge) const;

  std::vector<SurfaceCrossing> crossings_;
  KeyFilter filter_;
};

}  // namespace thicken
