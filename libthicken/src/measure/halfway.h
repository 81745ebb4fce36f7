// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "thicken/closest_point.h"

namespace thicken {

/// Whether Definition 2 ends the solid within `reach` mm of a point `p` whose closest point on S is `c`,
/// short of the thickness `r`: halfway to another sheet.
[[nodiscard]] inline bool endsHalfway(const Vec3& p, const ClosestPoint& c, const ClosestPointTree& tree,
                                      double r, double reach) {
  if (!(c.distance > 0)) return false;
  const Vec3 step = reach / c.distance * (p - c.point);
  const bool isInside = insideThickened(p, c, r);
  const auto differs = [&](const Vec3& q) { return insideThickened(q, *tree.closest(q), r) != isInside; };
  return differs(p + step) || differs(p - step);
}

}  // namespace thicken
