// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Axis-aligned boxes of floats that hold all that they were made for. They take half the memory of doubles,
// and memory decides the time of a tree.
#pragma once

#ifdef __SSE__
#include <immintrin.h>
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "thicken/mesh.h"

namespace thicken::exact {

struct FloatBox {
  float low[3], high[3];  // side by side

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
#ifdef __SSE__
    // Loads of four take one number too many, which is of the same box, and left out of the answer.
    const auto lowOf = [](const FloatBox& b) { return _mm_loadu_ps(b.low); };
    const auto highOf = [](const FloatBox& b) {
      const __m128 last = _mm_loadu_ps(b.low + 2);
      return _mm_shuffle_ps(last, last, _MM_SHUFFLE(3, 3, 2, 1));
    };
    const __m128 in =
        _mm_and_ps(_mm_cmple_ps(lowOf(*this), highOf(other)), _mm_cmple_ps(lowOf(other), highOf(*this)));
    return (_mm_movemask_ps(in) & 7) == 7;
#else
    bool all = true;
    for (int k = 0; k < 3; ++k) all &= (low[k] <= other.high[k]) & (other.low[k] <= high[k]);
    return all;
#endif
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
