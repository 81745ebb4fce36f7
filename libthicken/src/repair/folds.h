// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a sweep found no room below, although the surface is valid: folds so sharp, or sheets so close,
// that the coordinates cannot hold a wall between them.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "mesh/topology.h"
#include "repair/workpiece.h"
#include "thicken/repair.h"

namespace thicken::repairing {

/// Opens folds of one surface, a few triangles at a time, as long as the sweep names places.
class FoldOpener {
 public:
  static constexpr int kMostAttempts = 16;

  /// The vertices of a small surface below which no solid can be made: none where one can. A whole
  /// surface takes long to sweep, and what changes is near the folds.
  using Trial = std::function<std::vector<VertexId>(const TriangleMesh&)>;

  explicit FoldOpener(Trial trial) : trial_(std::move(trial)) {}

  /// Goes on with the account of `before`, a repair of the surface. Around each of `vertices`, ids in its
  /// mesh, the triangle that is turned farthest from the others goes; where a place comes up again all
  /// triangles around it, and the next time those around them, too; so on while the trial of what is
  /// near names more. What touches in a point only afterwards is opened. Throws kNoSolid when nothing
  /// remains.
  [[nodiscard]] RepairResult open(const RepairResult& before, std::span<const VertexId> vertices,
                                  const RunContext& context, int threads);

 private:
  using Place = std::array<double, 3>;

  // How often this vertex or one beside it was named before.
  [[nodiscard]] int timesNamed(const TriangleMesh& mesh, const VertexTriangles& around, VertexId v) const;
  void removeAt(Workpiece& piece, const VertexTriangles& around, std::span<const VertexId> vertices);
  [[nodiscard]] std::vector<VertexId> stuckNear(const Workpiece& piece, const VertexTriangles& around,
                                                std::span<const VertexId> seeds) const;

  Trial trial_;
  std::map<Place, int> named_;
};

}  // namespace thicken::repairing
