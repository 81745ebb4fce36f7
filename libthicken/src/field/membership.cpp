// SPDX-License-Identifier: LGPL-2.1-or-later
#include "field/membership.h"

namespace thicken {

namespace {

bool behind(const Vec3& p, const ClosestPoint& c) {
  return (p - c.point).dot(c.pseudonormal) < 0;
}

}  // namespace

Probe Membership::probe(const Vec3& p) const {
  const ClosestPoint onCarrier = *carrier_.closest(p);
  const bool onSurface = onCarrier.triangle < surfaceTriangles_;
  ClosestPoint c = onCarrier;
  if (!onSurface || onCarrier.onRim) c = *surface_.closest(p);
  Probe result;
  result.distance = c.distance;
  result.carrierDistance = onCarrier.distance;
  result.closest = c.point;
  result.triangle = c.triangle;
  const bool far = c.distance > thickness_;
  if (onCarrier.onRim)
    result.standing = c.onRim         ? Standing::kRim
                      : !behind(p, c) ? Standing::kFront
                      : far           ? Standing::kFar
                                      : Standing::kInside;
  else if (!behind(p, onCarrier))
    result.standing = onSurface ? Standing::kFront : Standing::kRim;
  else
    result.standing = far ? Standing::kFar : Standing::kInside;
  return result;
}

}  // namespace thicken
