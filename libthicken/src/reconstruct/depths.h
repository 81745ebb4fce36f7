// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How deep a reconstructed solid is below the vertices of S.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "job/job.h"
#include "reconstruct/reconstruction.h"
#include "sweep/sweep.h"

namespace thicken::reconstruct {

/// Below each vertex of S, mm: to where the field ends along the normal, or to the copy of it where pieces of
/// the shell of `swept` are kept; `keep`: flags per triangle of it.
[[nodiscard]] std::vector<double> depthsOf(const job::Job& job, const sweep::SweepResult& swept,
                                           std::span<const std::uint8_t> keep);

/// The same of `made`: to the copies that were left there.
[[nodiscard]] std::vector<double> depthsOf(const job::Job& job, const Reconstruction& made);

/// The same of `made` in place of `swept`, whose vertices `made.origin` names: to the copies that are still
/// there, all of which are the sweep's.
[[nodiscard]] std::vector<double> depthsOf(const job::Job& job, const Reconstruction& made,
                                           const sweep::SweepResult& swept);

}  // namespace thicken::reconstruct
