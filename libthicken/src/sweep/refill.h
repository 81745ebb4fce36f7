// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Drops copies that cannot stand anywhere and fills the holes they leave: with one copy in the place
// of all that a hole lost, seen from every side of the hole, or with a triangulation of minimal area
// (Barequet & Sharir 1995).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sweep/swept_mesh.h"

namespace thicken {

/// Least safety (SweepDirection) of a copy that a float can keep behind all its triangles.
inline constexpr double kLeastSafety = 0.05;

/// Puts one copy in the place of `copies`, which are connected, in the safest direction for the
/// triangles that remain; copies around it that had no safe direction get one if they now can.
/// Returns whether exact tests next to S found that clear; otherwise the mesh is as it was.
[[nodiscard]] bool collapseCopies(SweptMesh& mesh, std::span<const std::uint32_t> copies);

/// Drops `copies` and, where a hole would touch itself, the copies in its way; fills every hole
/// without an edge that the mesh already has and, by exact tests next to S, clear of S. Returns the
/// copies around the holes that cannot be filled: none when all is done; otherwise the mesh is as it
/// was.
[[nodiscard]] std::vector<std::uint32_t> dropAndRefill(SweptMesh& mesh, std::vector<std::uint32_t> copies);

}  // namespace thicken
