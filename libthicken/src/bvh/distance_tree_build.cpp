// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "bvh/distance_tree.h"
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

}  // namespace thicken
