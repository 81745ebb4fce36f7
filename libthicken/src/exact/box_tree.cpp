// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "exact/box_order.h"
#include "exact/clear_fans.h"
#include "exact/self_meetings.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::exact {

using parallel::parallelFor;

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
  mesh::sortUnique(dirty);
  if (!dirty.empty()) impl_->fitBelow(impl_->root(), dirty);
}

void BoxTree::drop(std::span<const TriangleId> triangles) {
  for (const TriangleId t : triangles) {
    const std::uint32_t slot = std::exchange(impl_->slot[t], kNobody);
    if (slot == kNobody) continue;
    Leaf& leaf = impl_->leaves[slot / kLeafSize];
    leaf.id[slot % kLeafSize] = kNobody;
    leaf.set(slot % kLeafSize, FloatBox::empty());
  }
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
  return selfMeetings(impl_->box, impl_->leaves, {positions, triangles},
                      clearFans(positions, triangles, fixed, threads), masks, limit, context, threads);
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
    return selfMeetings(impl_->box, impl_->leaves, geometry, clearFans(positions, triangles, fixed, threads),
                        masks, 0, context, threads);
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
  near(low, high, result);
  std::sort(result.begin(), result.end());
  return result;
}

void BoxTree::near(const Vec3& low, const Vec3& high, std::vector<TriangleId>& into) const {
  into.clear();
  if (impl_->leaves.empty()) return;
  impl_->visit(impl_->root(), boxOf(low, low, high), [&into](TriangleId t) { into.push_back(t); });
}

}  // namespace thicken::exact
