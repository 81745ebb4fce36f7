// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The copies of S's triangles on one side. A corner of a copied triangle is a chain of offset vertices: one,
// or several if the vertex was divided.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "mesh/topology.h"
#include "sweep/corner_planes.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

class CopiedShell {
 public:
  using Chain = std::vector<std::uint32_t>;  ///< copies
  using Chains = std::array<Chain, 3>;       ///< at the corners of a triangle of S, in its sense

  /// `firstCopy`: the copy of vertex 0 on this side. `sign`: -1 behind the normals, else 1. All that is given
  /// must outlive this.
  CopiedShell(const SweptMesh& mesh, const mesh::VertexTriangles& around, std::size_t firstCopy, double sign)
      : sign_(sign), firstCopy_(firstCopy), around_(around), of_(mesh) {
    listCopied();
  }

  /// To be called when the triangles of the mesh have changed.
  void listCopied();

  /// Where a copy stands at its depth.
  [[nodiscard]] Vec3 placeOf(std::size_t copy) const;

  /// The copies at the corners of a triangle of S.
  [[nodiscard]] Chains chainsOf(TriangleId s) const;

  /// The copies of `v` at each triangle of its fan.
  [[nodiscard]] std::vector<Chain> chainsAt(VertexId v, const Fan& fan) const;

  /// Whether all that the triangle was copied to is there, with no other vertices.
  [[nodiscard]] bool isCopied(TriangleId s) const;

  /// The fan of a vertex; nothing unless all its triangles are copied.
  [[nodiscard]] std::optional<Fan> copiedFan(VertexId v) const;

  /// Which corner of a triangle of S a vertex is.
  [[nodiscard]] int cornerOf(TriangleId s, VertexId v) const;

 protected:
  double sign_;
  std::size_t firstCopy_;
  const mesh::VertexTriangles& around_;
  std::vector<std::vector<TriangleId>> copied_;    ///< per triangle of S: what it is copied to
  std::unordered_map<TriangleId, Chains> chains_;  ///< of triangles with a vertex that was divided
  std::unordered_set<TriangleId> changed_;         ///< whose polygon is not in the mesh yet

 private:
  [[nodiscard]] bool isOfThisShell(const Triangle& t) const;

  const SweptMesh& of_;
};

/// The triangulation of a small plane polygon with the shortest chords whose triangles all face along
/// `normal`; empty where there is none.
[[nodiscard]] std::vector<std::array<int, 3>> triangulated(const std::vector<Vec3>& p, const Vec3& normal);

}  // namespace thicken::sweep
