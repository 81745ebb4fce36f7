// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A part of a surface, cut out along lines that run on it (paper §1, Figure 2): a patch of a scanned head.
// Every triangle that no line divides stays bit for bit, and the part has passed the exact check.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/run_context.h"
#include "thicken/surface_facts.h"

namespace thicken {

/// The points of a closed line near the surface, mm. The last is joined to the first.
using TrimLoop = std::vector<Vec3>;

struct TrimOptions {
  /// mm: the part that stays is the one at the surface's closest point to this. Without it, the one inside:
  /// of the parts that every loop borders that with the least length of the surface's own rims, of equal ones
  /// the smallest.
  std::optional<Vec3> keep;
  int smooth =
      0;  ///< rounds of rounding the corners of the loops, which still lead through their points; 0 to 5
  Precision precision = Precision::kDouble;
};

/// What was done, for reports.
struct TrimFacts {
  SurfaceFacts input;    ///< of the surface as it was given
  SurfaceFacts surface;  ///< of the part
  struct Loop {
    std::size_t points = 0;  ///< that the path leads through
    double length = 0;       ///< mm, of the path
    double farthest = 0;     ///< mm, from a point of the loop to the surface
  };
  std::vector<Loop> loops;
  std::size_t untouched = 0;  ///< triangles of the part that are the surface's own
  std::size_t divided = 0;    ///< triangles of the part that are pieces of divided ones
  /// mm, the farthest that a corner of the rim is from its exact place on the path: rounding to float, and
  /// corners that were moved onto a vertex nearby.
  double deviation = 0;
  std::vector<std::string> warnings;  ///< complete sentences
};

struct TrimmedSurface {
  TriangleMesh mesh;               ///< untouched triangles first, in their order
  std::vector<TriangleId> origin;  ///< per triangle: the one of weld(surface) that it is, or is a piece of
  std::vector<TrimLoop> paths;     ///< for each loop the corners of its path on the surface, mm
  TrimFacts facts;
};

/// Cuts out of `surface` the part that `loops` border. Corners with equal coordinates are one vertex.
///
/// Each point of a loop goes to the closest point of the surface. Between two of them the path is the cut of
/// the surface with the plane through both along the mean of their normals. Where that is longer than four
/// times their distance or does not arrive, the path also leads through the middle of the shortest way along
/// edges. Triangles along the path are divided; new corners hold float values.
///
/// Of the surface it is asked that it is manifold, oriented and without degenerate triangles; that triangles
/// meet is refused only in the part that stays.
///
/// Throws Error: the codes of check(), for the surface and for the part; kInvalidArgument for options out of
/// range and, with a defect that has the place, where a path leaves the surface, crosses or touches a path,
/// or does not cut a part off; kCancelled; kMemoryLimit. Cost: O(n log n).
[[nodiscard]] TrimmedSurface trim(const TriangleMesh& surface, std::span<const TrimLoop> loops,
                                  const TrimOptions& options = {}, RunContext context = {}, int threads = 0);

/// Paths on one surface, for showing them while points are set.
class SurfacePaths {
 public:
  /// The surface as for trim(). Throws the codes of check().
  explicit SurfacePaths(const TriangleMesh& surface, int threads = 0);
  ~SurfacePaths();
  SurfacePaths(SurfacePaths&&) noexcept;
  SurfacePaths& operator=(SurfacePaths&&) noexcept;

  /// The corners of the path that trim() takes through `points`; open: from the first to the last of them.
  /// Throws Error(kInvalidArgument).
  [[nodiscard]] TrimLoop path(std::span<const Vec3> points, bool closed, int smooth = 0) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Reads a loop: a text file with a point on each line, three numbers with blanks between; what follows a #
/// is a comment. A last point that equals the first is left out. Throws Error(kUnreadable).
[[nodiscard]] TrimLoop readLoop(const std::filesystem::path& path);

}  // namespace thicken
