// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The points of a shell at which its distance from S is measured.
#pragma once

#include <cstddef>

namespace thicken::measure {

/// Barycentric: the middle of a triangle and the middles of its three corner pieces.
inline constexpr std::size_t kMostShellSamples = 4;
inline constexpr double kShellSamples[kMostShellSamples][3] = {
    {1. / 3, 1. / 3, 1. / 3}, {2. / 3, 1. / 6, 1. / 6}, {1. / 6, 2. / 3, 1. / 6}, {1. / 6, 1. / 6, 2. / 3}};

/// How many of them a shell of so many triangles takes: of a large one, whose triangles are small, only
/// the middles.
inline std::size_t shellSamplesPerTriangle(std::size_t triangles) {
  return triangles > 50000 ? 1 : kMostShellSamples;
}

}  // namespace thicken::measure
