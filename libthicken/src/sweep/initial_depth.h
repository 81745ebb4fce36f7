// SPDX-License-Identifier: LGPL-2.1-or-later
//
// First guess of the depth of each copy: as deep as the way there stays clear of S.
#pragma once

#include <cstdint>
#include <span>

#include "job/job.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

/// Sets the depth of every copy to the largest h for which the copy keeps most of its distance
/// from S, and from sheets that face it all of it, at every depth up to h. `which`: copies to set; empty:
/// all.
void setInitialDepths(SweptMesh& mesh, const job::Job& job, std::span<const std::uint8_t> which = {});

}  // namespace thicken::sweep
