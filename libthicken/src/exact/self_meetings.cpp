// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/self_meetings.h"

#include <atomic>
#include <bit>
#include <utility>

#include "exact/leaf_fans.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::exact {

using parallel::parallelFor;

namespace {

// Counts the pairs of all threads, for those that want only some.
class Limit {
 public:
  explicit Limit(std::size_t limit) : limit_(limit) {}
  void count() {
    if (limit_ != 0) found_.fetch_add(1, std::memory_order_relaxed);
  }
  [[nodiscard]] bool reached() const {
    return limit_ != 0 && found_.load(std::memory_order_relaxed) > limit_;
  }

 private:
  std::size_t limit_;
  std::atomic<std::size_t> found_{0};
};

// One simultaneous descent of the tree against itself.
class SelfMeetings {
 public:
  SelfMeetings(std::span<const FloatBox> box, std::span<const Leaf> leaves, const Geometry& geometry,
               std::vector<LeafFans> fans, std::span<const Mask> maskOfSlot, std::size_t limit)
      : box_(box),
        leaves_(leaves),
        geometry_(geometry),
        fans_(std::move(fans)),
        maskOfSlot_(maskOfSlot),
        clusters_(leaves.size() / 2 + 1),
        limit_(limit) {
    if (!maskOfSlot_.empty()) {
      maskOfNode_.resize(box.size());
      gatherMasks(root());
    }
  }

  std::vector<TrianglePair> run(const RunContext& context, int threads) {
    gatherClusters(threads);
    const std::vector<Task> tasks = topTasks();
    std::vector<std::vector<TrianglePair>> found(tasks.size());
    parallelFor(tasks.size(), threads, context, 1, [&](std::size_t i) {
      if (tasks[i].a.node == tasks[i].b.node)
        within(tasks[i].a, found[i]);
      else
        between(tasks[i].a, tasks[i].b, found[i]);
    });
    return sortedUnion(found);
  }

 private:
  struct Task {
    Subtree a, b;
  };
  using Found = std::vector<TrianglePair>;

  [[nodiscard]] Subtree root() const { return {0, 0, static_cast<std::uint32_t>(leaves_.size())}; }

  // The lowest subtrees that are descended to: the boxes of their leaves are compared side by side.
  [[nodiscard]] static bool isCluster(const Subtree& tree) { return tree.count <= FourBoxes::kFour; }
  // Of two leaves at least, unless it is the whole tree.
  [[nodiscard]] FourBoxes& clusterOf(const Subtree& tree) { return clusters_[tree.first / 2]; }

  // A bit for each leaf of a cluster.
  [[nodiscard]] static unsigned leavesOf(const Subtree& cluster) { return (1u << cluster.count) - 1; }

  void gatherClusters(int threads) {
    std::vector<Subtree> clusters, open{root()};
    while (!open.empty()) {
      const Subtree tree = open.back();
      open.pop_back();
      if (isCluster(tree)) {
        clusters.push_back(tree);
        continue;
      }
      open.push_back(tree.left());
      open.push_back(tree.right());
    }
    parallelFor(clusters.size(), threads, RunContext(), 1024, [&](std::size_t i) {
      const Subtree& tree = clusters[i];
      FourBoxes& boxes = clusterOf(tree);
      for (std::uint32_t k = 0; k < FourBoxes::kFour; ++k)
        boxes.set(k, k < tree.count ? leaves_[tree.first + k].FourBoxes::box() : FloatBox::empty());
    });
  }

  Mask gatherMasks(const Subtree& tree) {
    Mask all = kFixed | kUnmoved;
    if (tree.isLeaf()) {
      for (std::uint32_t i = 0; i < kLeafSize; ++i) all &= maskOfSlot_[kLeafSize * tree.first + i];
    } else {
      const Mask left = gatherMasks(tree.left());
      all = left & gatherMasks(tree.right());
    }
    return maskOfNode_[tree.node] = all;
  }
  [[nodiscard]] bool leftOut(const Subtree& a, const Subtree& b) const {
    return !maskOfNode_.empty() && (maskOfNode_[a.node] & maskOfNode_[b.node]) != 0;
  }
  [[nodiscard]] bool apart(const Subtree& a, const Subtree& b) const {
    return leftOut(a, b) || !box_[a.node].overlaps(box_[b.node]);
  }

  // Splits the descent into parts that threads share, the same ones for any number of them.
  [[nodiscard]] std::vector<Task> topTasks() const {
    constexpr std::size_t kTasks = 2000;
    std::vector<Task> tasks{{root(), root()}};
    for (bool split = true; split && tasks.size() < kTasks;) {
      split = false;
      std::vector<Task> next;
      for (const Task& t : tasks) {
        if (isCluster(t.a) && isCluster(t.b)) {
          next.push_back(t);
          continue;
        }
        split = true;
        const bool self = t.a.node == t.b.node;
        if (self) {
          for (const Subtree& half : {t.a.left(), t.a.right()})
            if (!leftOut(half, half)) next.push_back({half, half});
          if (!apart(t.a.left(), t.a.right())) next.push_back({t.a.left(), t.a.right()});
        } else {
          const auto [large, small] = t.a.count >= t.b.count ? t : Task{t.b, t.a};
          for (const Subtree& half : {large.left(), large.right()})
            if (!apart(half, small)) next.push_back({half, small});
        }
      }
      tasks = std::move(next);
    }
    return tasks;
  }

