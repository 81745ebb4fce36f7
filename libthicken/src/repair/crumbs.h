// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What comes off a surface where triangles are removed can be too small to be of any use.
#pragma once

#include <span>
#include <vector>

#include "repair/workpiece.h"

namespace thicken::repairing {

/// Per triangle the number of the connected part that it belongs to; parts are joined at vertices. Triangles
/// that are gone have a part of their own.
[[nodiscard]] std::vector<std::uint32_t> partsOfPiece(const Workpiece& piece);

/// Removes connected parts with an area of less than `least`, mm², or of a single triangle or parts of one,
/// that were joined to more before.
/// `before`: partsOfPiece() at that time; triangles that were added since are parts of earlier ones.
void dropCrumbs(Workpiece& piece, std::span<const std::uint32_t> before, double least);

}  // namespace thicken::repairing
