// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Opens a surface along the edges at which two senses meet.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Removes the triangles along one side of each chain of edges whose two triangles are of two
/// senses: those that touch the chain on the side with the smaller area.
void cutAlongSeams(Workpiece& piece);

}  // namespace thicken::repairing
