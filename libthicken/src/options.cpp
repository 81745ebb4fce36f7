// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/options.h"

namespace thicken {

std::string_view name(Side side) noexcept {
  switch (side) {
    case Side::kNegative:
      return "negative";
    case Side::kPositive:
      return "positive";
    case Side::kBoth:
      return "both";
  }
  return "unknown";
}

std::string_view name(Method method) noexcept {
  switch (method) {
    case Method::kAuto:
      return "auto";
    case Method::kSweep:
      return "sweep";
    case Method::kReconstruct:
      return "reconstruct";
  }
  return "unknown";
}

std::string_view name(Join join) noexcept {
  switch (join) {
    case Join::kMitre:
      return "mitre";
    case Join::kRound:
      return "round";
  }
  return "unknown";
}

std::string_view name(Simplify simplify) noexcept {
  switch (simplify) {
    case Simplify::kOff:
      return "off";
    case Simplify::kAuto:
      return "auto";
    case Simplify::kShell:
      return "shell";
  }
  return "unknown";
}

}  // namespace thicken
