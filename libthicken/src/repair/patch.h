// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A small part of a surface under repair, as a surface of its own.
#pragma once

#include <span>
#include <vector>

#include "mesh/topology.h"
#include "repair/workpiece.h"

namespace thicken::repairing {

struct Patch {
  TriangleMesh mesh;
  std::vector<VertexId> vertex;  ///< per vertex of `mesh`: its id in the whole
  std::vector<std::uint8_t>
      whole;  ///< per vertex of `mesh`: 1 where all triangles around it are in the patch
};

/// The triangles that are present within a few edges of `seeds` and of the triangles beside these, in
/// whatever sheet.
[[nodiscard]] Patch patchAround(const Workpiece& piece, const mesh::VertexTriangles& around,
                                std::span<const VertexId> seeds);

}  // namespace thicken::repairing
