// SPDX-License-Identifier: LGPL-2.1-or-later
//
// First guess of the depth of each copy: as deep as the way there stays clear of S.
#pragma once

#include <cstdint>
#include <span>

#include "sweep/swept_mesh.h"
#include "thicken/closest_point.h"
#include "thicken/run_context.h"

namespace thicken {

/// Sets the depth of every copy to the largest h for which the copy keeps most of its distance
/// from S, and from sheets that face it all of it, at every depth up to h. `which`: copies to set; empty:
/// all.
void setInitialDepths(SweptMesh& mesh, const ClosestPointTree& tree, const RunContext& context, int threads,
                      std::span<const std::uint8_t> which = {});

}  // namespace thicken
