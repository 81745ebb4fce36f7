// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How much of a contour is in memory at a time. If the memory limit allows, all of it is, and each attempt
// keeps what it knows for the next. Otherwise nodes are dropped and evaluated once more, nothing is kept for
// another attempt, and triangles are searched for meetings block by block. That is more work with the same
// result.
#pragma once

#include <cstddef>

#include "exact/pair_search.h"
#include "field/node_field.h"
#include "thicken/run_context.h"

namespace thicken::reconstruct {

struct WorkingSet {
  std::size_t nodes = field::NodeField::kAny;       ///< of the field that are known at a time
  std::size_t triangles = exact::PairSearch::kAll;  ///< that are searched for meetings at a time
  bool isLean = false;                              ///< nothing is kept for another attempt
};

/// Bytes that a field and its contour of so many crossings add to the peak: with all of it in memory at a
/// time, and with as little as possible.
[[nodiscard]] std::size_t wholeBytes(std::size_t crossings);
[[nodiscard]] std::size_t leanBytes(std::size_t crossings);

/// What can be held beside `held` bytes within the limit. Below leanBytes() it is not obeyed.
[[nodiscard]] WorkingSet workingSetFor(std::size_t crossings, std::size_t held, const RunContext& context);

/// Triangles of a solid of so many that its audit can search at a time beside `held` bytes.
[[nodiscard]] std::size_t auditedAtATime(std::size_t triangles, std::size_t held, const RunContext& context);

}  // namespace thicken::reconstruct
