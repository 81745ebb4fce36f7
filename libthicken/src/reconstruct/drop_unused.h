// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "reconstruct/reconstruction.h"

namespace thicken::reconstruct {

/// Drops the vertices that no triangle uses; those that are left are numbered as they come, S's first.
void dropUnused(Reconstruction& made, std::size_t surfaceVertices);

}  // namespace thicken::reconstruct
