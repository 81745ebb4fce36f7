// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The parts that paths divide a surface into.
#pragma once

#include <set>
#include <vector>

#include "thicken/trim.h"
#include "trim/divided_surface.h"
#include "trim/plane_cut.h"

namespace thicken::trimming {

/// Triangles are of one part where edges lead from one to the other without crossing a path.
class Parts {
 public:
  Parts(const DividedSurface& surface, const PathMarks& marks,
        const std::vector<std::vector<VertexId>>& paths);

  [[nodiscard]] std::uint32_t at(TriangleId t) const { return partOf_[t]; }
  /// Of the parts that all loops border the one with the least length of the surface's own rims. Of equal
  /// ones the smallest. Throws Error(kInvalidArgument) if there is none.
  [[nodiscard]] std::uint32_t inside() const;
  /// The loops that have the part on both of their sides, and those that have it on none.
  [[nodiscard]] std::vector<std::size_t> loopsWithin(std::uint32_t part) const;
  [[nodiscard]] std::vector<std::size_t> loopsAwayFrom(std::uint32_t part) const;
  /// Writes the part into the mesh, the origins and the counts of `result`.
  void extract(std::uint32_t part, TrimmedSurface& result) const;

 private:
  void fill(TriangleId start, std::uint32_t part, const PathMarks& marks);

  const DividedSurface& surface_;
  std::vector<std::uint32_t> partOf_;
  std::vector<double> area_, rim_;                     // of each part; mm of the surface's own rims
  std::vector<std::set<std::uint32_t>> left_, right_;  // of each loop
  std::vector<Vec3> place_;                            // on each loop
};

}  // namespace thicken::trimming
