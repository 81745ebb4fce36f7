// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a run is likely to take, told before it begins.
#pragma once

#include <cstddef>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/surface_facts.h"

namespace thicken {

struct Forecast {
  /// Of a run with Options::threads on an idle machine like the one that the figures were fitted on; any
  /// other has a factor of its own. `libthicken/bench/forecast_table.py` compares it with what runs take.
  double seconds = 0;
  std::size_t bytes = 0;       ///< at the peak, with a margin, where nothing limits it
  std::size_t leastBytes = 0;  ///< what a memory limit must allow for the run to begin
};

/// Counts and sizes of a surface, without what takes a search: rims, components and whether it is closed.
[[nodiscard]] SurfaceFacts sizesOf(const TriangleMesh& surface);

/// What thicken() takes for a surface of so many triangles, area and diagonal; of `options` the thickness,
/// gap, side, method, cells, tolerance and threads count. Takes no time and throws nothing.
[[nodiscard]] Forecast forecast(const SurfaceFacts& surface, const Options& options) noexcept;

}  // namespace thicken
