// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/face_matching.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "mesh/buckets.h"
#include "mesh/parallel_sort.h"
#include "thicken/error.h"

namespace thicken {

namespace {

struct Item {
  std::uint64_t face;
  std::uint32_t end;  ///< of an arc
  int value;          ///< +1 or −1; they cancel in every face
};

// The face between sectors k and k + 1 of an edge: its key, and whether it runs along the edge in the
// edge's direction (+1) when it is gone around counter-clockwise.
struct SideFace {
  std::uint64_t key;
  int sense;
};
SideFace sideFace(std::uint64_t edge, int k) {
  const int axis = static_cast<int>(edge & 3);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  GridIndex n = UniformGrid::indexOf(edge >> 2);
  switch (k) {
    case 0:
      return {UniformGrid::key(n, u), -1};
    case 1:
      --n[u];
      return {UniformGrid::key(n, v), -1};
    case 2:
      --n[v];
      return {UniformGrid::key(n, u), 1};
    default:
      return {UniformGrid::key(n, v), 1};
  }
}

// Where the ends of arcs lie.
class Places {
 public:
  Places(const std::vector<Crossing>& crossings, const std::vector<RimPassage>& passages)
      : crossings_(crossings), passages_(passages) {}
  [[nodiscard]] double distance(const Item& a, const Item& b) const { return (of(a) - of(b)).norm(); }

 private:
  [[nodiscard]] const Vec3& of(const Item& i) const {
    const std::size_t c = i.end / 4;
    return c < crossings_.size() ? crossings_[c].at : passages_[i.end - 4 * crossings_.size()].at;
  }
  const std::vector<Crossing>& crossings_;
  const std::vector<RimPassage>& passages_;
};

double lengthOf(const Places& places, std::span<const Item> in, std::span<const Item> out,
                std::span<const int> order) {
  double sum = 0;
  for (std::size_t i = 0; i < in.size(); ++i)
    sum += places.distance(in[i], out[static_cast<std::size_t>(order[i])]);
  return sum;
}

// The shortest pairing, so that arcs do not cross; for many items, shortest pairs first. One arc for every
// two items, to `arcs`.
void matchOne(const Places& places, std::span<const Item> items, Arc* arcs) {
  if (items.size() == 2) {
    *arcs = {items[0].end, items[1].end};
    return;
  }
  std::vector<Item> in, out;
  for (const Item& i : items) (i.value > 0 ? in : out).push_back(i);
  std::vector<int> order(in.size());
  std::iota(order.begin(), order.end(), 0);
  constexpr std::size_t kMostPermuted = 6;
  if (in.size() <= kMostPermuted) {
    std::vector<int> best = order;
    double least = std::numeric_limits<double>::infinity();
    do {
      const double length = lengthOf(places, in, out, order);
      if (length < least) {
        least = length;
        best = order;
      }
    } while (std::next_permutation(order.begin(), order.end()));
    order = best;
  } else {
    for (bool better = true; better;) {  // exchanges of two, until none shortens
      better = false;
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
          const auto d = [&](std::size_t a, std::size_t b) {
            return places.distance(in[a], out[static_cast<std::size_t>(order[b])]);
          };
          if (d(i, j) + d(j, i) >= (d(i, i) + d(j, j)) * (1 - 1e-12)) continue;
          std::swap(order[i], order[j]);
          better = true;
        }
    }
  }
  for (std::size_t i = 0; i < in.size(); ++i)
    arcs[i] = {in[i].end, out[static_cast<std::size_t>(order[i])].end};
}

bool before(const Item& a, const Item& b) {
  return a.face != b.face ? a.face < b.face : a.end < b.end;
}

// All items, in the order of their faces. Crossings are in the order of their edges, so that their items are
// already where only edges of one axis and sides of one kind are looked at.
std::vector<Item> itemsInOrder(const std::vector<Crossing>& crossings,
                               const std::vector<RimPassage>& passages, int threads) {
  const auto ofAxis = intoBuckets<std::uint32_t>(crossings.size(), 3, threads, [&](std::size_t c, auto& put) {
    put(crossings[c].edge & 3, static_cast<std::uint32_t>(c));
  });
  const auto first = static_cast<std::uint32_t>(4 * crossings.size());
  std::vector<Item> items(first + passages.size());
  std::vector<std::size_t> runs{0};
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 4; ++k) runs.push_back(runs.back() + ofAxis.offset[axis + 1] - ofAxis.offset[axis]);
  parallelFor(crossings.size(), threads, RunContext(), 4096, [&](std::size_t i) {
    const std::uint32_t c = ofAxis.values[i];
    const auto axis = static_cast<std::uint32_t>(crossings[c].edge & 3);
    for (std::uint32_t k = 0; k < 4; ++k) {
      const SideFace side = sideFace(crossings[c].edge, static_cast<int>(k));
      items[runs[4 * axis + k] + i - ofAxis.offset[axis]] = {side.key, 4 * c + k,
                                                             crossings[c].jump * side.sense};
    }
  });
  for (std::uint32_t p = 0; p < passages.size(); ++p)
    items[first + p] = {passages[p].face, first + p, -passages[p].sign};
  std::sort(items.begin() + first, items.end(), before);
  runs.push_back(items.size());
  mergeRuns(items, std::move(runs), before, threads);
  return items;
}

// The arcs of the faces that begin in one part of the items.
void matchPart(const Places& places, std::span<const Item> items, std::size_t begin, std::size_t end,
               Matching& matching, std::vector<std::uint32_t>& together) {
  std::size_t i = begin;
  while (i > 0 && i < items.size() && items[i].face == items[i - 1].face) ++i;
  for (std::size_t j = i; i < end; i = j) {
    int sum = 0;
    for (; j < items.size() && items[j].face == items[i].face; ++j) sum += items[j].value;
    if (sum != 0)
      throw Error(ErrorCode::kInternal, "the contour's crossings do not cancel around a face of the grid");
    matchOne(places, items.subspan(i, j - i), &matching.arcs[i / 2]);
    if (j - i > 2)
      for (std::size_t arc = i / 2; arc < j / 2; ++arc) together.push_back(static_cast<std::uint32_t>(arc));
  }
}

}  // namespace

GridIndex sectorOffset(int axis, int k) {
  GridIndex offset{};
  if (k == 1 || k == 2) offset[(axis + 1) % 3] = -1;
  if (k == 2 || k == 3) offset[(axis + 2) % 3] = -1;
  return offset;
}

Matching matchFaces(const std::vector<Crossing>& crossings, const std::vector<RimPassage>& passages,
                    int threads) {
  const std::vector<Item> items = itemsInOrder(crossings, passages, threads);
  const Places places(crossings, passages);
  Matching matching;
  matching.arcs.resize(items.size() / 2);
  constexpr std::size_t kPart = 1 << 14;
  std::vector<std::vector<std::uint32_t>> together((items.size() + kPart - 1) / kPart);
  parallelForParts(items.size(), threads, RunContext(), kPart,
                   [&](std::size_t part, std::size_t begin, std::size_t end) {
                     matchPart(places, items, begin, end, matching, together[part]);
                   });
  for (const auto& part : together)
    matching.together.insert(matching.together.end(), part.begin(), part.end());
  return matching;
}

}  // namespace thicken
