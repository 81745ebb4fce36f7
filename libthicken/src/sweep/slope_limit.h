// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Keeps the depth of the copies from changing faster than S allows (a Lipschitz bound along the
// edges of S), so that no copied triangle stands steep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sweep/swept_mesh.h"

namespace thicken::sweep {

/// Copies joined by an edge of a shell triangle, as flat arrays.
struct CopyGraph {
  struct Link {
    std::uint32_t copy;
    double slack;  ///< mm that the way of the two may differ by
  };
  std::vector<std::uint32_t> offset;
  std::vector<Link> links;
};
[[nodiscard]] CopyGraph copyGraph(const SweptMesh& mesh, int threads);

/// Lowers depths until every way (depth·length) is at most a linked copy's way plus their slack,
/// starting from the copies `from` (their depths are taken as they are; empty: from all). Returns the
/// copies that it lowered, ascending.
std::vector<std::uint32_t> limitSlope(SweptMesh& mesh, const CopyGraph& graph,
                                      std::span<const std::uint32_t> from, int threads = 1);

}  // namespace thicken::sweep
