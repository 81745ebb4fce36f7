// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whether a run would make what is there already.
#pragma once

#include <string>

#include "program/arguments.h"

namespace thicken::program {

/// A digest of all that the bytes of the output follow from: those of the input, the options, both formats
/// and the version. Empty where the input cannot be read.
[[nodiscard]] std::string keyOf(const Arguments& arguments);

/// Whether the report that is there tells of a run with this key, and the output has the bytes that it wrote.
[[nodiscard]] bool isMadeBefore(const Arguments& arguments, const std::string& key);

}  // namespace thicken::program
