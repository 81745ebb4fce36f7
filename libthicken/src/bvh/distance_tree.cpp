// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/distance_tree.h"

#include <limits>

#include "bvh/distance_tree_inline.h"
#include "bvh/triangle_gap.h"

namespace thicken::bvh {

TriangleClosest DistanceTree::measure(const Vec3& p, TriangleId t) const {
  return closestOnTriangle(p, prepared_[placeOf_[t]], std::numeric_limits<double>::infinity());
}

// A box is as far as the one around the triangle along its axes.
DistanceTree::Four DistanceTree::squaredDistances(const Node& n, const Corners& t) {
  const auto four = [](const float* p) { return Eigen::Map<const Four, Eigen::Aligned16>(p); };
  Four sum = Four::Zero();
  for (int a = 0; a < 3; ++a) {
    Four low = Four::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (const auto& [x, y, z] : t) {
      const Four along = four(n.axis[a][0]) * (x - four(n.middle[0])) +
                         four(n.axis[a][1]) * (y - four(n.middle[1])) +
                         four(n.axis[a][2]) * (z - four(n.middle[2]));
      low = low.min(along);
      high = high.max(along);
    }
    sum += (low.max(-high) - four(n.half[a])).max(0.0f).square();
  }
  return sum;
}

// All corners are so far above or below the plane, and so far beyond one edge.
DistanceTree::Four DistanceTree::squaredDistances(const Leaf& leaf, const Corners& t) const {
  Four low[4], high;
  for (int plane = 0; plane < 4; ++plane) {
    const auto four = [&](int i) { return Eigen::Map<const Four, Eigen::Aligned16>(leaf.plane[plane][i]); };
    for (std::size_t k = 0; k < 3; ++k) {
      const Four height = four(0) * t[k][0] + four(1) * t[k][1] + four(2) * t[k][2] - four(3);
      low[plane] = k == 0 ? height : low[plane].min(height);
      if (plane == 0) high = k == 0 ? height : high.max(height);
    }
  }
  const Four above = (low[0].max(-high) - slack_).max(0.0f);
  const Four beyond = (low[1].max(low[2]).max(low[3]) - slack_).max(0.0f);
  return above.square() + beyond.square();
}

bool DistanceTree::nearest(const Vec3& p, Hit& hit) const {
  if (nodes_.empty()) return false;
  Entry stack[kMostWaiting];
  stack[0] = {0, 0};
  return descend(p, stack, 1, hit);
}

// Looks at the `waiting` entries of the stack, last first.
bool DistanceTree::descend(const Vec3& p, Entry* stack, int waiting, Hit& hit) const {
  const Vec3 q = p - centre_;
  const float x = static_cast<float>(q.x()), y = static_cast<float>(q.y()), z = static_cast<float>(q.z());
  float reach = reachOf(hit.closest.squaredDistance);
  bool found = false;
  for (;;) {
    do {
      if (waiting == 0) return found;
      --waiting;
    } while (stack[waiting].d2 > reach);
    std::int32_t at = stack[waiting].child;
    while (at >= 0) {
      const Node& n = nodes_[static_cast<std::size_t>(at)];
      const int m = put(n, squaredDistances(n, x, y, z), reach, stack + waiting);
      if (m == 0) break;
      waiting += m - 1;
      if (m > 1) prefetch(stack[waiting - 1].child);  // it is next unless the nearest one rules it out
      at = stack[waiting].child;
    }
    if (at >= 0) continue;
    found |= measureLeaf(at, p, x, y, z, reach, hit);
  }
}

bool DistanceTree::nearest(const PreparedTriangle& t,
                           const std::function<bool(const PreparedTriangle&)>& skip,
                           double& squaredDistance) const {
  if (nodes_.empty()) return false;
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k)
    for (int x = 0; x < 3; ++x) corners[k][static_cast<std::size_t>(x)] = float(t.corner[k][x] - centre_[x]);
  Entry stack[kMostWaiting];
  int top = 0;
  stack[top++] = {0, 0};
  bool found = false;
  float reach = reachOf(squaredDistance);
  while (top > 0) {
    const Entry e = stack[--top];
    if (e.d2 > reach) continue;
    if (e.child >= 0) {
      const Node& n = nodes_[static_cast<std::size_t>(e.child)];
      top += put(n, squaredDistances(n, corners), reach, stack + top);
      continue;
    }
    const Leaf& leaf = leaves_[static_cast<std::size_t>(-1 - e.child)];
    const Four least = squaredDistances(leaf, corners);
    for (std::uint32_t k = 0; k < leaf.count; ++k) {
      const PreparedTriangle& own = prepared_[leaf.first + k];
      if (least[k] > reach || (skip && skip(own))) continue;
      const double d2 = squaredGap(t, own, squaredDistance);
      if (d2 >= squaredDistance) continue;
      squaredDistance = d2;
      reach = reachOf(d2);
      found = true;
    }
  }
  return found;
}

void DistanceTree::near(const PreparedTriangle& t, double within,
                        const std::function<void(TriangleId)>& visit) const {
  double squared = within * within;
  const auto seen = [&](const PreparedTriangle& own) {
    visit(order_[static_cast<std::size_t>(&own - prepared_.data())]);
    return true;
  };
  (void)nearest(t, seen, squared);
}

}  // namespace thicken::bvh
