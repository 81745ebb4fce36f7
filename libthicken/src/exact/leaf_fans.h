// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The corners of four triangles whose fans are clear (clearFans()): two triangles that share one do not meet.
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include <cstdint>
#include <span>

#include "exact/box_order.h"
#include "thicken/mesh.h"

namespace thicken::exact {

struct LeafFans {
  static constexpr VertexId kNotClear = 0xffffffffu;
  VertexId corner[3][kLeafSize];

  void set(std::uint32_t i, const Triangle& t, std::span<const std::uint8_t> clear) {
    for (std::size_t k = 0; k < 3; ++k) corner[k][i] = clear[t[k]] != 0 ? t[k] : kNotClear;
  }
  void setNobody(std::uint32_t i) {
    for (auto& c : corner) c[i] = kNotClear;
  }
  /// Bit j: whether triangle j shares such a corner with triangle i of another leaf, or this one.
  [[nodiscard]] unsigned shared(const LeafFans& other, std::uint32_t i) const {
#ifdef __SSE2__
    const auto load = [&](int k) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(corner[k])); };
    const __m128i own[3] = {load(0), load(1), load(2)};
    __m128i any = _mm_setzero_si128();
    for (const auto& c : other.corner) {
      const __m128i v = _mm_set1_epi32(static_cast<int>(c[i]));
      const __m128i equal = _mm_or_si128(
          _mm_cmpeq_epi32(v, own[0]), _mm_or_si128(_mm_cmpeq_epi32(v, own[1]), _mm_cmpeq_epi32(v, own[2])));
      any = _mm_or_si128(any, _mm_andnot_si128(_mm_cmpeq_epi32(v, _mm_set1_epi32(-1)), equal));
    }
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(any)));
#else
    unsigned bits = 0;
    for (std::uint32_t j = 0; j < kLeafSize; ++j)
      for (const auto& c : other.corner)
        for (const auto& own : corner)
          bits |= static_cast<unsigned>(c[i] != kNotClear && c[i] == own[j]) << j;
    return bits;
#endif
  }
};

}  // namespace thicken::exact
