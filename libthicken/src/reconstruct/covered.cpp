// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/covered.h"

#include <algorithm>

#include "mesh/topology.h"

namespace thicken::reconstruct {

using mesh::kNone;

namespace {

struct BaseTriangle {
  Triangle corners;  // of S, ascending
  std::uint8_t kept;
};

Triangle ascending(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

}  // namespace

std::vector<std::uint8_t> coveredTriangles(const TriangleMesh& surface, const sweep::SweepResult& swept,
                                           std::span<const std::uint8_t> keep) {
  // Merged and dropped copies leave triangles of other corners, and other places, than S's.
  std::vector<BaseTriangle> copies;
  std::vector<std::uint8_t> hasKept(surface.positions.size(), 0), hasOpen(surface.positions.size(), 0);
  bool any = false;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (swept.region[t] != Region::kShell) continue;
    Triangle base{};
    bool isCopy = true;
    for (int k = 0; k < 3; ++k) {
      base[k] = swept.base[swept.mesh.triangles[t][k]];
      isCopy &= base[k] != kNone;
      if (base[k] != kNone) (keep[t] ? hasKept : hasOpen)[base[k]] = 1;
    }
    if (!isCopy) continue;
    any |= keep[t] != 0;
    copies.push_back({ascending(base), keep[t]});
  }
  std::vector<std::uint8_t> covered(surface.triangles.size(), 0);
  if (!any) return covered;
  std::sort(copies.begin(), copies.end(),
            [](const BaseTriangle& a, const BaseTriangle& b) { return a.corners < b.corners; });
  for (std::size_t t = 0; t < covered.size(); ++t) {
    const Triangle own = ascending(surface.triangles[t]);
    const auto copy =
        std::lower_bound(copies.begin(), copies.end(), own,
                         [](const BaseTriangle& c, const Triangle& x) { return c.corners < x; });
    const auto is = [&](std::span<const std::uint8_t> has) {
      return std::any_of(own.begin(), own.end(), [&](VertexId v) { return has[v] != 0; });
    };
    covered[t] = copy != copies.end() && copy->corners == own ? copy->kept : is(hasKept) && !is(hasOpen);
  }
  return covered;
}

}  // namespace thicken::reconstruct
