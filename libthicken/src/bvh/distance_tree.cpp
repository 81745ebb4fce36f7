// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/distance_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace thicken {

namespace {

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& b) {
    low = low.cwiseMin(b.low);
    high = high.cwiseMax(b.high);
  }
  [[nodiscard]] double halfArea() const {
    const Vec3 d = high - low;
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
  }
};

float roundDown(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafterf(f, -std::numeric_limits<float>::infinity()) : f;
}

float roundUp(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafterf(f, std::numeric_limits<float>::infinity()) : f;
}

}  // namespace

// Splits ranges of triangles by the surface-area heuristic over 16 bins, then collapses every two
// levels of the binary tree into one node of four children.
struct DistanceTree::Builder {
  DistanceTree& tree;
  std::vector<Box> boxes;
  std::vector<Vec3> middles;
  double slack = 0;

  struct Range {
    std::uint32_t begin, end;
    Box box;
  };

  [[nodiscard]] Box boxOf(std::uint32_t begin, std::uint32_t end) const {
    Box b;
    for (std::uint32_t i = begin; i < end; ++i) b.add(boxes[tree.order_[i]]);
    return b;
  }

  // Below this depth ranges are halved by count, so that sizes in geometric progression cannot make the
  // tree deeper than the stack of nearest() holds: 28 levels and one for each of 32 halvings.
  static constexpr int kDeepest = 28;

  // The place to split a range; triangles of the range are reordered around it.
  std::uint32_t split(const Range& r, int depth) {
    if (depth > kDeepest) return (r.begin + r.end) / 2;
    Box middle;
    for (std::uint32_t i = r.begin; i < r.end; ++i) middle.add(middles[tree.order_[i]]);
    int axis = 0;
    const double extent = (middle.high - middle.low).maxCoeff(&axis);
    const auto begin = tree.order_.begin() + r.begin;
    const auto end = tree.order_.begin() + r.end;
    if (extent > 0) {
      constexpr int kBins = 16;
      Box bin[kBins];
      std::uint32_t count[kBins] = {};
      const double scale = kBins / extent;
      const double low = middle.low[axis];
      const auto binOf = [&](TriangleId t) {
        return std::min(kBins - 1, static_cast<int>((middles[t][axis] - low) * scale));
      };
      for (auto it = begin; it != end; ++it) {
        const int b = binOf(*it);
        bin[b].add(boxes[*it]);
        ++count[b];
      }
      double rightCost[kBins] = {};
      Box box;
      std::uint32_t n = 0;
      for (int b = kBins - 1; b > 0; --b) {
        box.add(bin[b]);
        n += count[b];
        rightCost[b] = n ? n * box.halfArea() : 0;
      }
      box = Box();
      n = 0;
      double best = std::numeric_limits<double>::infinity();
      int bestBin = -1;
      for (int b = 0; b + 1 < kBins; ++b) {
        if (count[b]) box.add(bin[b]);
        n += count[b];
        if (n == 0 || n == r.end - r.begin) continue;
        const double cost = n * box.halfArea() + rightCost[b + 1];
        if (cost < best) {
          best = cost;
          bestBin = b;
        }
      }
      if (bestBin >= 0) {
        const auto mid = std::stable_partition(begin, end, [&](TriangleId t) { return binOf(t) <= bestBin; });
        return static_cast<std::uint32_t>(mid - tree.order_.begin());
      }
    }
    return (r.begin + r.end) / 2;  // all middles coincide
  }

  std::int32_t build(const Range& whole, int depth) {
    std::vector<Range> parts{whole};
    while (parts.size() < static_cast<std::size_t>(kWidth)) {  // open the largest part until four
      std::size_t widest = parts.size();
      double area = -1;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].end - parts[i].begin <= kLeafSize || parts[i].box.halfArea() <= area) continue;
        area = parts[i].box.halfArea();
        widest = i;
      }
      if (widest == parts.size()) break;
      const Range r = parts[widest];
      const std::uint32_t mid = split(r, depth);
      parts[widest] = {r.begin, mid, boxOf(r.begin, mid)};
      parts.push_back({mid, r.end, boxOf(mid, r.end)});
    }
    const auto id = static_cast<std::int32_t>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    for (int k = 0; k < kWidth; ++k) {
      const bool used = static_cast<std::size_t>(k) < parts.size();
      std::int32_t child = kEmpty;
      std::int32_t count = 0;
      if (used) {
        const Range& r = parts[static_cast<std::size_t>(k)];
        if (r.end - r.begin <= kLeafSize) {
          child = -1 - static_cast<std::int32_t>(r.begin);
          count = static_cast<std::int32_t>(r.end - r.begin);
        } else {
          child = build(r, depth + 1);
        }
      }
      Node& node = tree.nodes_[static_cast<std::size_t>(id)];
      node.child[k] = child;
      node.count[k] = count;
      for (int x = 0; x < 3; ++x) {
        const Box box = used ? parts[static_cast<std::size_t>(k)].box : Box();
        node.low[x][k] =
            used ? roundDown(box.low[x] - tree.centre_[x] - slack) : std::numeric_limits<float>::max();
        node.high[x][k] =
            used ? roundUp(box.high[x] - tree.centre_[x] + slack) : std::numeric_limits<float>::max();
      }
    }
    return id;
  }
};