  void within(const Subtree& tree, Found& found) {
    if (leftOut(tree, tree) || limit_.reached()) return;
    if (isCluster(tree)) {
      withinCluster(tree, found);
      return;
    }
    within(tree.left(), found);
    within(tree.right(), found);
    between(tree.left(), tree.right(), found);
  }

  void between(const Subtree& a, const Subtree& b, Found& found) {
    if (apart(a, b) || limit_.reached()) return;
    const auto& [large, small] = a.count >= b.count ? Task{a, b} : Task{b, a};
    if (isCluster(large)) {
      betweenClusters(a, b, found);
      return;
    }
    between(large.left(), small, found);
    between(large.right(), small, found);
  }

  void withinCluster(const Subtree& tree, Found& found) {
    const FourBoxes& cluster = clusterOf(tree);
    for (std::uint32_t k = 0; k < tree.count; ++k) {
      const Leaf& leaf = leaves_[tree.first + k];
      for (std::uint32_t i = 0; i + 1 < kLeafSize; ++i)
        test(tree.first + k, i, tree.first + k, leaf.overlaps(leaf.box(i)) & (0xeu << i), found);
      unsigned others = cluster.overlaps(cluster.box(k)) & leavesOf(tree) & (0xeu << k);
      for (; others != 0; others &= others - 1)
        betweenLeaves(tree.first + k, cluster.box(k),
                      tree.first + static_cast<std::uint32_t>(std::countr_zero(others)), found);
    }
  }

  void betweenClusters(const Subtree& a, const Subtree& b, Found& found) {
    const FourBoxes &clusterA = clusterOf(a), &clusterB = clusterOf(b);
    for (unsigned as = clusterA.overlaps(box_[b.node]) & leavesOf(a); as != 0; as &= as - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(as));
      const FloatBox box = clusterA.box(i);
      for (unsigned bs = clusterB.overlaps(box) & leavesOf(b); bs != 0; bs &= bs - 1)
        betweenLeaves(a.first + i, box, b.first + static_cast<std::uint32_t>(std::countr_zero(bs)), found);
    }
  }

  void betweenLeaves(std::uint32_t a, const FloatBox& boxOfA, std::uint32_t b, Found& found) {
    for (unsigned bs = leaves_[b].overlaps(boxOfA); bs != 0; bs &= bs - 1) {
      const auto j = static_cast<std::uint32_t>(std::countr_zero(bs));
      test(b, j, a, leaves_[a].overlaps(leaves_[b].box(j)), found);
    }
  }

  void test(std::uint32_t leafA, std::uint32_t i, std::uint32_t leafB, unsigned candidates, Found& found) {
    if (candidates != 0) candidates &= ~fans_[leafB].shared(fans_[leafA], i);
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto j = static_cast<std::uint32_t>(std::countr_zero(candidates));
      if (!maskOfSlot_.empty() &&
          (maskOfSlot_[kLeafSize * leafA + i] & maskOfSlot_[kLeafSize * leafB + j]) != 0)
        continue;
      const TriangleId a = leaves_[leafA].id[i], b = leaves_[leafB].id[j];
      if (!geometry_.pairMeets(a, b)) continue;
      found.push_back(ordered(a, b));
      limit_.count();
    }
  }

  std::span<const FloatBox> box_;
  std::span<const Leaf> leaves_;
  Geometry geometry_;
  std::vector<LeafFans> fans_;
  std::span<const Mask> maskOfSlot_;
  std::vector<Mask> maskOfNode_;
  std::vector<FourBoxes> clusters_;
  Limit limit_;
};

// `clear`: of each vertex.
std::vector<LeafFans> fansOf(std::span<const Leaf> leaves, std::span<const Triangle> triangles,
                             std::span<const std::uint8_t> clear, int threads) {
  std::vector<LeafFans> fans(leaves.size());
  parallelFor(leaves.size(), threads, RunContext(), 2048, [&](std::size_t l) {
    for (std::uint32_t i = 0; i < kLeafSize; ++i) {
      const TriangleId t = leaves[l].id[i];
      if (t == kNobody)
        fans[l].setNobody(i);
      else
        fans[l].set(i, triangles[t], clear);
    }
  });
  return fans;
}

}  // namespace

std::vector<TrianglePair> sortedUnion(const std::vector<std::vector<TrianglePair>>& parts) {
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<TrianglePair> all;
  all.reserve(total);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  mesh::sortUnique(all);
  return all;
}

std::vector<TrianglePair> selfMeetings(std::span<const FloatBox> box, std::span<const Leaf> leaves,
                                       const Geometry& geometry, std::span<const std::uint8_t> clear,
                                       std::span<const Mask> maskOfSlot, std::size_t limit,
                                       const RunContext& context, int threads) {
  return SelfMeetings(box, leaves, geometry, fansOf(leaves, geometry.triangles, clear, threads), maskOfSlot,
                      limit)
      .run(context, threads);
}

}  // namespace thicken::exact
