// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bvh/area_split.h"
#include "bvh/distance_tree.h"
#include "mesh/bounds.h"
#include "parallel/parallel_for.h"

namespace thicken::bvh {

using mesh::Bounds;
using parallel::parallelFor;

namespace {

using Four = AreaSplit::Four;
using Range = AreaSplit::Range;
using Matrix3 = Eigen::Matrix<double, 3, 3>;

// Sums over triangles that the axes of a box around them follow from.
struct Moments {
  Vec3 normal = Vec3::Zero();
  double count = 0;  // of corners
  Vec3 first = Vec3::Zero();
  Matrix3 second = Matrix3::Zero();

  void add(const Moments& m) {
    normal += m.normal;
    count += m.count;
    first += m.first;
    second += m.second;
  }
  void addTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    normal += (b - a).cross(c - a);
    count += 3;
    first += a + b + c;
    second += a * a.transpose() + b * b.transpose() + c * c.transpose();
  }
};

// Axes of a box around triangles: their mean normal, then the direction of their greatest spread.
struct Frame {
  Vec3 axis[3] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

  explicit Frame(const Moments& m) {
    const double length = m.normal.stableNorm();
    if (!(length > 0) || !std::isfinite(length)) return;
    axis[0] = m.normal / length;
    axis[1] = axis[0].unitOrthogonal();
    axis[2] = axis[0].cross(axis[1]);
    const Matrix3 scatter = m.second - m.first * m.first.transpose() / m.count;
    const Vec3 along = scatter * axis[1];
    turnTangents(axis[1].dot(along), axis[2].dot(along), axis[2].dot(scatter * axis[2]));
  }

 private:
  // Turns the tangents by the principal direction of the scatter (xx, xy, yy) in their plane.
  void turnTangents(double xx, double xy, double yy) {
    const double across = xx - yy, length = std::hypot(across, 2 * xy);
    if (!(length > 0)) return;
    const double cosine = std::sqrt((1 + across / length) / 2);  // of half the angle that the two make
    const double sine = std::copysign(std::sqrt((1 - across / length) / 2), xy);
    const Vec3 u = cosine * axis[1] + sine * axis[2];
    axis[2] = axis[0].cross(u);
    axis[1] = u;
  }
};

float roundUp(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafterf(f, std::numeric_limits<float>::infinity()) : f;
}

// The corners of a triangle from the centre of the mesh, the first one twice.
struct CornerFour {
  Four x[3];
};

}  // namespace

// Splits ranges of triangles by the surface-area heuristic, then collapses every two levels of the binary
// tree into one node of four children. Boxes are made from the leaves up, when the order of the triangles is
// settled. Large subtrees are put off and built side by side, each into lists of its own.
struct DistanceTree::Builder {
  DistanceTree& tree;
  std::span<const Vec3> positions;
  std::span<const Triangle> triangles;
  AreaSplit order;
  std::vector<CornerFour> corners = std::vector<CornerFour>(triangles.size());  // in the order of the leaves
  double slack = 0;
  struct Places {
    std::uint32_t first, count;  // of the order
  };
  struct Lists {
    std::vector<Node> nodes;
    std::vector<Places> leaves;
  };

  // The turned box of a range as child k of a node; extents are measured along the axes as they are
  // stored, so that rounding of the axes does not matter.
  void putBox(Node& node, int k, const Range& r, const Moments& moments) const {
    const Frame frame(moments);
    for (int a = 0; a < 3; ++a)
      for (int x = 0; x < 3; ++x) node.axis[a][x][k] = static_cast<float>(frame.axis[a][x]);
    Four least[3], most[3];
    for (int a = 0; a < 3; ++a) {
      least[a] = Four::Constant(std::numeric_limits<float>::infinity());
      most[a] = -least[a];
    }
    for (std::uint32_t i = r.begin; i < r.end; ++i)
      for (int a = 0; a < 3; ++a) {
        const Four along = node.axis[a][0][k] * corners[i].x[0] + node.axis[a][1][k] * corners[i].x[1] +
                           node.axis[a][2][k] * corners[i].x[2];
        least[a] = least[a].min(along);
        most[a] = most[a].max(along);
      }
    const auto low = [&](int a) { return double{least[a].minCoeff()}; };
    const auto high = [&](int a) { return double{most[a].maxCoeff()}; };
    Vec3 middle = Vec3::Zero();
    for (int a = 0; a < 3; ++a) middle += (low(a) + high(a)) / 2 * frame.axis[a];
    for (int x = 0; x < 3; ++x) node.middle[x][k] = static_cast<float>(middle[x]);
    for (int a = 0; a < 3; ++a) {
      double at = 0;
      for (int x = 0; x < 3; ++x) at += double{node.axis[a][x][k]} * double{node.middle[x][k]};
      node.half[a][k] = roundUp(std::max(high(a) - at, at - low(a)) + slack);
    }
  }

