// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Contours parts of a finished solid once more, in finer cells. All else is the carrier.
#pragma once

#include <functional>

#include "reconstruct/in_windows.h"
#include "reconstruct/reconstruction.h"

namespace thicken::reconstruct {

/// Whether cells of `width` mm may be taken for `area` mm².
using AllowsCells = std::function<bool(double width, double area)>;

/// A boundary whose holes are closed where they can be; elsewhere it stays as it is. `finest` is 0 where none
/// can; `depth` and `shellArea` are not set.
[[nodiscard]] Reconstruction madeInWindows(const job::Job& job, const Holes& holes, const WindowTask& task);

/// `made`, refined. First what it left to the sweep is contoured in finer and finer cells. Then, if the job
/// has a tolerance, so is what is not proved to be within it. Ends when all is proved or no finer cells are
/// allowed.
[[nodiscard]] Reconstruction refined(const job::Job& job, Reconstruction made, const AllowsCells& isAllowed);

}  // namespace thicken::reconstruct
