// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A solid that begins at a gap from S: the shell of the solid of S that is as thick as the gap is a surface
// of its own, and it is thickened in the place of S.
#pragma once

#include <optional>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken {

struct GapFacts {
  double asked = 0;                ///< mm
  double least = 0;                ///< mm, from a corner of the solid to S
  Vec3 leastPlace = Vec3::Zero();  ///< mm, where that is
  double shortShare = 0;           ///< share of the area of S with room for less than 0.9 of it
  ErrorFacts error;                ///< |distance to S − gap| / gap over the gap surface, away from the rim
  double leftOut = 0;              ///< mm² of shreds of the shell that are no part of the gap surface
  SurfaceFacts surface;            ///< of the gap surface
};

struct GapSolid {
  /// `Report::input`, `nearRims` and `repair` are about S, everything else about the gap surface, which the
  /// solid keeps bit for bit. `Solid::repaired` is what was made of S.
  Solid solid;
  TriangleMesh surface;  ///< the gap surface; its normals point as those of S
  GapFacts facts;
};

/// As thicken(), but that the solid begins `gap` mm from S, on the side that the options name, and not at S.
/// The gap surface is round beside edges of S unless the options have a join; cells and a resolution are of
/// the solid. Where there is no room, the gap is less, as the thickness would be.
///
/// `begin` and `end`: the part of the caller's progress that the run is (RunContext::setPart()).
///
/// Throws Error as thicken() does; kInvalidArgument for a gap that is not above 0, and for Side::kBoth.
[[nodiscard]] GapSolid thickenAtGap(const TriangleMesh& surface, double gap, const Options& options,
                                    RunContext context = {}, double begin = 0, double end = 1);

}  // namespace thicken
