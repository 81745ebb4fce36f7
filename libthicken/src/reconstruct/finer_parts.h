// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where sheets are too close for the cells, the carrier is given more and more of the sweep's shell, which
// may be far too thin. Finer cells may tell the sheets apart there; elsewhere they are not needed.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "reconstruct/reconstruct.h"

namespace thicken {

/// Contours the parts that `made` left to the sweep once more, in finer and finer cells, as long as
/// `isAllowed` agrees to cells of `width` mm over `area` mm². The rest of `made` is the carrier for it.
[[nodiscard]] Reconstruction withFinerParts(Reconstruction made, const TriangleMesh& surface,
                                            const ClosestPointTree& tree, const Options& options,
                                            const std::function<bool(double width, double area)>& isAllowed,
                                            const RunContext& context, int threads, Stopwatch& watch);

/// The triangles of `made` outside of what it left to the sweep, of its shell also outside of two rings of
/// triangles around that: a seam in the ragged border of what could not be made would be as hard to make.
[[nodiscard]] std::vector<std::uint8_t> keptAroundLeft(const TriangleMesh& mesh,
                                                       std::span<const Region> region,
                                                       std::span<const std::uint8_t> left);

}  // namespace thicken
