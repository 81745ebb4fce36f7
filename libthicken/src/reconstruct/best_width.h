// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where sheets are too close for the cells, the carrier is given more and more of the sweep's shell, which
// may be far too thin. Finer cells may tell the sheets apart.
#pragma once

#include <functional>

#include "reconstruct/reconstruct.h"

namespace thicken {

/// What `make` makes with cells of `width` mm, or of a few lesser widths that `isAllowed` where much of the
/// shell would be left to the sweep: the one that leaves the least.
[[nodiscard]] Reconstruction bestOfWidths(double width, const std::function<bool(double width)>& isAllowed,
                                          const std::function<Reconstruction(double width)>& make);

}  // namespace thicken
