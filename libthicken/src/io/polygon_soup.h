// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What most formats hold: positions and polygons of any number of corners.
#pragma once

#include <span>
#include <vector>

#include "io/source_file.h"
#include "thicken/mesh.h"

namespace thicken::io {

struct PolygonSoup {
  std::vector<Vec3> positions;       ///< mm
  std::vector<VertexId> corners;     ///< of all polygons in sequence; every entry < positions.size()
  std::vector<std::uint32_t> sizes;  ///< corners of each polygon, ≥ 3
};

/// Splits every polygon into its number of corners less two triangles, in order. Throws
/// Error(kUnreadable) that names `file` for polygons beyond any drawing (a million corners, or so
/// entangled that splitting them would take minutes), and kTooLarge.
[[nodiscard]] TriangleMesh triangulated(PolygonSoup soup, const SourceFile& file);

/// Throws Error(kTooLarge) when `count` of `what` ("vertices") is more than 32-bit indices can name.
void requireNameable(std::size_t count, std::string_view what, const SourceFile& file);

}  // namespace thicken::io
