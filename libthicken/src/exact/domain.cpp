// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/domain.h"

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "thicken/error.h"

namespace thicken::exact {
namespace {

enum Flaw : int { kNone, kRounding, kSubnormals, kContraction };

std::uint64_t magnitude(double x) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63;
  return std::bit_cast<std::uint64_t>(x) & ~kSign;
}

// A fused a * b + c rounds once; separate operations round twice. No volatile in between: the compiler must
// be free to contract here as it is in the predicates.
[[gnu::noinline]] double productAndSum(double a, double b, double c) {
  return a * b + c;
}

// What is wrong with the arithmetic of this thread. Volatile: it has to be found out while it runs.
Flaw flawOfThisThread() {
  const volatile double one = 1, half = 0x1p-54, least = std::numeric_limits<double>::min();
  // A quarter of the step above 1, and half of the one below it: nearest, and of two the even one, is 1.
  const volatile double up = one + half, down = one - half, below = -one - half;
  if (up != one || down != one || below != -one) return kRounding;
  const volatile double subnormal = least / 4;
  const volatile double again = subnormal * 0x1p60;
  if (again != least * 0x1p58) return kSubnormals;
  const volatile double more = 1 + 0x1p-30, less = 1 - 0x1p-30;  // the product is 1 - 2^-60
  return productAndSum(more, less, -one) == 0 ? kNone : kContraction;
}

const char* sentenceOf(Flaw flaw) {
  switch (flaw) {
    case kRounding:
      return "the process does not round to the nearest number, which exact decisions need; another library "
             "in "
             "it has changed that: restart the program without it";
    case kSubnormals:
      return "the process takes very small numbers for 0 (flush-to-zero), which exact decisions cannot "
             "allow; "
             "another library in it, built with -ffast-math, has changed that: restart the program without "
             "it";
    default:
      return "the library was built so that products and sums are rounded together, which exact decisions "
             "cannot allow; build it with -ffp-contract=off";
  }
}

}  // namespace

bool inDomain(const Vec3& p) {
  constexpr std::uint64_t kLeast = std::bit_cast<std::uint64_t>(kLeastCoordinate);
  constexpr std::uint64_t kMost = std::bit_cast<std::uint64_t>(kLargestCoordinate);
  for (int k = 0; k < 3; ++k) {
    const std::uint64_t size = magnitude(p[k]);
    if (size != 0 && (size < kLeast || size > kMost)) return false;
  }
  return true;
}

void requireExactArithmetic() {
  if (const Flaw flaw = flawOfThisThread(); flaw != kNone)
    throw Error(ErrorCode::kArithmetic, sentenceOf(flaw));
}

}  // namespace thicken::exact
