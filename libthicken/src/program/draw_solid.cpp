// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/draw_solid.h"

namespace thicken::program {

Picture drawSolids(std::span<const TriangleMesh> solids, std::span<const std::vector<Region>> regions,
                   int width, int height) {
  View view;
  view.height = height;
  view.width = width < 2 * height ? width : width / 2;
  const Picture picture = renderSolids(solids, regions, view);
  if (view.width == width) return picture;
  view.width = width - view.width;
  view.towards = viewDirection(view.up, 210, -35);
  return besideEachOther(std::array{picture, renderSolids(solids, regions, view)});
}

}  // namespace thicken::program
