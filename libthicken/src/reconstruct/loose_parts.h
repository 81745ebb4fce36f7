// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Closed pieces of the contour that are joined to nothing and bound nothing of H.
#pragma once

#include "reconstruct/assembly.h"
#include "reconstruct/reconstruction.h"
#include "thicken/run_context.h"

namespace thicken::reconstruct {

/// Removes pieces that are but a few cells large: islands and cavities where the field is finer than the
/// grid. Every part of the solid hangs together with S.
void dropSpecks(Assembly& assembly, double width, int threads);

/// Removes pieces of a contour without meetings that turned inside out when they were shaped, or that
/// float in nothing (misplacedShells()).
void dropMisplaced(Assembly& assembly, int threads);
/// The same of what was put together; `surfaceVertices`: of S, which come first.
void dropMisplaced(Reconstruction& made, std::size_t surfaceVertices, int threads);

}  // namespace thicken::reconstruct
