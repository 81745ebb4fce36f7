// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Rounding to the values that a float can hold. The rounded value goes through a float in memory:
// g++ 12.2 at -O2 drops (double)(float)x in vectorised code.
#pragma once

#include <span>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// `p` with every coordinate rounded to the nearest float (held in doubles). −0 becomes 0.
[[nodiscard]] Vec3 roundToFloat(const Vec3& p);

/// Whether every coordinate of `p` is a float value.
[[nodiscard]] bool isFloat(const Vec3& p);

/// Where new vertices of a mesh lie: on float values if all that it has do, else anywhere.
class Lattice {
 public:
  explicit Lattice(std::span<const Vec3> positions);
  [[nodiscard]] Vec3 nearest(const Vec3& p) const { return hasFloats_ ? roundToFloat(p) : p; }

 private:
  bool hasFloats_;
};

}  // namespace thicken::mesh
