// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Folds so sharp, and sheets so close, that the coordinates cannot hold a wall below them, although the
// surface is valid. A sweep names them.
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

  /// Tries a small surface: the vertices below which no solid can be made, or none. It stands for the whole
  /// surface, which takes long to sweep: changes are near the folds.
  using Trial = std::function<std::vector<VertexId>(const TriangleMesh&)>;

  explicit FoldOpener(Trial trial) : trial_(std::move(trial)) {}

  /// Opens the surface around each of `vertices`, ids in the mesh of `before`, a repair of it. The first time
  /// the triangle whose normal deviates most is removed; the second time all triangles around the vertex;
  /// then those around them, and so on, until a trial sweep of the neighbourhood names no vertex. Vertices
  /// that are non-manifold afterwards are opened. Adds to the account of `before`. Throws kNoSolid if nothing
  /// remains.
  [[nodiscard]] RepairResult open(const RepairResult& before, std::span<const VertexId> vertices,
                                  const RunContext& context, int threads);

 private:
  using Place = std::array<double, 3>;

  // How often this vertex or one beside it was named before.
  [[nodiscard]] int timesNamed(const TriangleMesh& mesh, const mesh::VertexTriangles& around,
                               VertexId v) const;
  void removeAt(Workpiece& piece, const mesh::VertexTriangles& around, std::span<const VertexId> vertices);
  [[nodiscard]] std::vector<VertexId> stuckNear(const Workpiece& piece, const mesh::VertexTriangles& around,
                                                std::span<const VertexId> seeds) const;
  // The largest of the triangles that are gone come back where the trial names nothing.
  void putBackLargest(Workpiece& piece, const mesh::VertexTriangles& around) const;

  Trial trial_;
  std::map<Place, int> named_;
};

}  // namespace thicken::repairing
