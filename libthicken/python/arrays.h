// SPDX-License-Identifier: LGPL-2.1-or-later
//
// NumPy arrays to meshes and back, whole arrays at a time.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/result.h"

namespace thicken::python {

/// Copies `vertices` (n × 3 numbers of any real type and memory layout, mm) and `triangles` (m × 3
/// integers of any type and layout). Raises TypeError for other types and ValueError for other
/// shapes and for indices out of range; whether coordinates are finite is check()'s to say.
[[nodiscard]] TriangleMesh meshFrom(const pybind11::handle& vertices, const pybind11::handle& triangles);

/// n × 3 float64. The array takes over the memory of `positions`.
[[nodiscard]] pybind11::array positionArray(std::vector<Vec3> positions);

/// m × 3 int64, so that the array can be used as an index as it is.
[[nodiscard]] pybind11::array triangleArray(const std::vector<Triangle>& triangles);

/// m uint8: the values of Region.
[[nodiscard]] pybind11::array regionArray(const std::vector<Region>& regions);

/// The regions of m numbers. Raises ValueError for others than values of Region.
using RegionArray = pybind11::array_t<std::uint8_t, pybind11::array::c_style | pybind11::array::forcecast>;
[[nodiscard]] std::vector<Region> regionsFrom(const RegionArray& array);

/// n float64. The array takes over the memory of `numbers`.
[[nodiscard]] pybind11::array numberArray(std::vector<double> numbers);

}  // namespace thicken::python
