// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What can be said before the work starts: whether the options make sense, whether the coordinates
// leave room for the thickness, how much memory the run will take.
#pragma once

#include <cstddef>

#include "thicken/mesh.h"
#include "thicken/options.h"

namespace thicken {

/// Throws kInvalidArgument for options that are out of range or contradict one another.
void requireValid(const Options& options);

/// Throws kNotFinite when coordinates grown by the thickness exceed what a float holds, and
/// kNoSolid when a float cannot tell the thickness from 0 at the coordinates' distance from the origin.
void requireRoom(const TriangleMesh& surface, const Options& options);

/// Bytes that thickening `surface` takes at its peak.
[[nodiscard]] std::size_t predictedBytes(const TriangleMesh& surface, const Options& options);

}  // namespace thicken
