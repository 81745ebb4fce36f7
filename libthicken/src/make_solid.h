// SPDX-License-Identifier: LGPL-2.1-or-later
//
// From a valid surface to its solid: sweep, contour, fewer triangles, proof, figures.
#pragma once

#include "job/job.h"
#include "plan.h"
#include "thicken/result.h"

namespace thicken::pipeline {

/// The solid of `job`, proved and measured. `given`: S as it is to be kept, not turned to the side of the
/// material. `input`: the facts of the surface before any repair. Throws kNoSolid with the place,
/// kMemoryLimit, kCancelled.
[[nodiscard]] Solid makeSolid(const job::Job& job, const TriangleMesh& given, const SurfaceFacts& input);

}  // namespace thicken::pipeline
