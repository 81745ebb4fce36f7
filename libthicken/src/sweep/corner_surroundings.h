// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the copies of the triangles around one vertex must not meet: S there, and the copies of those
// triangles that only share a vertex with them.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "sweep/copied_shell.h"

namespace thicken::sweep {

class CornerSurroundings {
 public:
  /// Of vertex `v` of S with the fan `fan`; `faceNormal`, `around`: of S. All but `around` and `mesh` must
  /// outlive this.
  CornerSurroundings(const CopiedShell& shell, const SweptMesh& mesh, std::span<const Vec3> faceNormal,
                     const mesh::VertexTriangles& around, VertexId v, const Fan& fan);

  /// How often the copies of the fan meet the surroundings and each other with `chains` at the vertex.
  /// Nothing where one of them is folded over, or where there are more than 128 triangles of S to look at.
  std::optional<std::size_t> meetings(const std::vector<CopiedShell::Chain>& chains);

 private:
  using Box = Eigen::AlignedBox3d;

  [[nodiscard]] Box boxOf(const Triangle& t) const;
  VertexId vertex(std::uint64_t key, const Vec3& p);

  /// Adds the polygon that a triangle of S is copied to; false where it is folded over.
  bool addCopy(TriangleId s, const CopiedShell::Chains& chains);

  const CopiedShell& shell_;
  std::span<const Vec3> normal_;
  VertexId v_;
  const Fan& fan_;
  bool tooMany_ = false;
  std::vector<Vec3> at_;
  std::vector<Triangle> triangles_;
  std::vector<Box> boxes_;
  std::unordered_map<std::uint64_t, VertexId> number_;
  std::vector<std::uint64_t> fresh_;  ///< keys that were added for the fan
};

}  // namespace thicken::sweep
