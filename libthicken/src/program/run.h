// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The two commands of the program. Both throw Error, and write the report whatever comes of the run,
// unless it was cancelled.
#pragma once

#include "program/arguments.h"
#include "thicken/run_context.h"

namespace thicken::program {

void runThicken(const Arguments& arguments, RunContext context);
void runCheck(const Arguments& arguments, RunContext context);

}  // namespace thicken::program
