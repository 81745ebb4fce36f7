// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Whether a repair lost so much that its result is no repaired solid.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thicken/result.h"

namespace thicken::repairing {

/// A sentence that names the worst place where a solid is not what was asked for: the repair removed more
/// than 5 % of the area, or more than 5 % of the area of S has less than half the thickness below it.
[[nodiscard]] std::optional<std::string> shortcoming(const Solid& solid);

/// Sentences on what a repair added, and on what was asked for and could not be joined or closed.
[[nodiscard]] std::vector<std::string> additions(const RepairFacts& facts);

}  // namespace thicken::repairing
