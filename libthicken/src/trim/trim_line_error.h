// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The error of a line that cannot be trimmed along, with its place.
#pragma once

#include <string>

#include "thicken/error.h"

namespace thicken::trimming {

[[nodiscard]] Error trimLineError(const std::string& sentence, const Vec3& place);

}  // namespace thicken::trimming
