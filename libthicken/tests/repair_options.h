// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Repairs that do one thing more than they must.
#pragma once

#include "thicken/repair.h"

namespace thicken {

inline RepairOptions weldOver(double distance) {
  RepairOptions options;
  options.weldDistance = distance;
  return options;
}

inline RepairOptions bridging(double distance) {
  RepairOptions options;
  options.bridgeDistance = distance;
  return options;
}

inline RepairOptions filling(double longest) {
  RepairOptions options;
  options.longestHole = longest;
  return options;
}

}  // namespace thicken
