// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a finished solid is like, wherever it comes from: whether it is valid, which shells it has,
// which of them enclose cavities, and how thick its walls are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thicken/error.h"
#include "thicken/mesh.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken {

/// One connected part of the boundary of a solid.
struct SolidShell {
  static constexpr std::uint32_t kNoShell = 0xffffffffu;

  std::size_t triangles = 0;
  double volume = 0;                ///< mm³, positive
  bool cavity = false;              ///< it encloses a hollow: nothing that is in there gets out
  std::uint32_t within = kNoShell;  ///< the nearest shell around it
};

struct Inspection {
  AuditFacts audit;             ///< surfaceKept is always true: there is no surface to keep
  std::vector<Defect> defects;  ///< what the audit found
  double volume = 0;            ///< mm³, cavities taken off
  double area = 0;              ///< mm²
  std::vector<std::uint32_t> shellOfTriangle;
  std::vector<SolidShell> shells;  ///< empty where the audit failed; numbered by first triangle
};

/// Audits `solid` by exact predicates, corners of equal coordinates being one vertex, and measures its
/// shells. Throws only kCancelled. Cost: O(n log n).
[[nodiscard]] Inspection inspect(const TriangleMesh& solid, RunContext context = {}, int threads = 0);

/// For each triangle, how far it is from its middle straight through the material to the boundary again,
/// mm; infinite where that is no wall:
/// - triangles with a corner in common do not count, nor what does not face the other way within 60 degrees;
/// - `isEdge`, empty or a number for each triangle, is not 0 for cross-sections, such as those at a rim and
///   within a drilled hole: no wall begins or ends there;
/// - a triangle has no area, or nothing lies opposite.
/// Throws only kCancelled. Cost: O(n log n), a ray for each triangle.
[[nodiscard]] std::vector<double> wallThickness(const TriangleMesh& solid, RunContext context = {},
                                                int threads = 0, std::span<const std::uint8_t> isEdge = {});

}  // namespace thicken
