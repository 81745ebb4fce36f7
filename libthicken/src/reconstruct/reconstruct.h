// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The paper's method: the field of Definitions 1 and 2 on sparse cells, the contour of the part of ∂H
// that is to be made, joined to the unsplit rim, shaped, tested exactly and refined where tests fail.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/working_set.h"
#include "sweep/sweep.h"
#include "thicken/closest_point.h"
#include "thicken/options.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken {

class Stopwatch;

/// The end of a wall.
struct WallEnd {
  VertexId vertex = 0;
  Vec3 up = Vec3::Zero();  ///< mm, from there to where the wall hangs on S, about
};

struct Reconstruction {
  TriangleMesh mesh;               ///< S's vertices and triangles first
  std::vector<Region> region;      ///< per triangle
  std::vector<double> depth;       ///< mm per vertex of S
  std::size_t rounds = 0;          ///< of local refinement
  double cell = 0;                 ///< width, mm
  double finest = 0;               ///< width of the finest ones, where some had to be finer, mm
  std::size_t cells = 0;           ///< that the contour was followed through, in every attempt
  std::size_t nodes = 0;           ///< that the field is known at
  std::size_t predicted = 0;       ///< bytes, with what is held for the surface
  double shellArea = 0;            ///< mm², that was to be contoured
  double leftArea = 0;             ///< mm² of it that was left to the sweep
  std::vector<std::uint8_t> left;  ///< per triangle: whether it is of the sweep's shell for that; empty: none
  std::vector<VertexId> base;      ///< per vertex, of those triangles: what it is a copy of; else any
  std::vector<WallEnd> ends;       ///< of walls
  std::vector<std::uint8_t> openable;  ///< per triangle: may be made again, neither S nor the sweep's walls
  std::vector<VertexId> origin;  ///< of a window, per vertex: of the boundary that was carried, or kNone
};

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

/// Reconstructs on the negative side of `surface` (valid, welded; `tree` is its tree). Throws kNoSolid
/// with the place, kMemoryLimit, kCancelled. Stages are added to `watch`.
[[nodiscard]] Reconstruction reconstruct(const TriangleMesh& surface, const ClosestPointTree& tree,
                                         const Options& options, const RunContext& context, int threads,
                                         Stopwatch& watch);

/// Replaces the shell of `swept` (of `surface` to its negative side) by the contour of the field where it is
/// not at the thickness: all of it, or its worst places where that would take too many cells. Nothing where
/// there is no such place. Throws as reconstruct() does.
[[nodiscard]] std::optional<Reconstruction> deepen(const TriangleMesh& surface, const ClosestPointTree& tree,
                                                   const SweepResult& swept, const Options& options,
                                                   const RunContext& context, int threads, Stopwatch& watch);

}  // namespace thicken
