// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How wide the cells of a contour are, how many it passes, and whether there is room for them.
#pragma once

#include <cstddef>

#include "job/job.h"
#include "reconstruct/working_set.h"

namespace thicken::reconstruct {

/// Most cells of a width that is chosen, for the whole shell and beside a sweep. Beside a sweep only a
/// thickness far below the extent of the surface comes to so many.
inline constexpr double kManyCells = 6e5, kManyBesideSweep = 2.5e5;

/// The width of the cells for a contour of `area` mm² of S, mm: the option's, that of the resolution, or one
/// that is chosen. Throws kInvalidArgument if a resolution gives cells of r/2 or more (Remark 1).
[[nodiscard]] double cellWidth(const job::Job& job, double area, double mostCells = kManyCells);

/// Crossings that a contour of `area` mm² makes with cells of `width` mm, at most: more than most do.
[[nodiscard]] std::size_t mostCrossings(double area, double width);

/// The shadows along the three axes of the shell, mm²: with the width of its cells they tell how often a grid
/// is crossed.
[[nodiscard]] double shellShadows(const job::Job& job);

/// Crossings that the contour of a shell of such shadows makes with cells of `width` mm, at most.
[[nodiscard]] std::size_t mostShellCrossings(double shadows, double width);

/// Bytes that are held for `surface` while its field and contour are made: itself, its trees, its walls.
[[nodiscard]] std::size_t heldBytes(const TriangleMesh& surface);

/// Whether there is room for so many crossings beside that within the memory limit.
[[nodiscard]] bool hasRoomForField(const job::Job& job, std::size_t crossings);

/// The width of the cells to use, mm: `width` if its `crossings` fit the memory limit or the options ask for
/// a width; else the smallest that fits; infinite if none does.
[[nodiscard]] double widthWithRoom(const job::Job& job, std::size_t crossings, double width);

/// Throws kNoSolid where cells of `width` mm are too many for the grid's keys.
void requireCells(const job::Job& job, double width);

/// What the contour may hold. Throws kNoSolid if cells of `width` are too many for the grid's keys. Throws
/// kMemoryLimit, before any memory is taken, if they do not fit the limit even with the least in memory at a
/// time; the sentence has the width and the limit that would fit.
[[nodiscard]] WorkingSet requireRoomForField(const job::Job& job, std::size_t crossings, double width);

}  // namespace thicken::reconstruct
