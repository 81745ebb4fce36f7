// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Strips of triangles between rims that run beside each other.
#pragma once

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Joins rims of a valid surface, which it stays, that run beside each other at a distance of at most
/// `distance` mm, for three times their gap or more. A strip takes the shorter way across at each step, and
/// ends where the rims get farther apart, where it would fold back onto a sheet, or where it would meet
/// something. Parts of opposite sense are made one: the smaller is turned over. Makes no new corners.
void bridgeGaps(Workpiece& piece, double distance, AddedFacts& facts, const RunContext& context, int threads);

}  // namespace thicken::repairing
