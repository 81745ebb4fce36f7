// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/box_tree.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <utility>

#include "exact/box_order.h"
#include "exact/clear_fans.h"
#include "exact/float_box.h"
#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "mesh/sort_unique.h"
#include "parallel_for.h"

namespace thicken::exact {
namespace {

constexpr std::uint32_t kNobody = 0xffffffffu;

// Four boxes side by side, so that one box is compared with all of them at once.
struct Leaf {
  float low[3][kLeafSize], high[3][kLeafSize];
  TriangleId id[kLeafSize];

  void set(std::uint32_t i, const FloatBox& box) {
    for (int k = 0; k < 3; ++k) {
      low[k][i] = box.low[k];
      high[k][i] = box.high[k];
    }
  }
  [[nodiscard]] FloatBox box(std::uint32_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }
  [[nodiscard]] FloatBox box() const {
    FloatBox all = box(0);
    for (std::uint32_t i = 1; i < kLeafSize; ++i) all.include(box(i));
    return all;
  }
  // Bit i: whether box i overlaps.
  [[nodiscard]] unsigned overlaps(const FloatBox& other) const {
#ifdef __SSE__
    static_assert(kLeafSize == 4);
    __m128 in = _mm_cmple_ps(_mm_loadu_ps(low[0]), _mm_set1_ps(other.high[0]));
    in = _mm_and_ps(in, _mm_cmpge_ps(_mm_loadu_ps(high[0]), _mm_set1_ps(other.low[0])));
    for (int k = 1; k < 3; ++k) {
      in = _mm_and_ps(in, _mm_cmple_ps(_mm_loadu_ps(low[k]), _mm_set1_ps(other.high[k])));
      in = _mm_and_ps(in, _mm_cmpge_ps(_mm_loadu_ps(high[k]), _mm_set1_ps(other.low[k])));
    }
    return static_cast<unsigned>(_mm_movemask_ps(in));
#else
    unsigned bits = 0;
    for (std::uint32_t i = 0; i < kLeafSize; ++i) {
      bool all = true;
      for (int k = 0; k < 3; ++k) all &= (low[k][i] <= other.high[k]) & (other.low[k] <= high[k][i]);
      bits |= static_cast<unsigned>(all) << i;
    }
    return bits;
#endif
  }
};

// Why pairs of two triangles that share a bit are left out.
using Mask = std::uint8_t;
constexpr Mask kFixed = 1, kUnmoved = 2;

struct Geometry {
  std::span<const Vec3> positions;
  std::span<const Triangle> triangles;

  [[nodiscard]] FloatBox box(TriangleId t) const {
    const Triangle& c = triangles[t];
    return boxOf(positions[c[0]], positions[c[1]], positions[c[2]]);
  }
  [[nodiscard]] bool degenerate(TriangleId t) const {
    const Triangle& c = triangles[t];
    return collinear(positions[c[0]], positions[c[1]], positions[c[2]]);
  }
  [[nodiscard]] bool pairMeets(TriangleId a, TriangleId b) const {
    return meet(positions, triangles[a], triangles[b]) && !degenerate(a) && !degenerate(b);
  }
};

TrianglePair ordered(TriangleId a, TriangleId b) {
  return a < b ? TrianglePair{a, b} : TrianglePair{b, a};
}

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

std::vector<TrianglePair> sortedUnion(std::vector<std::vector<TrianglePair>>& parts) {
  std::size_t total = 0;
  for (const auto& part : parts) total += part.size();
  std::vector<TrianglePair> all;
  all.reserve(total);
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  sortUnique(all);
  return all;
}

}  // namespace

struct BoxTree::Impl {
  std::vector<FloatBox> box;  // a node, in preorder
  std::vector<Leaf> leaves;
  std::vector<std::uint32_t> slot;  // of a triangle: kLeafSize · leaf + place, or kNobody
  int threads = 0;
  static constexpr int kParallelLevels = 6;  // of the tree, below which subtrees are shared out

  [[nodiscard]] Subtree root() const { return {0, 0, static_cast<std::uint32_t>(leaves.size())}; }

