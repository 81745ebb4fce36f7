// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Holes of a boundary are closed in windows around them. A window has the part of S and of the boundary that
// is near enough to matter to the field at the hole. So an attempt costs what the hole costs, however large S
// is, and a hole that cannot be closed does not keep others open.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "job/job.h"
#include "reconstruct/cut.h"
#include "reconstruct/reconstruction.h"
#include "sweep/sweep.h"

namespace thicken::reconstruct {

/// A boundary with holes.
struct Holes {
  sweep::SweepResult carried;          ///< the boundary, with what is cut out of it
  std::vector<std::uint8_t> keep;      ///< per triangle of it: outside of the holes
  std::vector<std::uint8_t> openable;  ///< per triangle: may be cut out
  std::vector<std::uint8_t> left;      ///< per triangle: of the sweep's shell, kept for want of better
};

struct Window {
  TriangleMesh surface;  ///< the part of S
  Holes part;            ///< its vertices and triangles first
  mesh::Bounds zone;     ///< nothing beyond is changed
  Cut cut;
  double area = 0;                  ///< of what is open, mm²
  std::vector<TriangleId> source;   ///< per triangle of the window: the boundary's; ascending
  std::vector<VertexId> vertex;     ///< per vertex of the window: the boundary's; ascending
  std::vector<std::uint8_t> fixed;  ///< per vertex of the window: at its edge
};

/// Zones of windows that were too narrow: a contour left them. Windows there reach `times` as far as usual.
struct TooNarrow {
  std::span<const mesh::Bounds> zones;
  double times = 1;
};

/// Windows whose zones are disjoint, for contours with cells of `width` mm.
[[nodiscard]] std::vector<Window> windowsOf(const job::Job& job, const Holes& holes, double width,
                                            const TooNarrow& narrow = {});

/// Whether all vertices that are new in a window, or moved, lie in its zone.
[[nodiscard]] bool staysWithin(const Window& window, const Reconstruction& made);

/// The boundary with what was made in its windows. A window in which nothing was made keeps all triangles
/// that `holes` has there. If two windows would replace the same triangle, the later one counts as one in
/// which nothing was made. `origin` of the result is in terms of the boundary's vertices.
[[nodiscard]] Reconstruction withWindows(const TriangleMesh& surface, const Holes& holes,
                                         std::span<const Window> windows,
                                         std::span<std::optional<Reconstruction>> made);

}  // namespace thicken::reconstruct
