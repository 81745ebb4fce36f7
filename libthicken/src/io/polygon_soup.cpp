// SPDX-License-Identifier: LGPL-2.1-or-later
#include "io/polygon_soup.h"

#include <algorithm>
#include <limits>

#include "io/polygon_triangulator.h"

namespace thicken::io {

void requireNameable(std::size_t count, std::string_view what, const SourceFile& file) {
  if (count >= std::numeric_limits<VertexId>::max()) {
    file.failTooLarge("holds " + std::to_string(count) + " " + std::string(what) +
                      ", more than 32-bit indices can name; split it or decimate it");
  }
}

TriangleMesh triangulated(PolygonSoup soup, const SourceFile& file) {
  requireNameable(soup.positions.size(), "vertices", file);
  // Σ (corners − 2)
  requireNameable(soup.corners.size() - 2 * soup.sizes.size(), "triangles", file);
  TriangleMesh mesh;
  mesh.triangles.reserve(soup.corners.size() - 2 * soup.sizes.size());
  PolygonTriangulator triangulator(soup.positions);
  std::size_t begin = 0;
  for (std::size_t face = 0; face < soup.sizes.size(); ++face) {
    const std::span<const VertexId> corners = std::span(soup.corners).subspan(begin, soup.sizes[face]);
    if (!triangulator.append(corners, mesh.triangles)) {
      file.fail("face " + std::to_string(face + 1) + " has " + std::to_string(corners.size()) +
                " corners, too many to split into triangles here; export the surface as triangles");
    }
    begin += corners.size();
  }
  mesh.positions = std::move(soup.positions);
  return mesh;
}

}  // namespace thicken::io
