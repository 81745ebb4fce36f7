// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Edges as numbers, for sets and maps of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_set>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// Of the edge from `a` to `b`.
[[nodiscard]] inline std::uint64_t directedKey(VertexId a, VertexId b) {
  return (std::uint64_t{a} << 32) | b;
}

/// Of the edge between `a` and `b`.
[[nodiscard]] inline std::uint64_t edgeKey(VertexId a, VertexId b) {
  return directedKey(std::min(a, b), std::max(a, b));
}

/// Edges by edgeKey(), or by directedKey() where their direction counts.
using EdgeSet = std::unordered_set<std::uint64_t>;

}  // namespace thicken::mesh
