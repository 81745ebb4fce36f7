// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Counts and sizes of a surface.
#pragma once

#include <cstddef>

namespace thicken {

/// What is known of a surface.
struct SurfaceFacts {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::size_t rims = 0;  ///< closed boundary loops
  std::size_t components = 0;
  bool closed = false;
  double area = 0;      ///< mm²
  double diagonal = 0;  ///< mm, of the bounding box
  double meanEdge = 0;  ///< mm
};

}  // namespace thicken
