// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What can be said before the work starts: whether the options make sense, whether the coordinates
// leave room for the thickness, how much memory the run will take.
#pragma once

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/surface_facts.h"

namespace thicken::pipeline {

/// Throws kInvalidArgument for options that are out of range or contradict one another.
void requireValid(const Options& options);

/// Throws kInvalidArgument where a thickness map is not one of the surface as it is given.
void requireMapOf(const TriangleMesh& surface, const Options& options);

/// Throws kNotFinite when coordinates grown by the thickness exceed what a float holds, and
/// kNoSolid when a float cannot tell the thickness from 0 at the coordinates' distance from the origin.
void requireRoom(const TriangleMesh& surface, const Options& options);

/// Edges of the grid that the contour is likely to cross, if there is one.
[[nodiscard]] double predictedCrossings(const SurfaceFacts& surface, const Options& options);

/// Units of work (RunContext::count) that the stages take, roughly.
struct Work {
  double check = 0, sweep = 0, contour = 0, audit = 0, measure = 0, tolerance = 0;
};
[[nodiscard]] Work workFor(const SurfaceFacts& surface, const Options& options);

}  // namespace thicken::pipeline
