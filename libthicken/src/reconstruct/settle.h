// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Moves the contour's vertices to their targets as far as exact tests of all pairs of triangles allow.
#pragma once

#include "exact/pair_search.h"
#include "reconstruct/assembly.h"

namespace thicken::reconstruct {

/// Triangles that an earlier attempt proved to be clear of each other, by their corners.
class ProvedTriangles {
 public:
  /// Which of the triangles of `mesh` are among them.
  [[nodiscard]] std::vector<std::uint8_t> among(const TriangleMesh& mesh, int threads) const;
  /// Replaces them by the triangles of `mesh` except those that meet others (ascending).
  void replace(const TriangleMesh& mesh, std::span<const TriangleId> meeting, int threads);

 private:
  std::vector<std::uint64_t> hashes_;  ///< sorted; the audit of the result does not rely on them
};

/// Places the contour's vertices at `target` (floats). Where triangles meet, vertices go back towards where
/// they started, ends of walls that are in the way are drawn back by `step` mm along `up` (Carrier), and at
/// last vertices go to the mean of their neighbours. Returns the triangles that meet in the end, ascending.
/// Triangles in `proved` are tested against each other only if they moved. `most`: triangles that are
/// searched for meetings at a time (PairSearch).
[[nodiscard]] std::vector<TriangleId> settle(Assembly& assembly, std::span<const Vec3> target,
                                             std::span<const Vec3> up, double step,
                                             const ProvedTriangles& proved, std::size_t most,
                                             const RunContext& context, int threads);

}  // namespace thicken::reconstruct
