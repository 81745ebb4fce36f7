// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/borders.h"

#include <algorithm>
#include <utility>

#include "mesh/half_edges.h"
#include "repair/notches.h"

namespace thicken::repairing {
namespace {

// A tooth is a triangle or two; more rounds would take a whole strip, triangle by triangle.
constexpr int kRounds = 2;

}  // namespace

void smoothBorders(Workpiece& piece, double most) {
  const std::size_t count = piece.mesh.triangles.size();
  std::vector<std::uint8_t> known(count);
  for (TriangleId t = 0; t < count; ++t) known[t] = piece.present[t] != 0 || leavesAHole(piece.reason[t]);
  const mesh::HalfEdges edges(piece.mesh.positions.size(), piece.mesh.triangles, known);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::pair<double, TriangleId>> teeth;
    for (TriangleId t = 0; t < count; ++t) {
      if (piece.present[t] == 0) continue;
      int holes = 0;
      const Triangle& c = piece.mesh.triangles[t];
      for (int k = 0; k < 3; ++k) {
        bool kept = false, gone = false;
        for (const auto& uses : {edges.uses(c[k], c[(k + 1) % 3]), edges.uses(c[(k + 1) % 3], c[k])})
          for (const mesh::HalfEdge& e : uses)
            if (e.triangle() != t) (piece.present[e.triangle()] != 0 ? kept : gone) = true;
        holes += gone && !kept;
      }
      if (holes >= 2) teeth.emplace_back(piece.area(t), t);
    }
    std::sort(teeth.begin(), teeth.end());
    for (const auto& [area, t] : teeth) {
      if (area > most) return;
      most -= area;
      piece.remove(t, RepairKind::kSmoothed);
    }
  }
}

}  // namespace thicken::repairing
