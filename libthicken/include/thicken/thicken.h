// SPDX-License-Identifier: LGPL-2.1-or-later
//
// From an open surface to a printable solid (Wang & Chen, Thickening Freeform Surfaces for Solid
// Fabrication).
//
// Guarantee: the solid that thicken() returns is closed, edge- and vertex-manifold, consistently
// outward-oriented, free of self-intersection and of positive volume, and has every triangle of S
// among its triangles, bit for bit (reversed on the positive side; on both sides S is the middle
// of the solid and its rim is kept). All of it is proved with exact predicates on the coordinates
// as they will be stored. What cannot be proved is not returned.
#pragma once

#include "thicken/check.h"
#include "thicken/closest_point.h"
#include "thicken/drain.h"
#include "thicken/error.h"
#include "thicken/forecast.h"
#include "thicken/inspect.h"
#include "thicken/io.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/picture.h"
#include "thicken/repair.h"
#include "thicken/report.h"
#include "thicken/result.h"
#include "thicken/run_context.h"
#include "thicken/sheets.h"
#include "thicken/trim.h"

namespace thicken {

/// Thickens `surface` as `options` ask.
///
/// Corners with equal coordinates are one vertex: `surface` is welded first, so that vertex and
/// triangle ids in errors and in the result are those of weld(surface), which keeps the order of
/// the triangles. With Options::repair the surface that is thickened, and S in the guarantee, is the
/// one that repair() makes of it; with Options::gap it is the surface at the gap from that one.
///
/// Throws Error: kInvalidArgument for options out of range; the codes of check() with all defects
/// when `surface` is no valid input; kNoSolid when no valid solid was found within the limits;
/// kMemoryLimit; kCancelled.
[[nodiscard]] Solid thicken(const TriangleMesh& surface, const Options& options, RunContext context = {});

}  // namespace thicken
