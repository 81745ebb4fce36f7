// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Of which region the strip between the carrier's rim and the contour is: wall where the end of a wall was
// drawn back, so that the contour goes on as wall, else shell.
#pragma once

#include "reconstruct/assembly.h"

namespace thicken {

/// A triangle of the strip is what the contour across its edge is; one that has no edge with the contour is
/// wall where the strip beside it is.
void labelStrip(Assembly& assembly, int threads);

}  // namespace thicken
