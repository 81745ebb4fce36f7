// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Which part of the sweep's shell a contour is to replace: all that is off by more than a contour in its
// place would be, in the finest cells that such a part can afford.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "sweep/sweep.h"

namespace thicken::reconstruct {

struct ShellPlan {
  std::vector<std::uint8_t> keep;  ///< per triangle of the sweep
  double area = 0;                 ///< of the rest, mm²
  double width = 0;                ///< of the cells for it, mm
  [[nodiscard]] bool keepsAll() const { return std::find(keep.begin(), keep.end(), 0) == keep.end(); }
};

[[nodiscard]] ShellPlan planShell(const job::Job& job, const sweep::SweepResult& swept);

/// A sweep is of no use beside a contour if its shell is short of the thickness on more than this share of
/// S's area. Half, if the contour of the whole shell has fewer triangles than S and there is room for it;
/// else all.
[[nodiscard]] double mostShort(const job::Job& job);

/// Area of the shell of `swept` that `keep` leaves to the contour, mm².
[[nodiscard]] double openArea(const sweep::SweepResult& swept, std::span<const std::uint8_t> keep);

}  // namespace thicken::reconstruct
