// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sheets of a surface with edges of three and more triangles: which triangles go on straight there.
#pragma once

#include <array>
#include <vector>

#include "repair/workpiece.h"

namespace thicken::repairing {

/// An edge of three or more triangles.
struct NonManifoldEdge {
  std::vector<std::uint32_t> slots;        ///< all uses, as 3 · triangle + corner
  std::array<std::uint32_t, 2> through{};  ///< the two of them that the surface keeps
};

struct Sheets {
  std::vector<NonManifoldEdge> edges;
  std::vector<TriangleId> sheetOf;  ///< per triangle: the lowest of its sheet
  std::vector<double> areaAt;       ///< mm² per triangle: of the sheet that it belongs to
};

/// Pairs the triangles at such edges up: two patches that meet with the smallest bend, taken over all edges
/// that they share, go on into each other. Where bends differ by less than 15°, patches of one sense and then
/// larger ones come first.
/// Patches that go on into each other with a bend of less than 90° are one sheet, and each edge keeps
/// the pair of the sheet with the largest area.
[[nodiscard]] Sheets sheetsOf(const Workpiece& piece);

}  // namespace thicken::repairing
