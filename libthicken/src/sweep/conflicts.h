// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Exact, incremental tests of a sweep whose copies move: which triangles meet, which have no area.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/box_tree.h"
#include "mesh/topology.h"
#include "sweep/swept_mesh.h"
#include "thicken/run_context.h"

namespace thicken::sweep {

/// What is wrong with a sweep at its present depths.
struct Conflicts {
  std::vector<exact::TrianglePair> pairs;  ///< triangles that meet, not both of S
  std::vector<TriangleId> flat;            ///< new triangles without area
  [[nodiscard]] bool empty() const { return pairs.empty() && flat.empty(); }
  /// Calls visit(t) for every triangle of a conflict, some more than once.
  template <class Visit>
  void forTriangles(Visit visit) const {
    for (const auto& [a, b] : pairs) {
      visit(a);
      visit(b);
    }
    for (const TriangleId t : flat) visit(t);
  }
};

/// Tests one sweep over and over while its depths change; its triangles must not.
class ConflictTester {
 public:
  ConflictTester(const SweptMesh& mesh, const RunContext& context, int threads);

  /// Tests everything.
  [[nodiscard]] Conflicts all();
  /// Tests what the copies `moved` (ascending) are part of, and keeps those of `before` that did
  /// not move.
  [[nodiscard]] Conflicts after(std::span<const std::uint32_t> moved, const Conflicts& before);

  /// Of the leaves of the tree that the tests are made with.
  [[nodiscard]] std::vector<TriangleId> order() const { return tree_.order(); }

  /// Copies that triangle `t` uses.
  template <class Visit>
  void forCopies(TriangleId t, Visit visit) const {
    for (const VertexId v : mesh_.triangles[t])
      if (mesh_.isCopy(v)) visit(static_cast<std::uint32_t>(v - mesh_.surfaceVertices));
  }

 private:
  [[nodiscard]] bool isFlat(TriangleId t) const;
  [[nodiscard]] std::vector<TriangleId> trianglesOf(std::span<const std::uint32_t> copies);

  const SweptMesh& mesh_;
  const RunContext& context_;
  int threads_;
  mesh::VertexTriangles around_;
  std::vector<std::uint8_t> mark_;
  exact::BoxTree tree_;
};

}  // namespace thicken::sweep
