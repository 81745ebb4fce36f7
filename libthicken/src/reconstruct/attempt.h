// SPDX-License-Identifier: LGPL-2.1-or-later
//
// One attempt at a whole boundary from pieces of the sweep: carrier, contour, shape, exact tests. Attempts
// follow each other with more of the sweep or shorter walls. They keep what an earlier one computed and
// proved.
#pragma once

#include <span>
#include <vector>

#include "reconstruct/assembly.h"
#include "reconstruct/contourer.h"
#include "reconstruct/deep_walls.h"
#include "reconstruct/settle.h"

namespace thicken::reconstruct {

class Attempt {
 public:
  /// All arguments by reference must outlive the attempt. `width` is the cells', mm; `cut` where `swept` is a
  /// window of a boundary, else null.
  Attempt(const job::Job& job, const sweep::SweepResult& swept, double width, const WorkingSet& working,
          const Cut* cut);

  /// Makes the boundary from the triangles of the sweep that `keep` marks (S's among them). Returns the
  /// triangles of assembly() that meet others, ascending; none: it is done. Throws kNoSolid where a contour
  /// would leave the zone of its window.
  [[nodiscard]] std::vector<TriangleId> run(std::span<const std::uint8_t> keep);

  /// Draws back walls at whose ends triangles meet, which gives the contour room. Returns whether any moved.
  bool liftWalls(std::span<const TriangleId> meeting);

  [[nodiscard]] const Assembly& assembly() const { return assembly_; }
  /// Triangles of the contour on edges that more than two share, ascending.
  [[nodiscard]] std::vector<TriangleId> nonManifoldTriangles() const;
  /// assembly(), moved out. No run() may follow.
  [[nodiscard]] Assembly takeAssembly() { return std::move(assembly_); }
  /// The carrier before its walls were drawn back with the contour. It has no triangles any more, and after a
  /// run() that returned none it has no positions either.
  [[nodiscard]] const Carrier& carrier() const { return carrier_; }
  [[nodiscard]] const field::NodeField& field() const { return contourer_.field(); }

 private:
  [[nodiscard]] Vec3 pushedToShell(const Vec3& from) const;
  [[nodiscard]] contour::Seeds openShell(std::span<const std::uint8_t> keep);

  DeepWalls walls_;
  Contourer contourer_;
  const job::Job& job_;
  const sweep::SweepResult& swept_;
  double width_;
  WorkingSet working_;
  const Cut* cut_;
  std::vector<Vec3> pushed_;  ///< per vertex of the sweep, as far as an attempt asked for it; else infinite
  ProvedTriangles proved_;
  Assembly assembly_;
  Carrier carrier_;
};

}  // namespace thicken::reconstruct
