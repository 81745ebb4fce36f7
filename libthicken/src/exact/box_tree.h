// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A bounding-volume hierarchy over the triangles of a mesh that finds pairs of triangles whose
// boxes overlap. Positions may move between queries (refit); the triangles may not.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/triangle_pair.h"
#include "thicken/mesh.h"
#include "thicken/run_context.h"

namespace thicken::exact {

class BoxTree {
 public:
  /// `active[t] == 0` leaves triangle t out (empty span: all are in). `order`: the leaves' order of a tree
  /// over as many triangles in nearly the same places; it saves the time to find one. It is ignored unless it
  /// names each active triangle once. Answers do not depend on it.
  BoxTree(std::span<const Vec3> positions, std::span<const Triangle> triangles, int threads,
          std::span<const std::uint8_t> active = {}, std::span<const TriangleId> order = {});
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  /// Takes new positions. `moved`: the triangles with a corner that moved (no others may have).
  void refit(std::span<const Vec3> positions, std::span<const Triangle> triangles,
             std::span<const TriangleId> moved);

  /// Leaves triangles out from now on. Boxes around them shrink where others near them are refitted.
  void drop(std::span<const TriangleId> triangles);

  /// All pairs of triangles that meet (exact::meet), sorted. `fixed[t] != 0` marks triangles known
  /// not to meet one another, such as those of a checked S: pairs of two fixed ones are skipped.
  /// Degenerate triangles are paired with nothing. Stops early (with at least one pair) once more
  /// than `limit` pairs are found; 0: no limit. Same answer for any number of threads when not limited.
  [[nodiscard]] std::vector<TrianglePair> meetingPairs(std::span<const Vec3> positions,
                                                       std::span<const Triangle> triangles,
                                                       std::span<const std::uint8_t> fixed,
                                                       const RunContext& context, int threads,
                                                       std::size_t limit = 0) const;

  /// The pairs of meetingPairs() in which at least one triangle is in `moved`.
  [[nodiscard]] std::vector<TrianglePair> meetingPairsWith(std::span<const TriangleId> moved,
                                                           std::span<const Vec3> positions,
                                                           std::span<const Triangle> triangles,
                                                           std::span<const std::uint8_t> fixed,
                                                           const RunContext& context, int threads) const;

  /// The triangles in the order of the leaves.
  [[nodiscard]] std::vector<TriangleId> order() const;

  /// The triangles whose boxes overlap the box from `low` to `high` (which may be infinite), among
  /// them all that reach into it, ascending.
  [[nodiscard]] std::vector<TriangleId> near(const Vec3& low, const Vec3& high) const;
  /// The same in some order, in the place of what `into` holds.
  void near(const Vec3& low, const Vec3& high, std::vector<TriangleId>& into) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thicken::exact
