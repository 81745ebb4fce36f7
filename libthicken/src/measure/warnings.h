// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a designer should know before printing, in sentences.
#pragma once

#include <optional>
#include <string>

#include "thicken/result.h"

namespace thicken::measure {

/// "12.3 %"; never "0 %" for what is not 0.
[[nodiscard]] std::string percentText(double share);

/// What a repair did; nothing where it did nothing.
[[nodiscard]] std::optional<std::string> repairWarning(const Report& report);

/// Adds to the warnings of a finished report: repairs, places thinner than asked, separate parts, and a
/// thickness that does not fit the size of the surface.
void addWarnings(Report& report);

}  // namespace thicken::measure
