// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Queries for points that lie close together: the upper levels of the tree are searched once for all of them.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "bvh/distance_tree.h"
#include "bvh/distance_tree_inline.h"

namespace thicken::bvh {

// The subtrees that a ball reaches, side by side: so far down that there are no more than kMost.
struct DistanceTree::Part {
  static constexpr int kMost = 16;
  Node pack[kMost / kWidth];
  int packs = 0;

  Part(const DistanceTree& tree, const Vec3& centre, double radius)
      : tree_(tree),
        x_(static_cast<float>(centre.x())),
        y_(static_cast<float>(centre.y())),
        z_(static_cast<float>(centre.z())),
        reach_(reachOf(radius * radius)) {
    Boxes boxes;
    openNode(0, boxes);
    while (openOnce(boxes)) {
    }
    for (; packs * kWidth < boxes.count; ++packs) copyBoxes(boxes, packs * kWidth, pack[packs]);
  }

 private:
  // The boxes of some children, each by its node and place in it.
  struct Boxes {
    struct Box {
      const Node* node;
      int k;
      [[nodiscard]] std::int32_t child() const { return node->child[k]; }
    };
    std::array<Box, kMost> at;
    int count = 0;
  };

  void openNode(std::int32_t id, Boxes& to) const {
    const Node& n = tree_.nodes_[static_cast<std::size_t>(id)];
    for (unsigned near = notAbove(squaredDistances(n, x_, y_, z_), reach_); near != 0; near &= near - 1)
      if (const int k = std::countr_zero(near); n.child[k] != kEmpty)
        to.at[static_cast<std::size_t>(to.count++)] = {&n, k};
  }

  // Takes the children of nodes in the place of the nodes, as long as there is room.
  bool openOnce(Boxes& boxes) const {
    Boxes next;
    bool opened = false;
    for (int i = 0; i < boxes.count; ++i) {
      const auto& box = boxes.at[static_cast<std::size_t>(i)];
      const int others = next.count + boxes.count - i - 1;
      if (box.child() < 0 || others + kWidth > kMost) {
        next.at[static_cast<std::size_t>(next.count++)] = box;
        continue;
      }
      openNode(box.child(), next);
      opened = true;
    }
    boxes = next;
    return opened;
  }

  static void copyBoxes(const Boxes& boxes, int first, Node& to) {
    for (int k = 0; k < kWidth; ++k) {
      const auto& [node, from] = boxes.at[static_cast<std::size_t>(std::min(first + k, boxes.count - 1))];
      for (int a = 0; a < 3; ++a) {
        to.middle[a][k] = node->middle[a][from];
        to.half[a][k] = node->half[a][from];
        for (int x = 0; x < 3; ++x) to.axis[a][x][k] = node->axis[a][x][from];
      }
      to.child[k] = first + k < boxes.count ? node->child[from] : kEmpty;
    }
  }

  const DistanceTree& tree_;
  float x_, y_, z_, reach_;
};

void DistanceTree::nearest(std::span<const Vec3> points, std::span<Hit> hits) const {
  if (nodes_.empty() || points.empty()) return;
  Vec3 low = points[0], high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec3 middle = (low + high) / 2;
  double radius = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(hits[i].closest.squaredDistance)) nearest(points[i], hits[i]);
    radius = std::max(radius, (points[i] - middle).norm() + std::sqrt(hits[i].closest.squaredDistance));
  }
  const Part part(*this, middle - centre_, radius);
  for (std::size_t i = 0; i < points.size(); ++i) search(part, points[i], hits[i]);
}

// The hit is near the answer already, so that children are looked at in any order: nodes first, then the
// leaves that they lead to. Neither that nor how many children are in reach is a branch to be predicted.
void DistanceTree::search(const Part& part, const Vec3& p, Hit& hit) const {
  const Vec3 q = p - centre_;
  const float x = static_cast<float>(q.x()), y = static_cast<float>(q.y()), z = static_cast<float>(q.z());
  constexpr int kMostLeaves = 8;
  std::int32_t nodes[kMostWaiting], leaves[Part::kMost + kMostLeaves + kWidth];
  int nodeCount = 0, leafCount = 0;
  float reach = reachOf(hit.closest.squaredDistance);
  const auto open = [&](const Node& n) {
    const unsigned near = notAbove(squaredDistances(n, x, y, z), reach);
    for (int k = 0; k < kWidth; ++k) {
      const std::int32_t child = n.child[k];
      const bool isNear = ((near >> k) & 1u) != 0;
      nodes[nodeCount] = child;
      leaves[leafCount] = child;
      nodeCount += isNear & (child >= 0) & (child != kEmpty);
      leafCount += isNear & (child < 0);
    }
  };
  const auto measureLeaves = [&] {
    for (int i = 0; i < leafCount; ++i) measureLeaf(leaves[i], p, x, y, z, reach, hit);
    leafCount = 0;
  };
  for (int k = 0; k < part.packs; ++k) open(part.pack[k]);
  for (int i = 0; i < nodeCount; ++i) prefetch(nodes[i]);
  while (nodeCount > 0) {
    if (leafCount >= kMostLeaves) measureLeaves();
    open(nodes_[static_cast<std::size_t>(nodes[--nodeCount])]);
  }
  measureLeaves();
}

}  // namespace thicken::bvh
