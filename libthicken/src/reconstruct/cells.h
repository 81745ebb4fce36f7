// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How wide the cells of a contour are, how many it passes, and whether there is room for them.
#pragma once

#include <cstddef>

#include "job/job.h"
#include "reconstruct/working_set.h"

namespace thicken {

/// Cells that widths are chosen for, at most, where none is given: for the whole shell, and beside a sweep,
/// where only a thickness far below the extent of the surface asks for so many.
inline constexpr double kManyCells = 6e5, kManyBesideSweep = 2.5e5;

/// The width of the cells that the options mean where `area` mm² of S are to be contoured, mm: as
/// given, by the resolution, or chosen. Throws kInvalidArgument where a resolution gives cells of r/2 or more
/// (Remark 1).
[[nodiscard]] double cellWidth(const Job& job, double area, double mostCells = kManyCells);

/// Crossings that a contour of `area` mm² makes with cells of `width` mm, at most: more than most do.
[[nodiscard]] std::size_t mostCrossings(double area, double width);

/// The shadows along the three axes of the shell, mm²: with the width of its cells they tell how often a grid
/// is crossed.
[[nodiscard]] double shellShadows(const Job& job);

/// Crossings that the contour of a shell of such shadows makes with cells of `width` mm, at most.
[[nodiscard]] std::size_t mostShellCrossings(double shadows, double width);

/// Bytes that are held for `surface` while its field and contour are made: itself, its trees, its walls.
[[nodiscard]] std::size_t heldBytes(const TriangleMesh& surface);

/// Whether there is room for so many crossings beside that within the memory limit.
[[nodiscard]] bool hasRoomForField(const Job& job, std::size_t crossings);

/// `width`, with which a contour makes so many crossings, or the least one that there is room for where that
/// is wider and the options do not ask for a width; infinite where there is no room for any.
[[nodiscard]] double widthWithRoom(const Job& job, std::size_t crossings, double width);

/// Throws kNoSolid where cells of `width` mm are too many for the grid's keys.
void requireCells(const Job& job, double width);

/// What the contour may hold. Throws where cells of `width` are too many for the grid's keys or, before any
/// of it is taken, too many for the memory limit even where as little is held at a time as can be, with the
/// width and the limit that would fit.
[[nodiscard]] WorkingSet requireRoomForField(const Job& job, std::size_t crossings, double width);

}  // namespace thicken
