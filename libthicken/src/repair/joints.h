// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Step 3: if a corner of one triangle lies exactly on a rim edge of another, the other triangle is divided
// there. Such corners lie beside dropped triangles without area. The shape stays, and the two share edges
// afterwards.
#pragma once

#include <span>

#include "exact/box_tree.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// Divides along one edge each of the triangles of `pairs` (those that meet) that such a corner lies
/// on. Returns how many were divided; triangles with more such edges need further rounds.
std::size_t divideAtCorners(Workpiece& piece, std::span<const exact::TrianglePair> pairs);

}  // namespace thicken::repairing
