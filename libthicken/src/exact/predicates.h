// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exact predicates: the sign of a determinant of double coordinates, decided by a floating-point
// filter first and by expansion arithmetic (Shewchuk 1997) where the filter cannot. Preconditions: domain.h;
// check() and audit() test them.
#pragma once

#include "thicken/mesh.h"

namespace thicken::exact {

/// Sign of (b − a) × (c − a) · (d − a): +1 when d lies on the side that the normal of the
/// counter-clockwise triangle abc points to, 0 when the four points are coplanar.
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the signed area of abc after the coordinate `axis` (0, 1, 2) is dropped; the remaining
/// coordinates are taken in cyclic order, so that it is the sign of the axis' component of
/// (b − a) × (c − a).
[[nodiscard]] int orientation2(const Vec3& a, const Vec3& b, const Vec3& c, int axis);

/// Whether a, b, c lie on one line (the triangle abc has no area).
[[nodiscard]] bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// (b − a) × (c − a), every component within a few units in the last place of its exact value, however flat
/// the triangle is.
[[nodiscard]] Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace thicken::exact
