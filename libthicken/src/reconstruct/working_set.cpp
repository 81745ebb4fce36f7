// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/working_set.h"

#include <algorithm>

namespace thicken::reconstruct {

namespace {

// Measured, bytes, with a margin. A crossing makes two triangles and, but for the rim, one vertex.
constexpr std::size_t kWhole = 580;     // a crossing, in all its forms
constexpr std::size_t kLean = 230;      // the same where only one form is held at a time
constexpr std::size_t kFound = 80;      // a crossing that was found, while the contour is followed
constexpr std::size_t kNode = 100;      // a node that is known
constexpr std::size_t kSettling = 165;  // a crossing, while its triangles settle
constexpr std::size_t kSearched = 90;   // a triangle in the tree of a search
constexpr std::size_t kAudited = 90;    // a triangle of a solid that is audited, without the search
// Smaller blocks cost more searches than they save memory.
constexpr std::size_t kLeastNodes = 1 << 15, kLeastTriangles = 1 << 15;

// How many items of `each` bytes have room beside `held`.
std::size_t roomFor(std::size_t each, std::size_t held, std::size_t limit) {
  return limit > held ? (limit - held) / each : 0;
}

}  // namespace

std::size_t wholeBytes(std::size_t crossings) {
  return kWhole * crossings;
}

std::size_t leanBytes(std::size_t crossings) {
  return kLean * crossings + kLeastTriangles * kSearched;
}

WorkingSet workingSetFor(std::size_t crossings, std::size_t held, const RunContext& context) {
  const std::size_t limit = context.memoryLimit();
  if (limit == 0 || held + wholeBytes(crossings) <= limit) return {};
  return {std::max(kLeastNodes, roomFor(kNode, held + kFound * crossings, limit)),
          std::max(kLeastTriangles, roomFor(kSearched, held + kSettling * crossings, limit)), true};
}

std::size_t auditedAtATime(std::size_t triangles, std::size_t held, const RunContext& context) {
  const std::size_t limit = context.memoryLimit();
  if (limit == 0 || held + (kAudited + kSearched) * triangles <= limit) return exact::PairSearch::kAll;
  return std::max(kLeastTriangles, roomFor(kSearched, held + kAudited * triangles, limit));
}

}  // namespace thicken::reconstruct
