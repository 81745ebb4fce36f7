// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The facts about a finished solid: counts, volume, area, how far the shell is from its definition
// and how thin the solid gets.
#pragma once

#include <span>

#include "job/job.h"
#include "thicken/result.h"

namespace thicken::measure {

/// Signed volume (mm³) of a closed mesh, summed about its first vertex to keep digits.
[[nodiscard]] double volumeOf(const TriangleMesh& mesh);
/// Area (mm²).
[[nodiscard]] double areaOf(std::span<const Vec3> positions, const Triangle& triangle);
[[nodiscard]] double areaOf(const TriangleMesh& mesh);

/// Of a shell of very many triangles: whether the error is taken on all of them, for its largest value, or on
/// some tens of thousands, which have its mean and its 99th percentile as well.
enum class Measure : std::uint8_t { kRepresentative, kAll };

/// How far the vertices of a shell are from S, mm, and the triangle of S that is so far, by vertices of the
/// solid; infinite for others.
struct ShellDistances {
  std::vector<double> distance;
  std::vector<TriangleId> nearest;
};

/// Fills the output part of `solid.report` from the mesh, its regions and its depths. `known`: what is known
/// already, or nothing. Shell points whose closest point lies on the rim belong to the wall and do not count
/// as shell error (paper §4.2, Remark 4).
void measure(Solid& solid, const job::Job& job, ShellDistances known, Measure what);

}  // namespace thicken::measure
