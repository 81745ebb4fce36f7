// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/pair_search.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "exact/float_box.h"
#include "mesh/sort_unique.h"
#include "parallel/parallel_for.h"

namespace thicken::exact {

using parallel::parallelFor;

namespace {

using Ids = std::vector<TriangleId>;
using Marks = std::span<const std::uint8_t>;

// What belongs to a block: from `low` to below `high`.
struct Block {
  std::array<float, 3> low, high;

  [[nodiscard]] static Block everything() {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    return {{-kInf, -kInf, -kInf}, {kInf, kInf, kInf}};
  }
  [[nodiscard]] bool owns(const FloatBox& a, const FloatBox& b) const {
    for (int k = 0; k < 3; ++k) {
      const float corner = std::max(a.low[k], b.low[k]);
      if (corner < low[k] || corner >= high[k]) return false;
    }
    return true;
  }
};

struct Cut {
  int axis = 0;
  float at = 0;
};

class BlockSearch {
 public:
  // `moved`: of a pair one at least; empty: any.
  BlockSearch(const TriangleMesh& mesh, std::size_t most, Marks fixed, Marks moved, const RunContext& context,
              int threads, std::size_t limit)
      : mesh_(mesh),
        most_(most),
        fixed_(fixed),
        moved_(moved),
        context_(context),
        threads_(threads),
        limit_(limit) {}

  // Searches among `ids`, ascending, for pairs that belong to `block`; halves it where they are too many.
  void search(Ids ids, const Block& block) {
    if (full()) return;
    if (ids.size() <= most_) return searchAmong(ids, block);
    const Cut cut = cutOf(ids);
    auto [below, above] = divided(ids, cut);
    // Where triangles reach across any cut there is no use in making more.
    constexpr double kLeastGain = 0.9;
    if (double(std::max(below.size(), above.size())) > kLeastGain * double(ids.size()))
      return searchAmong(ids, block);
    ids = Ids();
    Block lower = block, upper = block;
    lower.high[cut.axis] = upper.low[cut.axis] = cut.at;
    search(std::move(below), lower);
    search(std::move(above), upper);
  }

