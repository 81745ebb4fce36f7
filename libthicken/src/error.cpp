// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/error.h"

#include <utility>

namespace thicken {

Error::Error(ErrorCode code, const std::string& sentence, std::vector<Defect> defects)
    : std::runtime_error(sentence), code_(code), defects_(std::move(defects)) {}

std::string_view name(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kInvalidArgument:
      return "usage";
    case ErrorCode::kUnreadable:
      return "unreadable";
    case ErrorCode::kUnwritable:
      return "unwritable";
    case ErrorCode::kEmpty:
      return "empty";
    case ErrorCode::kNotFinite:
      return "not-finite";
    case ErrorCode::kNotManifold:
      return "not-manifold";
    case ErrorCode::kNotOriented:
      return "not-oriented";
    case ErrorCode::kDegenerate:
      return "degenerate";
    case ErrorCode::kSelfIntersecting:
      return "self-intersecting";
    case ErrorCode::kTooLarge:
      return "too-large";
    case ErrorCode::kMemoryLimit:
      return "memory-limit";
    case ErrorCode::kTimeLimit:
      return "time-limit";
    case ErrorCode::kNoSolid:
      return "no-solid";
    case ErrorCode::kArithmetic:
      return "arithmetic";
    case ErrorCode::kCancelled:
      return "cancelled";
    case ErrorCode::kInternal:
      return "internal";
  }
  return "internal";
}

int exitStatus(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kInvalidArgument:
      return 2;
    case ErrorCode::kEmpty:
    case ErrorCode::kNotFinite:
    case ErrorCode::kNotManifold:
    case ErrorCode::kNotOriented:
    case ErrorCode::kDegenerate:
    case ErrorCode::kSelfIntersecting:
    case ErrorCode::kTooLarge:
      return 3;
    case ErrorCode::kMemoryLimit:
    case ErrorCode::kTimeLimit:
    case ErrorCode::kNoSolid:
    case ErrorCode::kArithmetic:
    case ErrorCode::kInternal:
      return 4;
    case ErrorCode::kCancelled:
      return 5;
    case ErrorCode::kUnreadable:
    case ErrorCode::kUnwritable:
      return 6;
  }
  return 4;
}

}  // namespace thicken
