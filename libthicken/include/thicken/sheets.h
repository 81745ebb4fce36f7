// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Surfaces of several sheets, such as a hull with its bulkheads: three and more triangles at an edge. No
// single solid keeps them all, but each sheet has one of its own.
#pragma once

#include <vector>

#include "thicken/mesh.h"

namespace thicken {

struct Sheet {
  TriangleMesh mesh;
  std::vector<TriangleId> origin;  ///< per triangle of `mesh`: its id in the whole
};

/// Divides a surface at its edges of three and more triangles. What meets there with the smallest bend goes
/// on as one sheet where that is less than 90° (docs/repair.md); what shares nothing but vertices is two.
/// Every triangle is in one sheet. The largest by area comes first. Corners with equal coordinates have to be
/// one vertex already (weld()). A sheet may have other defects: check() it.
[[nodiscard]] std::vector<Sheet> divideIntoSheets(const TriangleMesh& surface);

}  // namespace thicken
