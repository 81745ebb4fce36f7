// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The paper's method: the field of Definitions 1 and 2 on sparse cells, the contour of the part of ∂H
// that is to be made, joined to the unsplit rim, shaped, tested exactly and refined where tests fail.
#pragma once

#include <optional>

#include "job/job.h"
#include "reconstruct/reconstruction.h"
#include "sweep/sweep.h"

namespace thicken::reconstruct {

/// Reconstructs on the negative side of S. Throws kNoSolid with the place, kMemoryLimit, kCancelled.
[[nodiscard]] Reconstruction reconstruct(const job::Job& job);

/// Replaces the shell of `swept` (to the negative side) by the contour of the field where it is not at the
/// thickness: all of it, or its worst places where that would take too many cells. Nothing where there is no
/// such place. Throws as reconstruct() does.
[[nodiscard]] std::optional<Reconstruction> deepen(const job::Job& job, const sweep::SweepResult& swept);

}  // namespace thicken::reconstruct
