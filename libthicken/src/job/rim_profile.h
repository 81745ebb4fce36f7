// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the thickness does towards the rim of S: a taper to another thickness there, an outer edge that is
// rounded, or both. Like a thickness map it is a value for each vertex of S, linear over the triangles.
#pragma once

#include <vector>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"

namespace thicken::job {

/// Whether `options` ask for one.
[[nodiscard]] bool hasRimProfile(const Options& options);

/// The same without, for a surface whose rim is not that of the solid.
[[nodiscard]] Options withoutRimProfile(Options options);

/// The thickness at `distance` >= 0 mm from the rim, where without a profile it is `r`, mm: linear from
/// rimThickness at the rim to r at rimWidth; less by the height that a quarter circle of radius rimRound,
/// which touches the wall and the shell, leaves open below the edge.
[[nodiscard]] double profiled(double r, double distance, const Options& options);

/// For each vertex of S the distance to the edge of the rim that is nearest along S, straight, mm: exact
/// where S is flat, and never that to another sheet. Infinite for vertices farther than `reach` that no
/// vertex within it has as a neighbour. Takes time for what is within reach alone.
[[nodiscard]] std::vector<double> distancesToRim(const TriangleMesh& surface, double reach, int threads);

/// Gives the thicknesses `r` of the vertices of S the profile that `options` ask for. Throws kInvalidArgument
/// where there is no vertex but on the rim.
RimFacts addRimProfile(const TriangleMesh& surface, const Options& options, int threads,
                       std::vector<double>& r);

}  // namespace thicken::job
