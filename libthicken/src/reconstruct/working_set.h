// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How much of a contour is in memory at a time. Without a limit, or below one that is high enough, all of it
// is, and what an attempt knows is kept for the next. Below a lower one nodes are dropped and evaluated once
// more, nothing is kept for another attempt, and triangles are searched for meetings block by block: more
// work, and the same result.
#pragma once

#include <cstddef>

#include "exact/pair_search.h"
#include "field/node_field.h"
#include "thicken/run_context.h"

namespace thicken {

struct WorkingSet {
  std::size_t nodes = NodeField::kAny;              ///< of the field that are known at a time
  std::size_t triangles = exact::PairSearch::kAll;  ///< that are searched for meetings at a time
  bool isLean = false;                              ///< nothing is kept for another attempt
};

/// Bytes that a field and its contour of so many crossings take at their peak, beyond what is there already:
/// with all of it in memory at a time, and with as little as can be.
[[nodiscard]] std::size_t wholeBytes(std::size_t crossings);
[[nodiscard]] std::size_t leanBytes(std::size_t crossings);

/// What can be held beside `held` bytes within the limit. Below leanBytes() it is not obeyed.
[[nodiscard]] WorkingSet workingSetFor(std::size_t crossings, std::size_t held, const RunContext& context);

/// Triangles of a solid of so many that its audit can search at a time beside `held` bytes.
[[nodiscard]] std::size_t auditedAtATime(std::size_t triangles, std::size_t held, const RunContext& context);

}  // namespace thicken
