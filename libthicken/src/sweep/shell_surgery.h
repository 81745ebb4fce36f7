// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Changes to the shell where no copy of a vertex can stand: copies are merged with a neighbour, or
// dropped and their hole filled, by one copy in the place of all that the hole lost or by a
// triangulation of minimal area (Barequet & Sharir 1995). Everything is tested exactly next to S: what
// is clear there stays clear for copies that draw back far enough.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mesh/topology.h"
#include "sweep/direction.h"
#include "sweep/swept_mesh.h"

namespace thicken::sweep {

class ShellSurgery {
 public:
  /// `around`: the triangles of S around its vertices.
  ShellSurgery(SweptMesh& mesh, const mesh::VertexTriangles& around);

  /// Puts one copy in the place of `copies`, which are connected, in the safest direction for the
  /// triangles that remain; copies around it that had no safe direction get one if they now can.
  /// Returns whether that is clear; otherwise the mesh is as it was.
  bool merge(std::span<const std::uint32_t> copies);

  /// Drops `copies` and, where a hole would touch itself, the copies in its way; fills every hole
  /// without an edge that the mesh already has. Returns the copies around the holes that cannot be
  /// filled: none when all is done; otherwise the mesh is as it was.
  [[nodiscard]] std::vector<std::uint32_t> drop(std::vector<std::uint32_t> copies);

  /// Copies that share a triangle with `copy`, nearest first.
  [[nodiscard]] std::vector<std::uint32_t> neighboursOf(std::uint32_t copy) const;

 private:
  using Loop = std::vector<VertexId>;
  // What one connected set of dropped copies leaves.
  struct Hole {
    std::vector<std::uint32_t> dropped;
    std::vector<TriangleId> removed;
    std::vector<Loop> loops;  // borders, in the sense of the removed triangles
  };
  // What takes the place of a hole.
  struct Patch {
    std::vector<Triangle> triangles;
    std::vector<std::pair<std::uint32_t, Copy>> aimed;  // copies that live on or aim elsewhere
  };
  class ShallowTest;

  [[nodiscard]] std::vector<Hole> holesOf(std::span<const std::uint32_t> dropped) const;
  [[nodiscard]] std::vector<VertexId> findLoops(Hole& hole) const;
  [[nodiscard]] bool open(std::vector<std::uint32_t> copies, std::vector<Hole>& holes,
                          std::vector<std::uint32_t>& around) const;
  [[nodiscard]] std::vector<Vec3> outwardNormals(VertexId v, const Hole& hole,
                                                 std::span<const Triangle> added) const;
  [[nodiscard]] bool centre(const Hole& hole, std::uint32_t at, Patch& patch) const;
  [[nodiscard]] bool triangulate(const Hole& hole, Patch& patch) const;
  void apply(std::span<const Hole> holes, std::span<const Patch> patches);

  [[nodiscard]] VertexId baseOf(VertexId v) const { return mesh_.isCopy(v) ? mesh_.copyOf(v).base : v; }
  [[nodiscard]] std::uint32_t copyId(VertexId v) const {
    return static_cast<std::uint32_t>(v - mesh_.surfaceVertices);
  }
  [[nodiscard]] std::vector<std::uint32_t> copiesAmong(std::span<const VertexId> vertices) const;

  SweptMesh& mesh_;
  const mesh::VertexTriangles& around_;
  mesh::VertexTriangles uses_;
};

}  // namespace thicken::sweep
