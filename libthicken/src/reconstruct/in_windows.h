// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Holes of a boundary are closed, each in its own window.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "mesh/bounds.h"
#include "reconstruct/contour_task.h"
#include "reconstruct/window.h"

namespace thicken::reconstruct {

/// How the holes of a boundary are to be closed.
struct WindowTask {
  Complete* complete = nullptr;      ///< what closes the hole of a window
  double width = 0;                  ///< of the cells, mm
  bool mayKeepShell = false;         ///< ContourTask
  int refined = 0;                   ///< ContourTask
  std::size_t* allowance = nullptr;  ///< ContourTask
  std::size_t attempts = 0;          ///< that each window may cost, where there is none; 0: any
  /// Triangles that met in a zone with wider cells; empty: none did. Where it is given, windows are closed
  /// one after the other.
  std::function<std::size_t(const mesh::Bounds&)> meetingIn{};
  bool stopsAtFirst = false;  ///< whether the first that cannot be closed ends that
  std::size_t held = 0;       ///< bytes beside a window
  bool anyArea = false;       ///< whether a window may have cells however many
};

/// What could be made in windows around holes.
struct InWindows {
  std::vector<Window> windows;
  std::vector<std::optional<Reconstruction>> made;  ///< per window
  std::vector<mesh::Bounds> stuck;                  ///< zones where nothing could be
};

/// Closes each hole in a window around it; in a wider one if the contour leaves the usual window. A hole
/// stays open if its cells are too many for the grid's keys, for the memory limit or for the allowance, or if
/// S touches every grid that is tried. The result does not depend on the number of threads. Throws
/// kCancelled.
[[nodiscard]] InWindows completeInWindows(const job::Job& job, const Holes& holes, const WindowTask& task);

/// Whether cells of `width` mm are few enough for `area` mm² to be made again in them.
[[nodiscard]] bool fewCells(double width, double area);

}  // namespace thicken::reconstruct
