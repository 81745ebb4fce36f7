// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The boundary that a settled sweep leaves.
#pragma once

#include "sweep/sweep.h"
#include "sweep/swept_mesh.h"

namespace thicken {

/// Without dropped copies and what only they used. `mesh` and `job`: of one sweep.
[[nodiscard]] SweepResult resultOf(const SweptMesh& mesh, const Job& job);

}  // namespace thicken