DistanceTree::DistanceTree(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  Builder builder{*this, {}, {}, 0};
  builder.boxes.reserve(triangles.size());
  builder.middles.reserve(triangles.size());
  Box whole;
  for (const Triangle& t : triangles) {
    Box b;
    for (const VertexId v : t) b.add(positions[v]);
    whole.add(b);
    builder.boxes.push_back(b);
    builder.middles.push_back((b.low + b.high) / 2);
  }
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (triangles.empty()) return;
  centre_ = (whole.low + whole.high) / 2;
  // A query as far as twice the extent away is rounded by less than this.
  builder.slack = (whole.high - whole.low).maxCoeff() * 4e-7;
  builder.build({0, static_cast<std::uint32_t>(triangles.size()), whole}, 0);
  prepared_.reserve(order_.size());
  placeOf_.resize(order_.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) {
    const Triangle& t = triangles[order_[i]];
    prepared_.emplace_back(std::array{positions[t[0]], positions[t[1]], positions[t[2]]}, t);
    placeOf_[order_[i]] = i;
  }
}

TriangleClosest DistanceTree::measure(const Vec3& p, TriangleId t) const {
  return closestOnTriangle(p, prepared_[placeOf_[t]], std::numeric_limits<double>::infinity());
}

bool DistanceTree::nearest(const Vec3& p, Hit& hit) const {
  if (nodes_.empty()) return false;
  const Vec3 q = p - centre_;
  const float x = static_cast<float>(q.x()), y = static_cast<float>(q.y()), z = static_cast<float>(q.z());
  // Box distances carry the rounding of float products and sums; 1e-6 covers it many times over.
  constexpr double kShrink = 1 - 1e-6;
  struct Entry {
    float d2;
    std::int32_t child, count;
  };
  Entry stack[192];
  int top = 0;
  stack[top++] = {0, 0, 0};
  bool found = false;
  while (top > 0) {
    const Entry e = stack[--top];
    if (e.d2 * kShrink > hit.closest.squaredDistance) continue;
    if (e.child < 0) {
      const auto first = static_cast<std::uint32_t>(-1 - e.child);
      for (std::uint32_t i = first; i < first + static_cast<std::uint32_t>(e.count); ++i) {
        const TriangleClosest c = closestOnTriangle(p, prepared_[i], hit.closest.squaredDistance);
        if (c.squaredDistance < hit.closest.squaredDistance ||
            (c.squaredDistance == hit.closest.squaredDistance && order_[i] < hit.triangle)) {
          hit = {c, order_[i]};
          found = true;
        }
      }
      continue;
    }
    const Node& n = nodes_[static_cast<std::size_t>(e.child)];
    float d2[kWidth];
    for (int k = 0; k < kWidth; ++k) {
      const float dx = std::max(std::max(n.low[0][k] - x, x - n.high[0][k]), 0.0f);
      const float dy = std::max(std::max(n.low[1][k] - y, y - n.high[1][k]), 0.0f);
      const float dz = std::max(std::max(n.low[2][k] - z, z - n.high[2][k]), 0.0f);
      d2[k] = dx * dx + dy * dy + dz * dz;
    }
    Entry next[kWidth];
    int m = 0;
    for (int k = 0; k < kWidth; ++k) {
      if (n.child[k] == kEmpty || d2[k] * kShrink > hit.closest.squaredDistance) continue;
      int at = m++;
      for (; at > 0 && next[at - 1].d2 < d2[k]; --at) next[at] = next[at - 1];  // farthest first
      next[at] = {d2[k], n.child[k], n.count[k]};
    }
    for (int i = 0; i < m; ++i) stack[top++] = next[i];
  }
  return found;
}

}  // namespace thicken
