// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Axis-aligned boxes of floats that are certain to hold what they were made for: half the memory of
// doubles, which is what the time of a tree goes to.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "thicken/mesh.h"

namespace thicken::exact {

struct FloatBox {
  float low[3], high[3];

  static FloatBox empty() {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    return {{kInf, kInf, kInf}, {-kInf, -kInf, -kInf}};
  }
  void include(const FloatBox& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  /// Touching counts; an empty box overlaps nothing.
  [[nodiscard]] bool overlaps(const FloatBox& other) const {
    bool all = true;
    for (int k = 0; k < 3; ++k) all &= (low[k] <= other.high[k]) & (other.low[k] <= high[k]);
    return all;
  }
  bool operator==(const FloatBox&) const = default;
};

/// A float not above x: the next one below the nearest, without asking on which side that lies.
inline float floatBelow(double x) {
  const float f = static_cast<float>(x);
  const auto bits = std::bit_cast<std::uint32_t>(f);
  if (f == 0) return -std::numeric_limits<float>::denorm_min();
  return std::bit_cast<float>(f > 0 ? bits - 1 : bits + (f >= -std::numeric_limits<float>::max()));
}
inline float floatAbove(double x) {
  return -floatBelow(-x);
}

inline FloatBox boxOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = floatBelow(std::min({a[k], b[k], c[k]}));
    box.high[k] = floatAbove(std::max({a[k], b[k], c[k]}));
  }
  return box;
}

}  // namespace thicken::exact
