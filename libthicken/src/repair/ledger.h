// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The account of a repair: everything that was changed, by kind.
#pragma once

#include <map>

#include "repair/workpiece.h"
#include "thicken/repair.h"

namespace thicken::repairing {

class Ledger {
 public:
  Ledger() = default;
  /// Goes on with an earlier account.
  explicit Ledger(const RepairFacts& before);

  void add(RepairKind kind, TriangleId origin, double area, const Vec3& place);
  /// As add(), of a triangle that is gone.
  void addRemoved(RepairKind kind, TriangleId origin, double area, const Vec3& place);
  /// As add(), for triangles that are counted by something else than their number (addCount()).
  void addUncounted(RepairKind kind, TriangleId origin, double area, const Vec3& place);
  void addCount(RepairKind kind, std::size_t count) { changes_[kind].count += count; }

  /// Without what came of the surface.
  [[nodiscard]] RepairFacts facts(double weldDistance) &&;

 private:
  std::map<RepairKind, RepairChange> changes_;
  double largest_ = 0;  // mm², of the triangles that are gone
  Vec3 largestPlace_ = Vec3::Zero();
};

/// The surface that is left, without what is gone; parts of a divided triangle take its place. What
/// was done to `piece` is added to the ledger.
[[nodiscard]] RepairResult packed(const Workpiece& piece, double weldDistance, Ledger ledger);

/// `result` with the facts of its surface. Throws kInternal where check() does not accept it.
[[nodiscard]] RepairResult proved(RepairResult result, const RunContext& context, int threads);

}  // namespace thicken::repairing
