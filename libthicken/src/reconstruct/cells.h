// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How wide the cells of a contour are, how many it passes, and whether there is room for them.
#pragma once

#include <cstddef>

#include "reconstruct/working_set.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/run_context.h"

namespace thicken {

/// Cells that widths are chosen for, at most, where none is given: for the whole shell, and beside a sweep,
/// where only a thickness far below the extent of the surface asks for so many.
inline constexpr double kManyCells = 6e5, kManyBesideSweep = 2.5e5;

/// The width of the cells that `options` mean where `area` mm² of `surface` are to be contoured, mm: as
/// given, by the resolution, or chosen. Throws kInvalidArgument where a resolution gives cells of r/2 or more
/// (Remark 1).
[[nodiscard]] double cellWidth(const TriangleMesh& surface, double area, const Options& options,
                               double mostCells = kManyCells);

/// Crossings that a contour of `area` mm² makes with cells of `width` mm, at most: more than most do.
[[nodiscard]] std::size_t mostCrossings(double area, double width);

/// The shadows along the three axes of the shell at `r` mm below `surface`, mm²: with the width of its cells
/// they tell how often a grid is crossed.
[[nodiscard]] double shellShadows(const TriangleMesh& surface, double r, int threads);

/// Crossings that the contour of a shell of such shadows makes with cells of `width` mm, at most.
[[nodiscard]] std::size_t mostShellCrossings(double shadows, double width);

/// The same for the whole shell at `r` mm below `surface`.
[[nodiscard]] std::size_t mostShellCrossings(const TriangleMesh& surface, double r, double width,
                                             int threads);

/// Bytes that are held for `surface` while its field and contour are made: itself, its trees, its walls.
[[nodiscard]] std::size_t heldBytes(const TriangleMesh& surface);

/// Whether there is room for so many crossings beside that within the memory limit.
[[nodiscard]] bool hasRoomForField(const TriangleMesh& surface, std::size_t crossings,
                                   const RunContext& context);

/// `width`, with which a contour makes so many crossings, or the least one that there is room for where that
/// is wider and `options` do not ask for a width; infinite where there is no room for any.
[[nodiscard]] double widthWithRoom(const TriangleMesh& surface, std::size_t crossings, double width,
                                   const Options& options, const RunContext& context);

/// Throws kNoSolid where cells of `width` mm are too many for the grid's keys.
void requireCells(const TriangleMesh& surface, double r, double width);

/// What the contour may hold. Throws where cells of `width` are too many for the grid's keys or, before any
/// of it is taken, too many for the memory limit even where as little is held at a time as can be, with the
/// width and the limit that would fit.
[[nodiscard]] WorkingSet requireRoomForField(const TriangleMesh& surface, std::size_t crossings, double r,
                                             double width, const RunContext& context);

}  // namespace thicken
