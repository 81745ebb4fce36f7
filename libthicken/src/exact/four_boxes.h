// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Four boxes side by side, so that one box is compared with all of them at once.
#pragma once

#include "exact/float_box.h"

namespace thicken::exact {

struct FourBoxes {
  static constexpr std::uint32_t kFour = 4;

  float low[3][kFour], high[3][kFour];

  void set(std::uint32_t i, const FloatBox& box) {
    for (int k = 0; k < 3; ++k) {
      low[k][i] = box.low[k];
      high[k][i] = box.high[k];
    }
  }
  [[nodiscard]] FloatBox box(std::uint32_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }
  [[nodiscard]] FloatBox box() const {
    FloatBox all = box(0);
    for (std::uint32_t i = 1; i < kFour; ++i) all.include(box(i));
    return all;
  }
  /// Bit i: whether box i overlaps.
  [[nodiscard]] unsigned overlaps(const FloatBox& other) const {
#ifdef __SSE__
    __m128 in = _mm_cmple_ps(_mm_loadu_ps(low[0]), _mm_set1_ps(other.high[0]));
    in = _mm_and_ps(in, _mm_cmpge_ps(_mm_loadu_ps(high[0]), _mm_set1_ps(other.low[0])));
    for (int k = 1; k < 3; ++k) {
      in = _mm_and_ps(in, _mm_cmple_ps(_mm_loadu_ps(low[k]), _mm_set1_ps(other.high[k])));
      in = _mm_and_ps(in, _mm_cmpge_ps(_mm_loadu_ps(high[k]), _mm_set1_ps(other.low[k])));
    }
    return static_cast<unsigned>(_mm_movemask_ps(in));
#else
    unsigned bits = 0;
    for (std::uint32_t i = 0; i < kFour; ++i) {
      bool all = true;
      for (int k = 0; k < 3; ++k) all &= (low[k][i] <= other.high[k]) & (other.low[k] <= high[k][i]);
      bits |= static_cast<unsigned>(all) << i;
    }
    return bits;
#endif
  }
};

}  // namespace thicken::exact
