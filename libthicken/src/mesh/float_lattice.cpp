// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/float_lattice.h"

#include <algorithm>

namespace thicken::mesh {
namespace {

double throughFloatStorage(double x) {
  volatile float stored = static_cast<float>(x);  // volatile: the store and the load really happen
  return static_cast<double>(stored) + 0.0;       // −0 + 0 is 0
}

}  // namespace

Vec3 roundToFloat(const Vec3& p) {
  return {throughFloatStorage(p[0]), throughFloatStorage(p[1]), throughFloatStorage(p[2])};
}

bool isFloat(const Vec3& p) {
  return roundToFloat(p) == p;
}

Lattice::Lattice(std::span<const Vec3> positions) : hasFloats_(std::ranges::all_of(positions, isFloat)) {}

}  // namespace thicken::mesh
