// SPDX-License-Identifier: LGPL-2.1-or-later
#include "exact/box_order.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel/parallel_for.h"

namespace thicken::exact {

using parallel::parallelFor;

namespace {

struct Centre {
  float x[3];
  TriangleId id;
};

float centreOf(double a, double b, double c) {
  const float sum = static_cast<float>(a + b + c);
  return std::isfinite(sum) ? sum : 0;  // only the quality of the tree depends on it
}

bool isBefore(const Centre& a, const Centre& b, int axis) {
  return (a.x[axis] < b.x[axis]) | ((a.x[axis] == b.x[axis]) & (a.id < b.id));
}

// As std::nth_element() along an axis. Which side of a pivot a centre belongs to cannot be predicted, so that
// each is moved without a branch; pivots come from samples, close to the one that is looked for.
void select(std::span<Centre> centres, std::size_t nth, int axis) {
  constexpr std::size_t kFew = 20, kSamples = 31, kLarge = 1024, kSamplesOfSmall = 9;
  constexpr int kMostRounds = 64;  // of more the samples are no good
  const auto before = [axis](const Centre& a, const Centre& b) { return isBefore(a, b, axis); };
  for (int round = 0; centres.size() > kFew && round < kMostRounds; ++round) {
    const bool large = centres.size() > kLarge;
    const std::size_t count = large ? kSamples : kSamplesOfSmall, beside = large ? 2 : 1;
    std::array<Centre, kSamples> samples;
    for (std::size_t k = 0; k < count; ++k) samples[k] = centres[k * centres.size() / count];
    // Beyond the one that is looked for on the side where more are, which then are left out.
    std::size_t at = nth * count / centres.size();
    at = 2 * nth < centres.size() ? std::min(at + beside, count / 2)
                                  : std::max(at, count / 2 + beside) - beside;
    std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(at),
                     samples.begin() + static_cast<std::ptrdiff_t>(count), before);
    const Centre pivot = samples[at];
    std::size_t below = 0;
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const Centre c = centres[i];
      centres[i] = centres[below];
      centres[below] = c;
      below += isBefore(c, pivot, axis);
    }
    if (nth < below) {
      centres = centres.first(below);
    } else if (below > 0) {
      centres = centres.subspan(below);
      nth -= below;
    } else {
      break;  // the pivot is the first of all
    }
  }
  std::nth_element(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(nth), centres.end(),
                   before);
}

int longestSide(std::span<const Centre> centres) {
  float low[3], high[3];
  for (int k = 0; k < 3; ++k) low[k] = high[k] = centres[0].x[k];
  for (const Centre& c : centres) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], c.x[k]);
      high[k] = std::max(high[k], c.x[k]);
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  return axis;
}

std::span<Centre> of(const Subtree& tree, std::span<Centre> centres) {
  const std::size_t begin = std::size_t{kLeafSize} * tree.first;
  return centres.subspan(begin,
                         std::min<std::size_t>(std::size_t{kLeafSize} * tree.count, centres.size() - begin));
}

void partition(const Subtree& tree, std::span<Centre> centres) {
  const std::span<Centre> part = of(tree, centres);
  const int axis = longestSide(part);
  select(part, std::size_t{kLeafSize} * tree.left().count, axis);
}

void sortBelow(const Subtree& tree, std::span<Centre> centres) {
  if (tree.isLeaf()) return;
  partition(tree, centres);
  sortBelow(tree.left(), centres);
  sortBelow(tree.right(), centres);
}

}  // namespace

std::vector<TriangleId> leafOrder(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                  std::vector<TriangleId> ids, int threads) {
  if (ids.empty()) return ids;
  const RunContext uncancelled;
  constexpr std::size_t kGrain = 8192;
  std::vector<Centre> centres(ids.size());
  parallelFor(ids.size(), threads, uncancelled, kGrain, [&](std::size_t i) {
    const Triangle& t = triangles[ids[i]];
    const Vec3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
    centres[i] = {{centreOf(a[0], b[0], c[0]), centreOf(a[1], b[1], c[1]), centreOf(a[2], b[2], c[2])},
                  ids[i]};
  });

  // level by level until there are subtrees enough for all threads, then each subtree on its own
  constexpr std::size_t kSubtrees = 64;
  std::vector<Subtree> level{{0, 0, static_cast<std::uint32_t>((ids.size() + kLeafSize - 1) / kLeafSize)}};
  while (level.size() < kSubtrees && level[0].count > 1) {
    parallelFor(level.size(), threads, uncancelled, 1, [&](std::size_t i) {
      if (!level[i].isLeaf()) partition(level[i], centres);
    });
    std::vector<Subtree> next;
    for (const Subtree& tree : level) {
      if (tree.isLeaf()) continue;
      next.push_back(tree.left());
      next.push_back(tree.right());
    }
    level = std::move(next);
  }
  parallelFor(level.size(), threads, uncancelled, 1, [&](std::size_t i) { sortBelow(level[i], centres); });

  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = centres[i].id;
  return ids;
}

}  // namespace thicken::exact