  std::vector<TrianglePair> takeFound() {
    mesh::sortUnique(found_);
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool full() const { return limit_ != 0 && found_.size() > limit_; }

  [[nodiscard]] FloatBox box(TriangleId t) const {
    const auto& [a, b, c] = mesh_.triangles[t];
    return boxOf(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
  }

  void searchAmong(const Ids& ids, const Block& block) {
    std::vector<Triangle> triangles;
    std::vector<std::uint8_t> fixed;
    Ids moved;
    for (TriangleId i = 0; i < ids.size(); ++i) {
      triangles.push_back(mesh_.triangles[ids[i]]);
      if (!fixed_.empty()) fixed.push_back(fixed_[ids[i]]);
      if (!moved_.empty() && moved_[ids[i]]) moved.push_back(i);
    }
    if (!moved_.empty() && moved.empty()) return;
    const BoxTree tree(mesh_.positions, triangles, threads_);
    const auto pairs =
        moved_.empty() ? tree.meetingPairs(mesh_.positions, triangles, fixed, context_, threads_, limit_)
                       : tree.meetingPairsWith(moved, mesh_.positions, triangles, fixed, context_, threads_);
    // Where the limit was reached, what was found is enough, whichever blocks it belongs to.
    const bool any = limit_ != 0 && pairs.size() > limit_;
    for (const auto& [a, b] : pairs)
      if (any || block.owns(box(ids[a]), box(ids[b]))) found_.emplace_back(ids[a], ids[b]);
  }

  // Halves the longest side of the triangles' middles, as some of them tell.
  [[nodiscard]] Cut cutOf(const Ids& ids) const {
    constexpr std::size_t kSome = 4096;
    const std::size_t step = ids.size() / kSome + 1;
    std::array<std::vector<float>, 3> middles;
    for (std::size_t i = 0; i < ids.size(); i += step) {
      const FloatBox b = box(ids[i]);
      for (int k = 0; k < 3; ++k) middles[k].push_back((b.low[k] + b.high[k]) / 2);
    }
    Cut cut;
    float longest = -1;
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax_element(middles[k].begin(), middles[k].end());
      if (!(*high - *low > longest)) continue;
      longest = *high - *low;
      cut.axis = k;
    }
    std::vector<float>& x = middles[cut.axis];
    const auto middle = x.begin() + std::ssize(x) / 2;
    std::nth_element(x.begin(), middle, x.end());
    cut.at = *middle;
    return cut;
  }

  // Those that reach below the cut, and those that reach up to it or above.
  [[nodiscard]] std::pair<Ids, Ids> divided(const Ids& ids, const Cut& cut) const {
    constexpr std::uint8_t kBelow = 1, kAbove = 2;
    std::vector<std::uint8_t> reach(ids.size());
    parallelFor(ids.size(), threads_, context_, 4096, [&](std::size_t i) {
      const FloatBox b = box(ids[i]);
      reach[i] = static_cast<std::uint8_t>((b.low[cut.axis] < cut.at ? kBelow : 0) |
                                           (b.high[cut.axis] >= cut.at ? kAbove : 0));
    });
    const auto those = [&](std::uint8_t side) {
      Ids some;
      some.reserve(
          static_cast<std::size_t>(std::ranges::count_if(reach, [&](auto r) { return (r & side) != 0; })));
      for (std::size_t i = 0; i < ids.size(); ++i)
        if ((reach[i] & side) != 0) some.push_back(ids[i]);
      return some;
    };
    return {those(kBelow), those(kAbove)};
  }

  const TriangleMesh& mesh_;
  std::size_t most_;
  Marks fixed_, moved_;
  const RunContext& context_;
  int threads_;
  std::size_t limit_;
  std::vector<TrianglePair> found_;
};

Ids activeIds(std::size_t count, Marks active) {
  Ids ids;
  ids.reserve(count);
  for (TriangleId t = 0; t < count; ++t)
    if (active.empty() || active[t] != 0) ids.push_back(t);
  return ids;
}

// Those of the active triangles that reach into the box of one that moved, or are one.
Ids near(std::span<const TriangleId> moved, const TriangleMesh& mesh, Marks active, const RunContext& context,
         int threads) {
  std::vector<Triangle> triangles;
  for (const TriangleId t : moved) triangles.push_back(mesh.triangles[t]);
  const BoxTree tree(mesh.positions, triangles, threads);
  std::vector<std::uint8_t> isNear(mesh.triangles.size(), 0);
  parallelFor(isNear.size(), threads, context, 4096, [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    if (active.empty() || active[t] != 0)
      isNear[t] = !tree.near(p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)).empty();
  });
  return activeIds(isNear.size(), isNear);
}

}  // namespace

PairSearch::PairSearch(const TriangleMesh& mesh, std::size_t most, int threads, Marks active,
                       std::span<const TriangleId> order)
    : mesh_(mesh), most_(most), active_(active) {
  if (mesh.triangles.size() <= most) tree_.emplace(mesh.positions, mesh.triangles, threads, active, order);
}

std::vector<TrianglePair> PairSearch::all(Marks fixed, const RunContext& context, int threads,
                                          std::size_t limit) const {
  if (tree_) return tree_->meetingPairs(mesh_.positions, mesh_.triangles, fixed, context, threads, limit);
  BlockSearch blocks(mesh_, most_, fixed, {}, context, threads, limit);
  blocks.search(activeIds(mesh_.triangles.size(), active_), Block::everything());
  return blocks.takeFound();
}

std::vector<TrianglePair> PairSearch::withMoved(std::span<const TriangleId> moved, Marks fixed,
                                                const RunContext& context, int threads) {
  if (tree_) {
    tree_->refit(mesh_.positions, mesh_.triangles, moved);
    return tree_->meetingPairsWith(moved, mesh_.positions, mesh_.triangles, fixed, context, threads);
  }
  std::vector<std::uint8_t> isMoved(mesh_.triangles.size(), 0);
  for (const TriangleId t : moved) isMoved[t] = 1;
  BlockSearch blocks(mesh_, most_, fixed, isMoved, context, threads, 0);
  const bool few = moved.size() <= most_ / 2;
  blocks.search(
      few ? near(moved, mesh_, active_, context, threads) : activeIds(mesh_.triangles.size(), active_),
      Block::everything());
  return blocks.takeFound();
}

}  // namespace thicken::exact
