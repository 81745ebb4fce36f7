// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Moves the copies at full depth so that the shell between them, not only they, is r away from S: a
// triangle of a coarse copy cuts the corner of a round offset or stands out of it, and the best place
// of its corners shares the error.
#pragma once

#include "measure/offset_error.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

/// Changes the offsets of copies of depth 1 by damped least squares over points of the shell: the sum
/// of area·error² goes down. The depths must be set; copies are placed anew.
void polish(SweptMesh& mesh, const job::Job& job, const measure::OffsetError& error);

}  // namespace thicken::sweep
