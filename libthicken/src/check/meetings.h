// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Finds self-intersections of a mesh, up to the number that a report lists. So a mesh in which all triangles
// meet costs neither time nor memory.
#pragma once

#include <span>

#include "exact/pair_search.h"
#include "thicken/error.h"
#include "thicken/mesh.h"

namespace thicken::checking {

struct Meetings {
  std::vector<exact::TrianglePair>
      pairs;  ///< sorted; the first ones found when there are more than can be listed
  std::size_t count = 0;
  bool more = false;  ///< `count` is only a lower bound
};

/// Same answer for any number of threads.
[[nodiscard]] Meetings meetingsOf(const exact::PairSearch& search, const RunContext& context, int threads);

/// A point near the place where two triangles meet: the centre of the intersection of their boxes, mm.
[[nodiscard]] Vec3 placeOf(const TriangleMesh& mesh, const exact::TrianglePair& pair);

}  // namespace thicken::checking
