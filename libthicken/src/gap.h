// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A solid that begins at a gap from S. The shell of the solid of S that is as thick as the gap is a surface
// of its own, the gap surface, and it is thickened in the place of S.
#pragma once

#include "thicken/options.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken::pipeline {

/// thicken() with Options::gap above 0.
[[nodiscard]] Solid thickenAtGap(const TriangleMesh& surface, const Options& options, RunContext context);

}  // namespace thicken::pipeline
