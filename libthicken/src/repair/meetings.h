// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The pairs of triangles under repair that meet, a bounded number of them. Triangles are divided before where
// that ends a meeting.
#pragma once

#include <vector>

#include "exact/box_tree.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

struct KnownMeetings {
  std::vector<exact::TrianglePair> pairs;  ///< among the triangles that are present
  std::vector<std::uint8_t> goneForGood;   ///< per triangle: not all that it meets is in `pairs`
};

/// Divides triangles at corners on their edges (divideAtCorners) until none is left, drops repeated
/// ones, and finds what meets. Where too many pairs meet to be held, the largest triangles of those
/// that meet no larger one are kept, and the rest is removed.
[[nodiscard]] KnownMeetings findMeetings(Workpiece& piece, const RunContext& context, int threads);

}  // namespace thicken::repairing
