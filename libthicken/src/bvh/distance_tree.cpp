// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/distance_tree.h"

#ifdef __SSE__
#include <immintrin.h>
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "bvh/triangle_gap.h"
#include "mesh/bounds.h"
#include "parallel_for.h"

namespace thicken {

namespace {

double halfArea(const Bounds& b) {
  const Vec3 d = b.high - b.low;
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

// Axes of a box around triangles: their mean normal, then the direction of their greatest spread.
struct Frame {
  Vec3 axis[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

  void turnTo(const Vec3& normal) {
    axis[0] = normal;
    axis[1] = normal.unitOrthogonal();
    axis[2] = normal.cross(axis[1]);
  }
  // Turns the tangents by the principal direction of the scatter (xx, xy, yy) in their plane.
  void turnTangents(double xx, double xy, double yy) {
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    const Vec3 u = std::cos(angle) * axis[1] + std::sin(angle) * axis[2];
    axis[2] = axis[0].cross(u);
    axis[1] = u;
  }
};

constexpr int kMostWaiting = 192;

// What is farther than this by its lower bound, squared, is farther than `squaredDistance`. Lower bounds
// carry the rounding of float products and sums, and axes that are orthonormal in floats only; 2e-5 covers it
// many times over.
float reachOf(double squaredDistance) {
  return static_cast<float>(squaredDistance * (1 + 2e-5));
}

// Bit k: whether the k-th number is not above `most`; what is no number, by overflow, rules nothing out.
template <class Four>
unsigned notAbove(const Four& numbers, float most) {
#ifdef __SSE__
  return static_cast<unsigned>(
      _mm_movemask_ps(_mm_cmpngt_ps(_mm_loadu_ps(numbers.data()), _mm_set1_ps(most))));
#else
  unsigned bits = 0;
  for (int k = 0; k < 4; ++k) bits |= static_cast<unsigned>(!(numbers[k] > most)) << k;
  return bits;
#endif
}

float roundUp(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafterf(f, std::numeric_limits<float>::infinity()) : f;
}

}  // namespace

// Splits ranges of triangles by the surface-area heuristic over 16 bins, then collapses every two
// levels of the binary tree into one node of four children. Large subtrees are put off and built side by
// side, each into lists of its own.
struct DistanceTree::Builder {
  DistanceTree& tree;
  std::span<const Vec3> positions;
  std::span<const Triangle> triangles;
  std::vector<Bounds> boxes;
  std::vector<Vec3> middles;
  double slack = 0;
  struct Lists {
    std::vector<Node> nodes;
    std::vector<Leaf> leaves;
  };

  struct Range {
    std::uint32_t begin, end;
    Bounds box;
  };

  [[nodiscard]] Bounds boxOf(std::uint32_t begin, std::uint32_t end) const {
    Bounds b;
    for (std::uint32_t i = begin; i < end; ++i) b.add(boxes[tree.order_[i]]);
    return b;
  }

  [[nodiscard]] Frame frameOf(const Range& r) const {
    Frame frame;
    Vec3 normal = Vec3::Zero();
    for (std::uint32_t i = r.begin; i < r.end; ++i) {
      const auto& [a, b, c] = triangles[tree.order_[i]];
      normal += (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    }
    const double length = normal.stableNorm();
    if (!(length > 0) || !std::isfinite(length)) return frame;
    frame.turnTo(normal / length);
    const Vec3 middle = (r.box.low + r.box.high) / 2;
    double xx = 0, xy = 0, yy = 0;
    for (std::uint32_t i = r.begin; i < r.end; ++i)
      for (const VertexId v : triangles[tree.order_[i]]) {
        const double x = frame.axis[1].dot(positions[v] - middle);
        const double y = frame.axis[2].dot(positions[v] - middle);
        xx += x * x;
        xy += x * y;
        yy += y * y;
      }
    frame.turnTangents(xx, xy, yy);
    return frame;
  }

  // The turned box of a range as child k of a node; extents are measured along the axes as they are
  // stored, so that rounding of the axes does not matter.
  void putBox(Node& node, int k, const Range& r) const {
    const Frame frame = frameOf(r);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    Vec3 axis[3];
    for (int a = 0; a < 3; ++a)
      for (int x = 0; x < 3; ++x) {
        node.axis[a][x][k] = static_cast<float>(frame.axis[a][x]);
        axis[a][x] = double{node.axis[a][x][k]};
      }
    for (std::uint32_t i = r.begin; i < r.end; ++i)
      for (const VertexId v : triangles[tree.order_[i]]) {
        const Vec3 p = positions[v] - tree.centre_;
        const Vec3 q(axis[0].dot(p), axis[1].dot(p), axis[2].dot(p));
        low = low.cwiseMin(q);
        high = high.cwiseMax(q);
      }
    const Vec3 between = (low + high) / 2;
    const Vec3 middle = between[0] * frame.axis[0] + between[1] * frame.axis[1] + between[2] * frame.axis[2];
    for (int x = 0; x < 3; ++x) node.middle[x][k] = static_cast<float>(middle[x]);
    const Vec3 stored(double{node.middle[0][k]}, double{node.middle[1][k]}, double{node.middle[2][k]});
    for (int a = 0; a < 3; ++a) {
      const double at = axis[a].dot(stored);
      node.half[a][k] = roundUp(std::max(high[a] - at, at - low[a]) + slack);
    }
  }

  // Below this depth ranges are halved by count, so that sizes in geometric progression cannot make the
  // tree deeper than the stack of nearest() holds: 28 levels and one for each of 32 halvings.
  static constexpr int kDeepest = 28;

  // The place to split a range; triangles of the range are reordered around it.
  std::uint32_t split(const Range& r, int depth) {
    if (depth > kDeepest) return (r.begin + r.end) / 2;
    Bounds middle;
    for (std::uint32_t i = r.begin; i < r.end; ++i) middle.add(middles[tree.order_[i]]);
    int axis = 0;
    const double extent = (middle.high - middle.low).maxCoeff(&axis);
    const auto begin = tree.order_.begin() + r.begin;
    const auto end = tree.order_.begin() + r.end;
    if (extent > 0) {
      constexpr int kBins = 16;
      Bounds bin[kBins];
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
      Bounds box;
      std::uint32_t n = 0;
      for (int b = kBins - 1; b > 0; --b) {
        box.add(bin[b]);
        n += count[b];
        rightCost[b] = n ? n * halfArea(box) : 0;
      }
      box = Bounds();
      n = 0;
      double best = std::numeric_limits<double>::infinity();
      int bestBin = -1;
      for (int b = 0; b + 1 < kBins; ++b) {
        if (count[b]) box.add(bin[b]);
        n += count[b];
        if (n == 0 || n == r.end - r.begin) continue;
        const double cost = n * halfArea(box) + rightCost[b + 1];
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

  [[nodiscard]] static std::int32_t makeLeaf(const Range& r, Lists& lists) {
    Leaf leaf{};
    leaf.first = r.begin;
    leaf.count = r.end - r.begin;
    lists.leaves.push_back(leaf);
    return static_cast<std::int32_t>(lists.leaves.size() - 1);
  }

  // The triangles of a leaf, as they are measured and as its half-spaces.
  void prepare(Leaf& leaf) const {
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const TriangleId id = tree.order_[leaf.first + i];
      const Triangle& t = triangles[id];
      PreparedTriangle& p = tree.prepared_[leaf.first + i];
      p = PreparedTriangle({positions[t[0]], positions[t[1]], positions[t[2]]}, t);
      tree.placeOf_[id] = leaf.first + i;
      const auto put = [&](int plane, const Vec3& direction, const Vec3& on) {
        if (direction.isZero(0)) return;  // a needle's: always measured
        for (int x = 0; x < 3; ++x) leaf.plane[plane][x][i] = static_cast<float>(direction[x]);
        leaf.plane[plane][3][i] = static_cast<float>(direction.dot(on - tree.centre_));
      };
      put(0, p.normal, p.corner[0]);
      for (int k = 0; k < 3; ++k) put(1 + k, -p.side[k].stableNormalized(), p.corner[k]);
    }
  }

  struct Later {
    Range range;
    int depth;
    std::int32_t parent;
    int child;
    Lists lists;
  };
  // A box of a node above those subtrees: the largest ranges, so that these wait as well.
  struct Box {
    std::int32_t node;
    int child;
    Range range;
  };
  struct PutOff {
    std::uint32_t most;  // triangles of a subtree that is built by itself
    std::vector<Later> subtrees;
    std::vector<Box> boxes;
  };

  void buildAll(const Range& whole, int threads) {
    constexpr std::uint32_t kLeast = 4096, kParts = 16;
    Lists top;
    PutOff putOff{std::max(kLeast, whole.end / kParts), {}, {}};
    build(whole, 0, top, &putOff);
    std::vector<Later>& later = putOff.subtrees;
    parallelFor(putOff.boxes.size(), threads, RunContext(), 1, [&](std::size_t i) {
      const Box& b = putOff.boxes[i];
      putBox(top.nodes[static_cast<std::size_t>(b.node)], b.child, b.range);
    });
    parallelFor(later.size(), threads, RunContext(), 1,
                [&](std::size_t i) { build(later[i].range, later[i].depth, later[i].lists, nullptr); });
    tree.nodes_ = std::move(top.nodes);
    tree.leaves_ = std::move(top.leaves);
    join(later, threads);
  }

  // Puts the subtrees behind the nodes and leaves above them.
  void join(std::span<const Later> later, int threads) const {
    std::size_t nodes = tree.nodes_.size(), leaves = tree.leaves_.size();
    std::vector<std::pair<std::size_t, std::size_t>> first;
    for (const Later& part : later) {
      first.emplace_back(nodes, leaves);
      tree.nodes_[static_cast<std::size_t>(part.parent)].child[part.child] = static_cast<std::int32_t>(nodes);
      nodes += part.lists.nodes.size();
      leaves += part.lists.leaves.size();
    }
    tree.nodes_.resize(nodes);
    tree.leaves_.resize(leaves);
    parallelFor(later.size(), threads, RunContext(), 1, [&](std::size_t i) {
      const auto [firstNode, firstLeaf] = first[i];
      std::copy(later[i].lists.leaves.begin(), later[i].lists.leaves.end(),
                tree.leaves_.begin() + static_cast<std::ptrdiff_t>(firstLeaf));
      auto to = tree.nodes_.begin() + static_cast<std::ptrdiff_t>(firstNode);
      for (Node node : later[i].lists.nodes) {
        for (std::int32_t& child : node.child)
          if (child != kEmpty)
            child = child < 0 ? child - static_cast<std::int32_t>(firstLeaf)
                              : child + static_cast<std::int32_t>(firstNode);
        *to++ = node;
      }
    });
  }

  // `later`: what to put off, and where to, if not nullptr.
  std::int32_t build(const Range& whole, int depth, Lists& lists, PutOff* later) {
    std::vector<Range> parts{whole};
    while (parts.size() < static_cast<std::size_t>(kWidth)) {  // open the largest part until four
      std::size_t widest = parts.size();
      double area = -1;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].end - parts[i].begin <= kLeafSize || halfArea(parts[i].box) <= area) continue;
        area = halfArea(parts[i].box);
        widest = i;
      }
      if (widest == parts.size()) break;
      const Range r = parts[widest];
      const std::uint32_t mid = split(r, depth);
      parts[widest] = {r.begin, mid, boxOf(r.begin, mid)};
      parts.push_back({mid, r.end, boxOf(mid, r.end)});
    }
    const auto id = static_cast<std::int32_t>(lists.nodes.size());
    lists.nodes.emplace_back();
    for (int k = 0; k < kWidth; ++k) {
      const bool used = static_cast<std::size_t>(k) < parts.size();
      std::int32_t child = kEmpty;
      if (used) {
        const Range& r = parts[static_cast<std::size_t>(k)];
        if (r.end - r.begin <= kLeafSize) {
          child = -1 - makeLeaf(r, lists);
        } else if (later != nullptr && r.end - r.begin <= later->most) {
          later->subtrees.push_back({r, depth + 1, id, k, {}});
        } else {
          child = build(r, depth + 1, lists, later);
        }
      }
      Node& node = lists.nodes[static_cast<std::size_t>(id)];
      node.child[k] = child;
      if (!used) continue;
      const Range& r = parts[static_cast<std::size_t>(k)];
      if (later != nullptr)
        later->boxes.push_back({id, k, r});
      else
        putBox(node, k, r);
    }
    return id;
  }
};

DistanceTree::DistanceTree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                           int threads) {
  Builder builder{*this, positions, triangles, {}, {}, 0};
  builder.boxes.resize(triangles.size());
  builder.middles.resize(triangles.size());
  constexpr std::size_t kGrain = 4096;
  parallelFor(triangles.size(), threads, RunContext(), kGrain, [&](std::size_t t) {
    Bounds& b = builder.boxes[t];
    for (const VertexId v : triangles[t]) b.add(positions[v]);
    builder.middles[t] = (b.low + b.high) / 2;
  });
  Bounds whole;
  for (const Bounds& b : builder.boxes) whole.add(b);
  order_.resize(triangles.size());
  std::iota(order_.begin(), order_.end(), 0u);
  if (triangles.empty()) return;
  centre_ = (whole.low + whole.high) / 2;
  // A query as far as twice the extent away is rounded by less than this.
  builder.slack = (whole.high - whole.low).maxCoeff() * 2e-6;
  slack_ = roundUp(builder.slack);
  builder.buildAll({0, static_cast<std::uint32_t>(triangles.size()), whole}, threads);
  prepared_.resize(order_.size());
  placeOf_.resize(order_.size());
  parallelFor(leaves_.size(), threads, RunContext(), kGrain / kLeafSize,
              [&](std::size_t i) { builder.prepare(leaves_[i]); });
}

TriangleClosest DistanceTree::measure(const Vec3& p, TriangleId t) const {
  return closestOnTriangle(p, prepared_[placeOf_[t]], std::numeric_limits<double>::infinity());
}

// Lower bounds of the squared distances to the four boxes of a node.
inline DistanceTree::Four DistanceTree::squaredDistances(const Node& n, float x, float y, float z) {
  const auto four = [](const float* p) { return Eigen::Map<const Four, Eigen::Aligned16>(p); };
  const Four dx = x - four(n.middle[0]), dy = y - four(n.middle[1]), dz = z - four(n.middle[2]);
  Four sum = Four::Zero();
  for (int a = 0; a < 3; ++a) {
    const Four along = four(n.axis[a][0]) * dx + four(n.axis[a][1]) * dy + four(n.axis[a][2]) * dz;
    sum += (along.abs() - four(n.half[a])).max(0.0f).square();
  }
  return sum;
}

// Lower bounds of the squared distances to the triangles of a leaf.
inline DistanceTree::Four DistanceTree::squaredDistances(const Leaf& leaf, float x, float y, float z) const {
  const auto height = [&](int plane) -> Four {
    const auto four = [&](int i) { return Eigen::Map<const Four, Eigen::Aligned16>(leaf.plane[plane][i]); };
    return four(0) * x + four(1) * y + four(2) * z - four(3);
  };
  const Four above = (height(0).abs() - slack_).max(0.0f);
  const Four beyond = (height(1).max(height(2)).max(height(3)) - slack_).max(0.0f);
  return above.square() + beyond.square();
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

// Writes the children within reach, farthest first; returns how many.
int DistanceTree::put(const Node& n, const Four& squaredDistance, float reach, Entry* to) {
  int m = 0;
  for (unsigned near = notAbove(squaredDistance, reach); near != 0; near &= near - 1) {
    const int k = std::countr_zero(near);
    if (n.child[k] == kEmpty) continue;
    int at = m++;
    for (; at > 0 && to[at - 1].d2 < squaredDistance[k]; --at) to[at] = to[at - 1];
    to[at] = {squaredDistance[k], n.child[k]};
  }
  return m;
}

bool DistanceTree::nearest(const Vec3& p, Hit& hit) const {
  if (nodes_.empty()) return false;
  const Vec3 q = p - centre_;
  const float x = static_cast<float>(q.x()), y = static_cast<float>(q.y()), z = static_cast<float>(q.z());
  const auto prefetch = [this](std::int32_t child) {
    const char* at = child < 0 ? reinterpret_cast<const char*>(&leaves_[static_cast<std::size_t>(-1 - child)])
                               : reinterpret_cast<const char*>(&nodes_[static_cast<std::size_t>(child)]);
    for (int line = 0; line < 4; ++line) __builtin_prefetch(at + 64 * line);
  };
  float reach = reachOf(hit.closest.squaredDistance);
  Entry stack[kMostWaiting];
  int top = 0;
  bool found = false;
  std::int32_t at = 0;
  for (;;) {
    if (at < 0) {
      const Leaf& leaf = leaves_[static_cast<std::size_t>(-1 - at)];
      const Four least = squaredDistances(leaf, x, y, z);
      for (unsigned near = notAbove(least, reach) & ((1u << leaf.count) - 1); near != 0; near &= near - 1) {
        const int k = std::countr_zero(near);
        if (least[k] > reach) continue;  // of what was measured just before
        const std::uint32_t i = leaf.first + static_cast<std::uint32_t>(k);
        const TriangleClosest c = closestOnTriangle(p, prepared_[i], hit.closest.squaredDistance);
        if (c.squaredDistance < hit.closest.squaredDistance ||
            (c.squaredDistance == hit.closest.squaredDistance && order_[i] < hit.triangle)) {
          hit = {c, order_[i]};
          reach = reachOf(c.squaredDistance);
          found = true;
        }
      }
    } else {
      const Node& n = nodes_[static_cast<std::size_t>(at)];
      if (const int m = put(n, squaredDistances(n, x, y, z), reach, stack + top); m > 0) {
        top += m - 1;
        if (m > 1) prefetch(stack[top - 1].child);  // it is next unless the nearest one rules it out
        at = stack[top].child;
        continue;
      }
    }
    do {
      if (top == 0) return found;
      --top;
    } while (stack[top].d2 > reach);
    at = stack[top].child;
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

}  // namespace thicken
