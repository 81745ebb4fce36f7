// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Pairs signed crossings of a grid face's edges and signed passages of the rim: each that enters the face
// with one that leaves it. A pair is an arc of the surface in that face: a dual edge.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "contour/crossings.h"
#include "contour/rim_walk.h"

namespace thicken::contour {

/// The four faces around a crossed edge, counter-clockwise about its axis, lie between the sectors k
/// and k + 1 of the edge's cells. An end of an arc is 4·crossing + k, or 4·crossings + passage.
using Arc = std::pair<std::uint32_t, std::uint32_t>;

/// Sector k of an edge along `axis` is the cell at this offset from the edge's node.
[[nodiscard]] field::GridIndex sectorOffset(int axis, int k);

/// Takes the arcs of some faces, in the order of the faces' keys. Called on any thread.
using VisitArcs = std::function<void(std::span<const Arc>)>;

/// Matches all faces, a part of the crossings at a time, so that only a part is held. Returns the arcs that
/// share their face with others, in the order of the faces' keys. `crossings` must be sorted; `passages` must
/// be in the order of the ways' visits.
std::vector<Arc> matchFaces(const std::vector<Crossing>& crossings, const std::vector<RimPassage>& passages,
                            int threads, const VisitArcs& visit);

}  // namespace thicken::contour
