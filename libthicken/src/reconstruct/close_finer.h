// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What an attempt could not make is made in finer cells, in windows around it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/bounds.h"
#include "reconstruct/attempt.h"
#include "reconstruct/complete.h"
#include "reconstruct/window.h"

namespace thicken {

/// What an attempt could not make, once it was tried in finer cells.
struct Closing {
  std::optional<Reconstruction> made;  ///< where all of it could be made
  std::vector<TriangleId> stuck;       ///< of the assembly: triangles that meet where it could not
};

/// What `attempt` at `task` could not make, in finer cells: the rest of it is the carrier for that. Zones
/// where even the finest ones that are tried do not do are added to `givenUp`, and are not tried again.
/// Throws kCancelled.
[[nodiscard]] Closing closedFiner(const TriangleMesh& surface, const ClosestPointTree& tree,
                                  const SweepResult& swept, const ContourTask& task, const Attempt& attempt,
                                  std::span<const TriangleId> meeting, std::vector<Bounds>& givenUp,
                                  const Options& options, const RunContext& context, int threads,
                                  Stopwatch& watch);

struct InWindow {
  std::optional<Reconstruction> made;
  bool isTooNarrow = false;  ///< whether what would be made does not stay within the window
};

/// complete() in a window, in cells that need not be; `task` says in which. `held`: bytes beside it. Nothing
/// is made, too, where they are too many for the grid's keys or for the memory limit, where S touches their
/// grid wherever it lies, or where the window is too narrow. Throws kCancelled.
[[nodiscard]] InWindow completeWindow(const TriangleMesh& surface, const ClosestPointTree& tree,
                                      const Window& window, ContourTask task, std::size_t held,
                                      const Options& options, const RunContext& context, int threads,
                                      Stopwatch& watch);

/// How much of a boundary of so many triangles its finer parts may cost, as ContourTask::allowance.
[[nodiscard]] std::size_t allowanceFor(std::size_t triangles);

/// Whether cells of `width` mm are few enough for `area` mm² to be made again in them.
[[nodiscard]] bool fewCells(double width, double area);

}  // namespace thicken
