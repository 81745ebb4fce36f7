// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Caps are triangles with a corner that nearly lies on their longest edge. They have no short edge to
// collapse, but with the edge turned, so that it ends in that corner, both triangles beside it are better.
#include <algorithm>

#include "simplify/collapse.h"

namespace thicken::simplify {

void Collapse::turnCaps() {
  for (TriangleId t = 0; t < mesh_.triangles.size(); ++t) {
    if (t % 256 == 0) job_.context.throwIfCancelled();
    if (!links_.isGone(t) && targets_.isDense[t]) turnEdge(t);
  }
}

// Turns the longest edge of a triangle if that is a needle and comes off better.
void Collapse::turnEdge(TriangleId t) {
  const auto corner = cornersOf(mesh_.triangles[t]);
  if (aspectOf(corner[0], corner[1], corner[2]) <= kNeedle) return;
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if ((corner[(k + 1) % 3] - corner[k]).norm() > (corner[(longest + 1) % 3] - corner[longest]).norm())
      longest = k;
  // On both sides rim edges of S lie within the wall.
  const Triangle& ends = mesh_.triangles[t];
  if (job_.options.side == Side::kBoth && ends[longest] < fixed_ && ends[(longest + 1) % 3] < fixed_) return;
  const TriangleId other = links_.neighbour(t, longest);
  if (region_[other] != region_[t] || !links_.canTurn(t, longest)) return;
  gatherNone();
  gather(t, false);
  gather(other, false);
  const auto turned = links_.turned(t, longest);
  double worst = 0;
  for (int i = 0; i < 2; ++i) {
    const auto [p, q, s] = cornersOf(turned[i]);
    worst = std::max(worst, aspectOf(p, q, s));
    changed_[i].corners = turned[i];
  }
  if (worst >= oldAspect_ || !areRight(turned[0][2], false)) return;
  links_.turn(t, longest);
  take();
}

}  // namespace thicken::simplify
