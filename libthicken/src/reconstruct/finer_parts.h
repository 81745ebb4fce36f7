// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parts of a solid that was made are contoured once more, in finer cells; all else is the carrier for them.
#pragma once

#include <functional>

#include "reconstruct/in_windows.h"
#include "reconstruct/reconstruction.h"

namespace thicken {

/// Whether cells of `width` mm may be taken for `area` mm².
using AllowsCells = std::function<bool(double width, double area)>;

/// A boundary whose holes are closed where they can be; elsewhere it stays as it is. `finest` is 0 where none
/// can; `depth` and `shellArea` are not set.
[[nodiscard]] Reconstruction madeInWindows(const Job& job, const Holes& holes, const WindowTask& task);

/// `made` with what it left to the sweep in finer and finer cells, and then what is not proved to be within
/// the tolerance of the job, where there is one, until it is or no finer cells are allowed.
[[nodiscard]] Reconstruction refined(const Job& job, Reconstruction made, const AllowsCells& isAllowed);

}  // namespace thicken
