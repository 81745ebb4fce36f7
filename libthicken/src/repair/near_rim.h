// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What rims that run near each other have in common, whether they are joined or bridged.
#pragma once

#include "mesh/segment.h"

namespace thicken::repairing {

/// A rim is near itself at every bend. It counts as two rims beside each other if the way along it is this
/// many times as long as the way across.
inline constexpr double kFoldedBack = 4;

}  // namespace thicken::repairing
