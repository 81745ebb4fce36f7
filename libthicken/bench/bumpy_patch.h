// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A surface of any size for measuring: a sheet of 100 × 100 mm with bumps that are wide enough for a
// millimetre of thickness, and with the roughness of a scan.
#pragma once

#include <cmath>

#include "thicken/mesh.h"

namespace thicken {

/// 2·n² triangles, normals upward; the same on every machine but for the last bits of sin().
inline TriangleMesh bumpyPatch(VertexId n) {
  constexpr double kSize = 100;
  const double step = kSize / n;
  // Golden-ratio steps are even and repeat nowhere.
  const auto rough = [](double i) {
    return i * 0.6180339887498949 - std::floor(i * 0.6180339887498949) - 0.5;
  };
  TriangleMesh mesh;
  for (VertexId j = 0; j <= n; ++j)
    for (VertexId i = 0; i <= n; ++i) {
      const double x = step * i, y = step * j;
      const double bump = 2 * std::sin(0.4 * x) * std::cos(0.35 * y) + 6 * std::sin(0.05 * x + 0.03 * y);
      mesh.positions.emplace_back(x, y, bump + 0.05 * step * rough(double(j) * (n + 1) + i));
    }
  for (VertexId j = 0; j < n; ++j)
    for (VertexId i = 0; i < n; ++i) {
      const VertexId a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  return mesh;
}

}  // namespace thicken
