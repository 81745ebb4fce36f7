// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A surface under repair. Triangles stay in the list and are marked as gone, with the reason. So ids stay,
// and every step can be undone.
#pragma once

#include <vector>

#include "thicken/mesh.h"
#include "thicken/repair.h"

namespace thicken::repairing {

struct Workpiece {
  TriangleMesh mesh;
  std::vector<TriangleId> origin;     ///< RepairResult::origin
  std::vector<std::uint8_t> present;  ///< 0: gone
  std::vector<RepairKind> reason;     ///< where it is gone or new: why
  std::vector<std::uint8_t> turned;   ///< 1: of the other sense than in the input

  explicit Workpiece(TriangleMesh surface);

  void remove(TriangleId t, RepairKind why);
  void turn(TriangleId t);
  /// Adds a triangle that is a part of triangle `whole`.
  void addPart(const Triangle& part, TriangleId whole);
  /// Adds a triangle that is none of the input's.
  void addNew(const Triangle& corners, RepairKind why);

  [[nodiscard]] double area(TriangleId t) const;
  /// The middle of the triangle, mm.
  [[nodiscard]] Vec3 middle(TriangleId t) const;
};

}  // namespace thicken::repairing
