// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the program says on stderr: one line a message, and as the last line of a failed run
// "thicken: <code>: <sentence>".
#pragma once

#include <string>
#include <string_view>

#include "thicken/error.h"

namespace thicken::program {

/// `text` on one line: file names may hold line breaks and terminal codes.
[[nodiscard]] std::string oneLine(std::string_view text);

void printWarning(std::string_view sentence);

/// The further findings, unless `quiet`, and then the last line.
void printError(const Error& error, bool quiet);

}  // namespace thicken::program
