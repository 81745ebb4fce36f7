// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/meetings.h"

#include <algorithm>

namespace thicken::checking {

Meetings meetingsOf(const exact::PairSearch& search, const RunContext& context, int threads) {
  constexpr std::size_t kCounted = 100000, kListed = Defect::kMaxListed / 2;
  Meetings result;
  result.pairs = search.all({}, context, threads, kCounted);
  result.count = result.pairs.size();
  if (result.count > kCounted) {
    // which pairs come first depends on the threads: one thread finds the same ones each time
    result.pairs = search.all({}, context, 1, kListed);
    result.count = kCounted;
    result.more = true;
  }
  if (result.pairs.size() > kListed) result.pairs.resize(kListed);
  return result;
}

Vec3 placeOf(const TriangleMesh& mesh, const exact::TrianglePair& pair) {
  Vec3 low = Vec3::Constant(-std::numeric_limits<double>::infinity()), high = -low;
  for (const TriangleId t : {pair.first, pair.second}) {
    const Triangle& c = mesh.triangles[t];
    const Vec3 &p = mesh.positions[c[0]], &q = mesh.positions[c[1]], &r = mesh.positions[c[2]];
    low = low.cwiseMax(p.cwiseMin(q).cwiseMin(r));
    high = high.cwiseMin(p.cwiseMax(q).cwiseMax(r));
  }
  return 0.5 * low + 0.5 * high;
}

}  // namespace thicken::checking
