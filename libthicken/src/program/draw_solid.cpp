// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/draw_solid.h"

namespace thicken::program {

Picture drawSolids(std::span<const TriangleMesh> solids, std::span<const std::vector<Region>> regions,
                   int width, int height) {
  TriangleMesh all;
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const auto first = static_cast<VertexId>(all.positions.size());
    all.positions.insert(all.positions.end(), solids[i].positions.begin(), solids[i].positions.end());
    for (const auto& [a, b, c] : solids[i].triangles)
      all.triangles.push_back({first + a, first + b, first + c});
    const std::vector<Colour> own = coloursOf(regions[i]);
    colours.insert(colours.end(), own.begin(), own.end());
  }
  View view;
  view.height = height;
  if (width < 2 * height) {
    view.width = width;
    return renderPicture(all, colours, view);
  }
  view.width = width / 2;
  View other = view;
  other.width = width - view.width;
  other.towards = viewDirection(view.up, 210, -35);
  return besideEachOther(std::array{renderPicture(all, colours, view), renderPicture(all, colours, other)});
}

}  // namespace thicken::program
