// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The triangle mesh that every function of this library takes and returns: positions in
// millimetres and triangles as triples of indices into them, counter-clockwise seen from the side
// that the normal points to.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace thicken {

using Vec3 = Eigen::Vector3d;
using VertexId = std::uint32_t;
using TriangleId = std::uint32_t;
using Triangle = std::array<VertexId, 3>;

struct TriangleMesh {
  std::vector<Vec3> positions;      ///< mm
  std::vector<Triangle> triangles;  ///< every entry < positions.size()
};

}  // namespace thicken
