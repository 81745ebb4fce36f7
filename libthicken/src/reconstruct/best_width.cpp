// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/best_width.h"

#include <utility>

namespace thicken {

Reconstruction bestOfWidths(double width, const std::function<bool(double width)>& isAllowed,
                            const std::function<Reconstruction(double width)>& make) {
  constexpr double kMuch = 0.1, kFiner = 0.6;
  constexpr int kMostTimes = 3;
  Reconstruction best = make(width);
  for (int i = 0; i < kMostTimes && best.leftShare > kMuch && isAllowed(width *= kFiner); ++i) {
    Reconstruction finer = make(width);
    if (finer.leftShare < best.leftShare) best = std::move(finer);
  }
  return best;
}

}  // namespace thicken
