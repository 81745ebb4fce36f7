// SPDX-License-Identifier: LGPL-2.1-or-later
//
// How far the shell is from its definition at most: not sampled, but proved for every point of every
// triangle.
//
// The distance to one triangle of S is convex. So over a part of the shell the distance to S is nowhere more
// than the least, over some triangles of S, of the largest at the part's corners. What it is at least is the
// distance of two triangles. Parts that neither settles are divided.
//
// Where the thickness varies, r(c(p)) over a part is bounded as well: c(p) lies on one of the triangles of S
// that are no farther from the part than its farthest point is from S, and on each of these it moves no
// faster than p does, so that r there differs from that of the part's middle by the slope times the part's
// radius at most. Over one triangle of S that is alone there, distance and r are both linear, and the corners
// tell all.
//
// A part that is nearer to S than asked counts, unless Definition 2 itself ends the solid there: where the
// front of another sheet is as near, ∂H is halfway between the two. That is proved, too: a short way out of
// the solid all of the part is outside of H, and as far to the inside all of it is in H. A shell that is
// merely too thin has H's material beyond it, and fails. (On both sides there are no fronts, and no
// exception.) Nor does a part count as too near whose closest points lie on the rim: it is the
// cross-section's (Remark 4).
#pragma once

#include <span>
#include <vector>

#include "job/job.h"
#include "thicken/result.h"

namespace thicken::measure {

struct ErrorBound {
  double most = 0;            ///< mm; no point of the shell that counts is farther off
  Vec3 place = Vec3::Zero();  ///< mm, where that is
};

/// The triangles of the shell for which boundShellError() finds more than `tolerance`, ascending.
[[nodiscard]] std::vector<TriangleId> shellBeyond(const job::Job& job, const TriangleMesh& solid,
                                                  std::span<const Region> region, double tolerance);

/// The bound for the shell of a valid solid. `most` is above `tolerance` (mm) only where that could not be
/// proved; then it is how far off the worst of the places is where the proof failed. Else it is above the
/// largest error there is by an eighth of the tolerance at most, or the tolerance itself where the solid ends
/// halfway to another sheet, or where the thickness varies.
[[nodiscard]] ErrorBound boundShellError(const job::Job& job, const TriangleMesh& solid,
                                         std::span<const Region> region, double tolerance);

}  // namespace thicken::measure