  // Below this depth ranges are halved by count, so that sizes in geometric progression cannot make the
  // tree deeper than the stack of nearest() holds: 28 levels and one for each of 32 halvings.
  static constexpr int kDeepest = 28;

  std::int32_t makeLeaf(const Range& r, Lists& lists, Moments& moments) {
    for (std::uint32_t i = r.begin; i < r.end; ++i) {
      const Triangle& t = triangles[order.triangle(i)];
      const Vec3 a = positions[t[0]] - tree.centre_, b = positions[t[1]] - tree.centre_,
                 c = positions[t[2]] - tree.centre_;
      for (int x = 0; x < 3; ++x)
        corners[i].x[x] = Four(static_cast<float>(a[x]), static_cast<float>(b[x]), static_cast<float>(c[x]),
                               static_cast<float>(a[x]));
      moments.addTriangle(a, b, c);
    }
    lists.leaves.push_back({r.begin, r.size()});
    return -static_cast<std::int32_t>(lists.leaves.size());
  }

  // The triangles of a leaf, as they are measured and as its half-spaces.
  void prepare(Leaf& leaf) const {
    std::fill_n(&leaf.plane[0][0][0], sizeof leaf.plane / sizeof(float), 0.0f);
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
      const std::uint32_t place = leaf.first + i;
      const TriangleId id = order.triangle(place);
      const Triangle& t = triangles[id];
      PreparedTriangle& p = tree.prepared_[place];
      p = PreparedTriangle({positions[t[0]], positions[t[1]], positions[t[2]]}, t);
      tree.order_[place] = id;
      tree.placeOf_[id] = place;
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
    Moments moments;
  };
  // A box of a node above those subtrees.
  struct Box {
    std::int32_t node;
    int child;
    Range range;
  };
  struct PutOff {
    std::uint32_t most;  // triangles of a subtree that is built by itself
    int threads;
    std::vector<Later> subtrees;
    std::vector<Box> boxes;
    std::vector<std::pair<std::uint32_t, Moments>> leaves;  // beside those subtrees, by their first triangle

    [[nodiscard]] Moments momentsOf(const Range& r) const {
      Moments sum;
      const auto isIn = [&](std::uint32_t first) { return first >= r.begin && first < r.end; };
      for (const Later& s : subtrees)
        if (isIn(s.range.begin)) sum.add(s.moments);
      for (const auto& [first, moments] : leaves)
        if (isIn(first)) sum.add(moments);
      return sum;
    }
  };

  void buildAll(int threads) {
    constexpr std::uint32_t kLeast = 4096, kParts = 16;
    const Range whole = order.whole();
    Lists top;
    PutOff putOff{std::max(kLeast, whole.end / kParts), threads, {}, {}, {}};
    Moments unused;
    build(whole, 0, top, unused, &putOff);
    std::vector<Later>& later = putOff.subtrees;
    parallelFor(later.size(), threads, RunContext(), 1, [&](std::size_t i) {
      Later& s = later[i];
      s.lists.nodes.reserve(s.range.size() / 4);
      s.lists.leaves.reserve(s.range.size() / 2);
      build(s.range, s.depth, s.lists, s.moments, nullptr);
    });
    parallelFor(putOff.boxes.size(), threads, RunContext(), 1, [&](std::size_t i) {
      const Box& b = putOff.boxes[i];
      putBox(top.nodes[static_cast<std::size_t>(b.node)], b.child, b.range, putOff.momentsOf(b.range));
    });
    tree.nodes_ = std::move(top.nodes);
    join(std::move(top.leaves), later, threads);
  }

