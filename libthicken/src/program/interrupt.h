// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "thicken/run_context.h"

namespace thicken::program {

/// From now on SIGINT (Ctrl-C) and SIGTERM cancel `context`, which then ends the run in order:
/// nothing half-written stays behind. A second one does not wait for that, as during the reading of
/// a file from a slow disk, and ends the program as cancelled at once. Call it once.
void cancelOnInterrupt(const RunContext& context);

}  // namespace thicken::program
