// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <fmt/format.h>

#include <string>

#include "thicken/mesh.h"

namespace thicken::mesh {

/// A point as it stands in sentences.
[[nodiscard]] inline std::string text(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}

}  // namespace thicken::mesh