  // Puts the subtrees behind the nodes and leaves above them.
  void join(std::vector<Places> leaves, std::span<const Later> later, int threads) const {
    std::size_t nodes = tree.nodes_.size();
    std::vector<std::pair<std::size_t, std::size_t>> first;
    for (const Later& part : later) {
      first.emplace_back(nodes, leaves.size());
      tree.nodes_[static_cast<std::size_t>(part.parent)].child[part.child] = static_cast<std::int32_t>(nodes);
      nodes += part.lists.nodes.size();
      leaves.insert(leaves.end(), part.lists.leaves.begin(), part.lists.leaves.end());
    }
    tree.nodes_.resize(nodes);
    parallelFor(later.size(), threads, RunContext(), 1, [&](std::size_t i) {
      const auto [firstNode, firstLeaf] = first[i];
      auto to = tree.nodes_.begin() + static_cast<std::ptrdiff_t>(firstNode);
      for (Node node : later[i].lists.nodes) {
        for (std::int32_t& child : node.child)
          if (child != kEmpty)
            child = child < 0 ? child - static_cast<std::int32_t>(firstLeaf)
                              : child + static_cast<std::int32_t>(firstNode);
        *to++ = node;
      }
    });
    tree.leaves_.resize(leaves.size());
    parallelFor(leaves.size(), threads, RunContext(), 1024, [&](std::size_t i) {
      Leaf& leaf = tree.leaves_[i];
      leaf.first = leaves[i].first;
      leaf.count = leaves[i].count;
      prepare(leaf);
    });
  }

  // The range in at most four parts.
  std::vector<Range> partsOf(const Range& whole, int depth, int threads) {
    std::vector<Range> parts;
    parts.reserve(kWidth);
    parts.push_back(whole);
    while (parts.size() < static_cast<std::size_t>(kWidth)) {  // open the largest part until four
      std::size_t widest = parts.size();
      double area = -1;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].size() <= kLeafSize || parts[i].box.halfArea() <= area) continue;
        area = parts[i].box.halfArea();
        widest = i;
      }
      if (widest == parts.size()) break;
      const auto [left, right] =
          depth > kDeepest ? order.halve(parts[widest]) : order.split(parts[widest], threads);
      parts[widest] = left;
      parts.push_back(right);
    }
    return parts;
  }

  // `moments`: to add those of the range to. `later`: what to put off, and where to, if not nullptr; then
  // `moments` is left alone.
  std::int32_t build(const Range& whole, int depth, Lists& lists, Moments& moments, PutOff* later) {
    const std::vector<Range> parts = partsOf(whole, depth, later != nullptr ? later->threads : 1);
    const auto id = static_cast<std::int32_t>(lists.nodes.size());
    lists.nodes.emplace_back();
    for (int k = 0; k < kWidth; ++k) {
      if (static_cast<std::size_t>(k) >= parts.size()) {
        lists.nodes[static_cast<std::size_t>(id)].child[k] = kEmpty;
        continue;
      }
      const Range& r = parts[static_cast<std::size_t>(k)];
      Moments own;
      std::int32_t child = kEmpty;
      if (r.size() <= kLeafSize) {
        child = makeLeaf(r, lists, own);
        if (later != nullptr) later->leaves.emplace_back(r.begin, own);
      } else if (later != nullptr && r.size() <= later->most) {
        later->subtrees.push_back({r, depth + 1, id, k, {}, {}});
      } else {
        child = build(r, depth + 1, lists, own, later);
      }
      Node& node = lists.nodes[static_cast<std::size_t>(id)];
      node.child[k] = child;
      if (later != nullptr) {
        later->boxes.push_back({id, k, r});
        continue;
      }
      putBox(node, k, r, own);
      moments.add(own);
    }
    return id;
  }
};

DistanceTree::DistanceTree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                           int threads) {
  if (triangles.empty()) return;
  constexpr std::size_t kPart = 16384;
  std::vector<Bounds> parts((triangles.size() + kPart - 1) / kPart);
  parallel::parallelForParts(triangles.size(), threads, RunContext(), kPart,
                             [&](std::size_t part, std::size_t begin, std::size_t end) {
                               Bounds b;  // not the list's, beside which other threads write
                               for (const Triangle& t : triangles.subspan(begin, end - begin))
                                 for (const VertexId v : t) b.add(positions[v]);
                               parts[part] = b;
                             });
  Bounds whole;
  for (const Bounds& b : parts) whole.add(b);
  centre_ = (whole.low + whole.high) / 2;
  order_.resize(triangles.size());
  placeOf_.resize(triangles.size());
  prepared_.resize(triangles.size());
  Builder builder{*this, positions, triangles, AreaSplit(positions, triangles, centre_, threads)};
  // A query as far as twice the extent away, and corners in floats, are rounded by less than this together.
  builder.slack = (whole.high - whole.low).maxCoeff() * 2.5e-6;
  slack_ = roundUp(builder.slack);
  builder.buildAll(threads);
}

}  // namespace thicken::bvh
