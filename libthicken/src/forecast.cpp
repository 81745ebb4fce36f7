// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/forecast.h"

#include <algorithm>
#include <cmath>

#include "check/surface_facts.h"
#include "parallel/parallel_for.h"
#include "plan.h"
#include "reconstruct/working_set.h"

namespace thicken {

namespace {

// How many times as fast as one thread so many are.
double speedup(int threads) {
  constexpr double kShared = 0.88;  // of the work, as two threads take it (docs/performance.md)
  return 1 / (1 - kShared + kShared / parallel::threadCount(threads));
}

}  // namespace

SurfaceFacts sizesOf(const TriangleMesh& surface) {
  SurfaceFacts facts;
  facts.triangles = surface.triangles.size();
  facts.vertices = surface.positions.size();
  if (!surface.triangles.empty()) checking::addSizes(surface, facts);
  return facts;
}

Forecast forecast(const SurfaceFacts& surface, const Options& options) noexcept {
  if (options.gap > 0) {  // two runs, of surfaces alike, one after the other
    Options one = options;
    one.gap = 0;
    const Forecast solid = forecast(surface, one);
    one.thickness = options.gap;
    one.cell.reset();
    one.resolution.reset();
    const Forecast gap = forecast(surface, one);
    return {solid.seconds + gap.seconds, std::max(solid.bytes, gap.bytes),
            std::max(solid.leastBytes, gap.leastBytes)};
  }
  // Seconds of one thread: fitted to runs over every third surface of the test corpus, 1 and 3 % of the
  // diagonal thick, and to those of docs/performance.md.
  constexpr double kSecondsPerTriangle = 34e-6, kSecondsPerCrossing = 9e-6;
  // Bytes, measured over the same with a margin: positions, triangles, the two trees, adjacency, the audit's
  // edge table; and where there is a contour, a second boundary.
  constexpr std::size_t kBytesPerTriangle = 1500, kBesideContour = 1100, kBase = std::size_t{16} << 20;
  const std::size_t shells = options.side == Side::kBoth ? 2 : 1;
  const std::size_t swept = surface.triangles * (1 + shells) / 2;
  const double crossings = pipeline::predictedCrossings(surface, options);
  Forecast told;
  told.leastBytes = kBase + kBytesPerTriangle * swept;
  told.bytes = told.leastBytes + reconstruct::wholeBytes(static_cast<std::size_t>(crossings)) +
               (crossings > 0 ? kBesideContour * surface.triangles : 0);
  told.seconds = (kSecondsPerTriangle * static_cast<double>(swept) + kSecondsPerCrossing * crossings) /
                 speedup(options.threads);
  return told;
}

}  // namespace thicken
