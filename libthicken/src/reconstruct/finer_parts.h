// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parts of a solid that was made are contoured once more, in finer cells; all else is the carrier for them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "reconstruct/reconstruct.h"

namespace thicken {

/// Whether cells of `width` mm may be taken for `area` mm².
using AllowsCells = std::function<bool(double width, double area)>;

struct FinerParts {
  std::span<const TriangleId> triangles;  ///< of the solid's shell, to be made again
  double width = 0;                       ///< of the cells, mm
  bool mayKeepShell = false;              ///< ContourTask
  AllowsCells isAllowed;
};

/// `made` with `parts` of its shell, and a few triangles around them, contoured again; nothing where that
/// takes more cells than allowed, or cannot be joined.
[[nodiscard]] std::optional<Reconstruction> contouredAgain(const Reconstruction& made,
                                                           const FinerParts& parts,
                                                           const TriangleMesh& surface,
                                                           const ClosestPointTree& tree,
                                                           const Options& options, const RunContext& context,
                                                           int threads, Stopwatch& watch);

/// Where sheets are too close for the cells, the carrier may have been given the sweep's shell, which may be
/// far too thin: `made` with these parts in finer and finer cells.
[[nodiscard]] Reconstruction withFinerParts(Reconstruction made, const TriangleMesh& surface,
                                            const ClosestPointTree& tree, const Options& options,
                                            const AllowsCells& isAllowed, const RunContext& context,
                                            int threads, Stopwatch& watch);

}  // namespace thicken
