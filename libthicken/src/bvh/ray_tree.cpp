// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/ray_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace thicken::bvh {
namespace {

constexpr std::uint32_t kLeafSize = 4;
// Depth of a tree of 2^32 triangles that is halved at every step.
constexpr int kDeepest = 40;

constexpr double kMissed = std::numeric_limits<double>::infinity();

// Where the ray enters the box, or kMissed; `inverse` holds 1 / direction.
double entry(const Vec3& low, const Vec3& high, const Vec3& origin, const Vec3& inverse) {
  double from = 0, to = kMissed;
  for (int k = 0; k < 3; ++k) {
    double a = (low[k] - origin[k]) * inverse[k], b = (high[k] - origin[k]) * inverse[k];
    if (a > b) std::swap(a, b);
    // Written so that 0 · ∞ (a ray within a face of the box) leaves the bounds as they are.
    if (a > from) from = a;
    if (b < to) to = b;
  }
  return from <= to ? from : kMissed;
}

}  // namespace

RayTree::RayTree(std::span<const Vec3> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles), order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> middles;
  middles.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) middles.push_back((positions[a] + positions[b] + positions[c]) / 3);
  if (!triangles.empty()) build(0, static_cast<std::uint32_t>(triangles.size()), middles);
}

void RayTree::build(std::uint32_t begin, std::uint32_t end, std::span<const Vec3> middles) {
  const std::size_t here = nodes_.size();
  Node node;
  node.low = node.high = positions_[triangles_[order_[begin]][0]];
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const VertexId v : triangles_[order_[i]]) {
      node.low = node.low.cwiseMin(positions_[v]);
      node.high = node.high.cwiseMax(positions_[v]);
    }
  }
  // What the margin of meet() adds at edges must not be lost at the border of a box.
  const Vec3 margin = Vec3::Constant(1e-9 * (node.high - node.low).norm());
  node.low -= margin;
  node.high += margin;
  if (end - begin <= kLeafSize) {
    node.begin = begin;
    node.count = end - begin;
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node);
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](TriangleId s, TriangleId t) {
        return middles[s][axis] != middles[t][axis] ? middles[s][axis] < middles[t][axis] : s < t;
      });
  build(begin, middle, middles);
  nodes_[here].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end, middles);
}

void RayTree::meet(const Vec3& origin, const Vec3& direction, TriangleId triangle, Hit& hit) const {
  const auto& [a, b, c] = triangles_[triangle];
  const Vec3 u = positions_[b] - positions_[a], v = positions_[c] - positions_[a];
  const Vec3 p = direction.cross(v);
  const double determinant = u.dot(p);
  if (determinant == 0) return;  // along its plane
  constexpr double kMargin = 1e-9;
  const Vec3 from = origin - positions_[a];
  const double s = from.dot(p) / determinant;
  if (s < -kMargin || s > 1 + kMargin) return;
  const Vec3 q = from.cross(u);
  const double t = direction.dot(q) / determinant;
  if (t < -kMargin || s + t > 1 + kMargin) return;
  const double along = v.dot(q) / determinant;
  if (along < 0 || along > hit.along || (along == hit.along && triangle > hit.triangle)) return;
  hit.along = along;
  hit.triangle = triangle;
}

RayTree::Hit RayTree::first(const Vec3& origin, const Vec3& direction, const Triangle& from) const {
  const auto beside = [&](TriangleId t) {
    return std::find_first_of(from.begin(), from.end(), triangles_[t].begin(), triangles_[t].end()) !=
           from.end();
  };
  Hit hit;
  if (nodes_.empty()) return hit;
  const Vec3 inverse = direction.cwiseInverse();
  std::uint32_t waiting[kDeepest];
  int count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    const double reached = entry(node.low, node.high, origin, inverse);
    // Before the first hit `along` is infinite, as is the entry into a box that the ray misses.
    if (reached == kMissed || reached > hit.along) continue;
    ++hit.opened;
    for (std::uint32_t i = node.begin; i < node.begin + node.count; ++i)
      if (!beside(order_[i])) meet(origin, direction, order_[i], hit);
    if (node.count > 0) continue;
    std::uint32_t near = index + 1, far = node.right;
    if (entry(nodes_[near].low, nodes_[near].high, origin, inverse) >
        entry(nodes_[far].low, nodes_[far].high, origin, inverse))
      std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  return hit;
}

}  // namespace thicken::bvh
