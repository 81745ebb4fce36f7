// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The rims of a surface under repair that is valid by now, and what may be added between them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "mesh/bounds.h"
#include "mesh/topology.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

/// rimOf() what is present; `triangle` is an id in the workpiece.
[[nodiscard]] mesh::Rim openRimsOf(const Workpiece& piece, int threads);

/// Adds triangles to a valid surface that meet nothing of it. Exact.
class Additions {
 public:
  Additions(Workpiece& piece, int threads);

  /// Whether no triangle of the patch is without area, and none meets another of it, the surface, or what was
  /// added before.
  [[nodiscard]] bool fits(const std::vector<Triangle>& patch) const;
  /// Whether the triangle has an area and meets nothing of the surface as it was at first.
  [[nodiscard]] bool isFree(const Triangle& triangle) const;
  /// Requires fits().
  void add(const std::vector<Triangle>& patch, RepairKind why);

 private:
  struct Patch {
    std::vector<Triangle> triangles;
    mesh::Bounds box;
    exact::BoxTree tree;
  };

  Workpiece& piece_;
  std::vector<Triangle> surface_;
  exact::BoxTree tree_;
  std::vector<Patch> added_;
};

}  // namespace thicken::repairing
