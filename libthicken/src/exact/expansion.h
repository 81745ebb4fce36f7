// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Expansion arithmetic: an exact real number as a sum of doubles that do not overlap, smallest
// first, without zeros (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", 1997). Exact in round-to-nearest while nothing over- or underflows; the
// compiler must not contract a * b + c (-ffp-contract=off).
#pragma once

#include "exact/domain.h"

namespace thicken::exact {

/// At most `Capacity` terms; no terms mean 0.
template <int Capacity>
struct Expansion {
  double term[Capacity];
  int size = 0;

  void append(double value) {
    if (value != 0) term[size++] = value;
  }
  /// The largest term carries the sign of the sum.
  [[nodiscard]] int sign() const { return size == 0 ? 0 : (term[size - 1] > 0 ? 1 : -1); }
  /// The sum to within a few ulp.
  [[nodiscard]] double estimate() const {
    double sum = 0;
    for (int i = 0; i < size; ++i) sum += term[i];
    return sum;
  }
};

/// A rounded result and the error that the rounding made: value + error is exact.
struct Rounded {
  double value, error;
};

inline Rounded twoSum(double a, double b) {
  const double x = a + b;
  const double bVirtual = x - a;
  const double aVirtual = x - bVirtual;
  return {x, (a - aVirtual) + (b - bVirtual)};
}

/// As twoSum, for |a| >= |b| or a == 0.
inline Rounded fastTwoSum(double a, double b) {
  const double x = a + b;
  return {x, b - (x - a)};
}

/// A double as a sum of two halves of 26 bits, whose products are exact (Dekker, Veltkamp).
inline Rounded split(double a) {
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1
  const double c = kSplitter * a;
  const double high = c - (c - a);
  return {high, a - high};
}

inline Rounded twoProduct(double a, double b) {
  const double x = a * b;
  const Rounded p = split(a), q = split(b);
  const double rest = ((x - p.value * q.value) - p.error * q.value) - p.value * q.error;
  return {x, p.error * q.error - rest};
}

/// a − b as an expansion of at most two terms.
inline Expansion<2> difference(double a, double b) {
  const Rounded r = twoSum(a, -b);
  Expansion<2> e;
  e.append(r.error);
  e.append(r.value);
  return e;
}

template <int N>
Expansion<N> operator-(const Expansion<N>& e) {
  Expansion<N> r;
  r.size = e.size;
  for (int i = 0; i < e.size; ++i) r.term[i] = -e.term[i];
  return r;
}

/// Merges the terms by magnitude and renormalises (Shewchuk's FAST-EXPANSION-SUM).
template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> r;
  int i = 0, j = 0;
  // |a| > |b|, written without fabs so that terms of equal size come from f first
  const auto smallest = [&] {
    if (j == f.size) return e.term[i++];
    if (i == e.size) return f.term[j++];
    const double a = e.term[i], b = f.term[j];
    return (b > a) == (b > -a) ? e.term[i++] : f.term[j++];
  };
  const int total = e.size + f.size;
  if (total == 0) return r;
  double carry = smallest();
  for (int k = 1; k < total; ++k) {
    const double next = smallest();
    // the first sum may be fast: its terms come in order of magnitude
    const Rounded s = k == 1 ? fastTwoSum(next, carry) : twoSum(carry, next);
    r.append(s.error);
    carry = s.value;
  }
  r.append(carry);
  return r;
}

template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  return e + (-f);
}

/// Shewchuk's SCALE-EXPANSION.
template <int N>
Expansion<2 * N> scale(const Expansion<N>& e, double b) {
  Expansion<2 * N> r;
  if (e.size == 0 || b == 0) return r;
  const Rounded first = twoProduct(e.term[0], b);
  r.append(first.error);
  double carry = first.value;
  for (int i = 1; i < e.size; ++i) {
    const Rounded product = twoProduct(e.term[i], b);
    const Rounded low = twoSum(carry, product.error);
    r.append(low.error);
    const Rounded high = fastTwoSum(product.value, low.value);
    r.append(high.error);
    carry = high.value;
  }
  r.append(carry);
  return r;
}

template <int N>
Expansion<2 * N> operator*(const Expansion<N>& e, const Expansion<1>& f) {
  return f.size == 0 ? Expansion<2 * N>{} : scale(e, f.term[0]);
}

template <int N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Expansion<2>& f) {
  Expansion<4 * N> r;
  if (f.size == 0) return r;
  const Expansion<2 * N> low = scale(e, f.term[0]);
  if (f.size == 2) return low + scale(e, f.term[1]);
  r.size = low.size;
  for (int i = 0; i < low.size; ++i) r.term[i] = low.term[i];
  return r;
}

}  // namespace thicken::exact
