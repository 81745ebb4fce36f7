// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 4: of the sheets that share an edge the one that runs through stays whole, and the others end beside
// it.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Afterwards no edge has more than two triangles. Nothing of the pair that an edge keeps (sheetsOf()) is
/// removed for it. Returns whether anything was changed.
bool endSheetsAtEdges(Workpiece& piece);

}  // namespace thicken::repairing
