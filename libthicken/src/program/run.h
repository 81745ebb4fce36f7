// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The commands of the program. They throw Error, and write the report whatever comes of the run.
#pragma once

#include "program/arguments.h"
#include "thicken/error.h"
#include "thicken/run_context.h"

namespace thicken::program {

void runThicken(const Arguments& arguments, RunContext context);
void runCheck(const Arguments& arguments, RunContext context);
void runTrim(const Arguments& arguments, RunContext context);

/// What an exception of any other type is told as.
[[nodiscard]] Error brokenRule();

}  // namespace thicken::program
