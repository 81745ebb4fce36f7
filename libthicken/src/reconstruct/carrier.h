// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The carrier Ŝ: S with the walls of its sweep, and with pieces of the sweep's shell where the field is finer
// than the grid. All of it is proved to be free of intersections. So the contour has only to be joined to Ŝ's
// rim. That rim lies away from S and may be divided, while S's rim may not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "reconstruct/cut.h"
#include "sweep/sweep.h"
#include "thicken/result.h"

namespace thicken::reconstruct {

struct Carrier {
  TriangleMesh mesh;                  ///< S's vertices and triangles first
  VertexId firstDivided = 0;          ///< vertices from here on divide rim edges, rounded to float
  std::vector<Region> region;         ///< per triangle
  std::vector<TriangleId> source;     ///< per triangle: the sweep's that it is, or is a part of
  std::vector<std::uint8_t> covered;  ///< per triangle of S: it has shell for it
  mesh::Rim rim;                      ///< its edges are no longer than asked, except those of S
  std::vector<Vec3> up;               ///< per vertex: from the end of a wall to where it hangs on S; else 0
};

/// Vertices at which the triangles that `keep` marks (empty: all) form more than one fan.
[[nodiscard]] std::vector<VertexId> nonManifoldVertices(const TriangleMesh& mesh,
                                                        std::span<const std::uint8_t> keep);

/// Which triangles of the sweep (S's included) the carrier takes: `keep`, enlarged until no vertex
/// has two fans.
void closeFans(const TriangleMesh& swept, std::vector<std::uint8_t>& keep);

/// Takes `openable` triangles out of `keep` until none of them gives a vertex two fans.
void openFans(const TriangleMesh& swept, std::span<const std::uint8_t> openable,
              std::vector<std::uint8_t>& keep);

/// Opens spikes: `openable` triangles of at most `largest` mm² that fill a sharp corner at a vertex of the
/// rim. Such a corner may reach past the contour's vertex in its cell, and the strip between the two would be
/// folded.
void trimSpikes(const TriangleMesh& swept, std::span<const std::uint8_t> openable, double largest,
                std::vector<std::uint8_t>& keep);

/// The carrier of the kept triangles, the sweep's vertices at `positions`, with `up` of each; rim edges
/// longer than `longest` mm are divided evenly, those of the first `surfaceTriangles` triangles excepted.
/// What `cut` lists (null: nothing) is no rim.
[[nodiscard]] Carrier makeCarrier(const sweep::SweepResult& swept, std::span<const Vec3> positions,
                                  std::vector<Vec3> up, std::size_t surfaceTriangles,
                                  std::span<const std::uint8_t> keep, double longest, const Cut* cut,
                                  int threads);

}  // namespace thicken::reconstruct
