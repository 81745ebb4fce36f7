// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/face_matching.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

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

// The shortest pairing, so that arcs do not cross; for many items, shortest pairs first.
void matchOne(const Places& places, std::span<Item> items, std::vector<Arc>& arcs) {
  if (items.size() == 2) {
    arcs.emplace_back(items[0].end, items[1].end);
    return;
  }
  const auto middle =
      std::stable_partition(items.begin(), items.end(), [](const Item& i) { return i.value > 0; });
  const std::span<Item> in(items.begin(), middle), out(middle, items.end());
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
    arcs.emplace_back(in[i].end, out[static_cast<std::size_t>(order[i])].end);
}

}  // namespace

GridIndex sectorOffset(int axis, int k) {
  GridIndex offset{};
  if (k == 1 || k == 2) offset[(axis + 1) % 3] = -1;
  if (k == 2 || k == 3) offset[(axis + 2) % 3] = -1;
  return offset;
}

std::vector<Arc> matchFaces(const std::vector<Crossing>& crossings, const std::vector<RimPassage>& passages,
                            int threads) {
  const Places places(crossings, passages);
  std::vector<Item> items;
  items.reserve(4 * crossings.size() + passages.size());
  for (std::uint32_t c = 0; c < crossings.size(); ++c)
    for (int k = 0; k < 4; ++k) {
      const SideFace side = sideFace(crossings[c].edge, k);
      items.push_back({side.key, 4 * c + static_cast<std::uint32_t>(k), crossings[c].jump * side.sense});
    }
  const auto first = static_cast<std::uint32_t>(4 * crossings.size());
  for (std::uint32_t p = 0; p < passages.size(); ++p)
    items.push_back({passages[p].face, first + p, -passages[p].sign});
  parallelSort(
      items, [](const Item& a, const Item& b) { return a.face != b.face ? a.face < b.face : a.end < b.end; },
      threads);
  std::vector<Arc> arcs;
  arcs.reserve(items.size() / 2);
  for (std::size_t i = 0, j = 0; i < items.size(); i = j) {
    int sum = 0;
    for (; j < items.size() && items[j].face == items[i].face; ++j) sum += items[j].value;
    if (sum != 0)
      throw Error(ErrorCode::kInternal, "the contour's crossings do not cancel around a face of the grid");
    matchOne(places, std::span(items).subspan(i, j - i), arcs);
  }
  return arcs;
}

}  // namespace thicken