  void fit(const Geometry& g) {
    parallelFor(leaves.size(), threads, RunContext(), 2048, [&](std::size_t l) {
      Leaf& leaf = leaves[l];
      for (std::uint32_t i = 0; i < kLeafSize; ++i)
        leaf.set(i, leaf.id[i] == kNobody ? FloatBox::empty() : g.box(leaf.id[i]));
    });
    if (!leaves.empty()) fitBelow(root(), kParallelLevels);
  }
  // The upper subtrees on all threads.
  void fitBelow(const Subtree& tree, int levels) {
    if (tree.isLeaf() || levels == 0) {
      fitBelow(tree);
      return;
    }
    std::vector<Subtree> subtrees{tree};
    for (int level = 0; level < levels; ++level) {
      std::vector<Subtree> next;
      for (const Subtree& t : subtrees) {
        if (t.isLeaf()) {
          next.push_back(t);
          continue;
        }
        next.push_back(t.left());
        next.push_back(t.right());
      }
      subtrees = std::move(next);
    }
    parallelFor(subtrees.size(), threads, RunContext(), 1, [&](std::size_t i) { fitBelow(subtrees[i]); });
    mergeBelow(tree, levels);
  }
  void mergeBelow(const Subtree& tree, int levels) {
    if (tree.isLeaf() || levels == 0) return;
    mergeBelow(tree.left(), levels - 1);
    mergeBelow(tree.right(), levels - 1);
    merge(tree);
  }
  void fitBelow(const Subtree& tree) {
    if (tree.isLeaf()) {
      box[tree.node] = leaves[tree.first].box();
      return;
    }
    fitBelow(tree.left());
    fitBelow(tree.right());
    merge(tree);
  }
  void merge(const Subtree& tree) {
    box[tree.node] = box[tree.left().node];
    box[tree.node].include(box[tree.right().node]);
  }
  // Calls found(t) for every triangle t of the subtree whose box overlaps `target`.
  template <class Found>
  void visit(const Subtree& tree, const FloatBox& target, const Found& found) const {
    if (!box[tree.node].overlaps(target)) return;
    if (!tree.isLeaf()) {
      visit(tree.left(), target, found);
      visit(tree.right(), target, found);
      return;
    }
    const Leaf& leaf = leaves[tree.first];
    unsigned candidates = leaf.overlaps(target);
    for (std::uint32_t i = 0; candidates != 0; ++i, candidates >>= 1)
      if ((candidates & 1) != 0) found(leaf.id[i]);
  }

  // `dirty`: leaves whose boxes changed, ascending, within the subtree.
  void fitBelow(const Subtree& tree, std::span<const std::uint32_t> dirty) {
    if (dirty.empty()) return;
    if (tree.isLeaf()) {
      box[tree.node] = leaves[tree.first].box();
      return;
    }
    const auto middle = std::lower_bound(dirty.begin(), dirty.end(), tree.right().first);
    const auto toLeft = static_cast<std::size_t>(middle - dirty.begin());
    fitBelow(tree.left(), dirty.first(toLeft));
    fitBelow(tree.right(), dirty.subspan(toLeft));
    merge(tree);
  }
};

namespace {

// One simultaneous descent of the tree against itself.
class SelfMeetings {
 public:
  // `clearFan`: of each vertex (clearFans()).
  SelfMeetings(const std::vector<FloatBox>& box, const std::vector<Leaf>& leaves, const Geometry& geometry,
               std::vector<std::uint8_t> clearFan, std::vector<Mask> maskOfSlot, std::size_t limit)
      : box_(box),
        leaves_(leaves),
        geometry_(geometry),
        clearFan_(std::move(clearFan)),
        maskOfSlot_(std::move(maskOfSlot)),
        limit_(limit) {
    if (!maskOfSlot_.empty()) {
      maskOfNode_.resize(box.size());
      gatherMasks(root());
    }
  }

