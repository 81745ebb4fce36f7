// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Drops copies that cannot stand anywhere and fills the holes they leave with triangulations of
// minimal area (Barequet & Sharir 1995).
#pragma once

#include "sweep/swept_mesh.h"

#include <cstdint>
#include <vector>

namespace thicken {

/// Drops `copies` and, where a hole would touch itself, the copies in its way; fills every hole
/// without an edge or a triangle that the mesh already has. Returns false, with the mesh as it was,
/// when a hole cannot be filled.
[[nodiscard]] bool dropAndRefill(SweptMesh& mesh, std::vector<std::uint32_t> copies);

}  // namespace thicken