  std::vector<TrianglePair> run(const RunContext& context, int threads) {
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
        if (t.a.isLeaf() && t.b.isLeaf()) {
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
    if (tree.isLeaf()) {
      const Leaf& leaf = leaves_[tree.first];
      for (std::uint32_t i = 0; i + 1 < kLeafSize; ++i)
        test(tree.first, i, tree.first, leaf.overlaps(leaf.box(i)) & (0xeu << i), found);
      return;
    }
    within(tree.left(), found);
    within(tree.right(), found);
    between(tree.left(), tree.right(), found);
  }

  void between(const Subtree& a, const Subtree& b, Found& found) {
    if (apart(a, b) || limit_.reached()) return;
    if (a.isLeaf() && b.isLeaf()) {
      for (std::uint32_t i = 0; i < kLeafSize; ++i) {
        const FloatBox box = leaves_[a.first].box(i);
        if (box.overlaps(box_[b.node])) test(a.first, i, b.first, leaves_[b.first].overlaps(box), found);
      }
      return;
    }
    const auto& [large, small] = a.count >= b.count ? Task{a, b} : Task{b, a};
    between(large.left(), small, found);
    between(large.right(), small, found);
  }

  void test(std::uint32_t leafA, std::uint32_t i, std::uint32_t leafB, unsigned candidates, Found& found) {
    for (; candidates != 0; candidates &= candidates - 1) {
      const auto j = static_cast<std::uint32_t>(std::countr_zero(candidates));
      if (!maskOfSlot_.empty() &&
          (maskOfSlot_[kLeafSize * leafA + i] & maskOfSlot_[kLeafSize * leafB + j]) != 0)
        continue;
      const TriangleId a = leaves_[leafA].id[i], b = leaves_[leafB].id[j];
      if (shareClearFan(a, b) || !geometry_.pairMeets(a, b)) continue;
      found.push_back(ordered(a, b));
      limit_.count();
    }
  }

  [[nodiscard]] bool shareClearFan(TriangleId a, TriangleId b) const {
    const Triangle& of = geometry_.triangles[b];
    for (const VertexId v : geometry_.triangles[a])
      if ((v == of[0] || v == of[1] || v == of[2]) && clearFan_[v] != 0) return true;
    return false;
  }

  const std::vector<FloatBox>& box_;
  const std::vector<Leaf>& leaves_;
  Geometry geometry_;
  std::vector<std::uint8_t> clearFan_;
  std::vector<Mask> maskOfSlot_, maskOfNode_;
  Limit limit_;
};

// Whether `order` names all of `ids`, which ascend, and nothing else.
bool namesAll(std::span<const TriangleId> order, std::span<const TriangleId> ids) {
  if (order.size() != ids.size() || ids.empty()) return false;
  std::vector<std::uint8_t> open(ids.back() + std::size_t{1}, 0);
  for (const TriangleId t : ids) open[t] = 1;
  return std::all_of(order.begin(), order.end(), [&](TriangleId t) {
    return t < open.size() && std::exchange(open[t], std::uint8_t{0}) != 0;
  });
}

// A mask for every place in the leaves; empty when nothing is left out. Places of nobody have all bits.
template <class MaskOf>
std::vector<Mask> masksOf(const std::vector<Leaf>& leaves, int threads, MaskOf maskOf) {
  std::vector<Mask> mask(kLeafSize * leaves.size());
  parallelFor(leaves.size(), threads, RunContext(), 4096, [&](std::size_t l) {
    for (std::uint32_t i = 0; i < kLeafSize; ++i) {
      const TriangleId t = leaves[l].id[i];
      mask[kLeafSize * l + i] = t == kNobody ? kFixed | kUnmoved : maskOf(t);
    }
  });
  return mask;
}

}  // namespace

BoxTree::BoxTree(std::span<const Vec3> positions, std::span<const Triangle> triangles, int threads,
                 std::span<const std::uint8_t> active, std::span<const TriangleId> order)
    : impl_(std::make_unique<Impl>()) {
  std::vector<TriangleId> ids;
  ids.reserve(triangles.size());
  for (TriangleId t = 0; t < triangles.size(); ++t)
    if (active.empty() || active[t] != 0) ids.push_back(t);
  if (namesAll(order, ids))
    ids.assign(order.begin(), order.end());
  else
    ids = leafOrder(positions, triangles, std::move(ids), threads);

  impl_->threads = threads;
  impl_->leaves.resize((ids.size() + kLeafSize - 1) / kLeafSize);
  impl_->box.resize(impl_->leaves.empty() ? 0 : 2 * impl_->leaves.size() - 1);
  impl_->slot.assign(triangles.size(), kNobody);
  parallelFor(impl_->leaves.size(), threads, RunContext(), 2048, [&](std::size_t l) {
    for (std::uint32_t k = 0; k < kLeafSize; ++k) {
      const std::size_t i = kLeafSize * l + k;
      impl_->leaves[l].id[k] = i < ids.size() ? ids[i] : kNobody;
      if (i < ids.size()) impl_->slot[ids[i]] = static_cast<std::uint32_t>(i);
    }
  });
  impl_->fit({positions, triangles});
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::refit(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                    std::span<const TriangleId> moved) {
  const Geometry geometry{positions, triangles};
  if (moved.size() > triangles.size() / 4) {
    impl_->fit(geometry);
    return;
  }
  std::vector<std::uint32_t> dirty;
  dirty.reserve(moved.size());
  for (const TriangleId t : moved) {
    const std::uint32_t slot = impl_->slot[t];
    if (slot == kNobody) continue;
    impl_->leaves[slot / kLeafSize].set(slot % kLeafSize, geometry.box(t));
    dirty.push_back(slot / kLeafSize);
  }
  sortUnique(dirty);
  if (!dirty.empty()) impl_->fitBelow(impl_->root(), dirty);
}

std::vector<TrianglePair> BoxTree::meetingPairs(std::span<const Vec3> positions,
                                                std::span<const Triangle> triangles,
                                                std::span<const std::uint8_t> fixed,
                                                const RunContext& context, int threads,
                                                std::size_t limit) const {
  if (impl_->leaves.empty()) return {};
  std::vector<Mask> masks;
  if (!fixed.empty())
    masks =
        masksOf(impl_->leaves, threads, [fixed](TriangleId t) -> Mask { return fixed[t] != 0 ? kFixed : 0; });
  return SelfMeetings(impl_->box, impl_->leaves, {positions, triangles},
                      clearFans(positions, triangles, fixed, threads), std::move(masks), limit)
      .run(context, threads);
}

std::vector<TrianglePair> BoxTree::meetingPairsWith(std::span<const TriangleId> moved,
                                                    std::span<const Vec3> positions,
                                                    std::span<const Triangle> triangles,
                                                    std::span<const std::uint8_t> fixed,
                                                    const RunContext& context, int threads) const {
  if (impl_->leaves.empty() || moved.empty()) return {};
  const Geometry geometry{positions, triangles};

  // many: one descent of the tree against itself finds every pair once instead of twice
  if (moved.size() > triangles.size() / 8) {
    std::vector<std::uint8_t> isMoved(triangles.size(), 0);
    for (const TriangleId t : moved) isMoved[t] = 1;
    std::vector<Mask> masks = masksOf(impl_->leaves, threads, [&](TriangleId t) -> Mask {
      return (isMoved[t] != 0 ? 0 : kUnmoved) | (!fixed.empty() && fixed[t] != 0 ? kFixed : 0);
    });
    return SelfMeetings(impl_->box, impl_->leaves, geometry, clearFans(positions, triangles, fixed, threads),
                        std::move(masks), 0)
        .run(context, threads);
  }

  constexpr std::size_t kBlock = 64;
  std::vector<std::vector<TrianglePair>> found((moved.size() + kBlock - 1) / kBlock);
  parallelFor(moved.size(), threads, context, kBlock, [&](std::size_t i) {
    const TriangleId a = moved[i];
    if (impl_->slot[a] == kNobody) return;
    const FloatBox box = geometry.box(a);
    const bool fixedA = !fixed.empty() && fixed[a] != 0;
    impl_->visit(impl_->root(), box, [&](TriangleId b) {
      if (b == a || (fixedA && fixed[b] != 0) || !geometry.pairMeets(a, b)) return;
      found[i / kBlock].push_back(ordered(a, b));
    });
  });
  return sortedUnion(found);
}

std::vector<TriangleId> BoxTree::order() const {
  std::vector<TriangleId> ids;
  ids.reserve(kLeafSize * impl_->leaves.size());
  for (const Leaf& leaf : impl_->leaves)
    for (const TriangleId t : leaf.id)
      if (t != kNobody) ids.push_back(t);
  return ids;
}

std::vector<TriangleId> BoxTree::near(const Vec3& low, const Vec3& high) const {
  std::vector<TriangleId> result;
  if (impl_->leaves.empty()) return result;
  impl_->visit(impl_->root(), boxOf(low, low, high), [&result](TriangleId t) { result.push_back(t); });
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace thicken::exact
