// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contour/face_matching.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>

#include "mesh/parallel_sort.h"
#include "thicken/error.h"

namespace thicken::contour {

using field::GridIndex;
using field::UniformGrid;

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

// The items of the passages, in the order of their faces.
std::vector<Item> passageItems(const std::vector<RimPassage>& passages, std::size_t crossings) {
  const auto first = static_cast<std::uint32_t>(4 * crossings);
  std::vector<Item> items(passages.size());
  for (std::uint32_t p = 0; p < passages.size(); ++p)
    items[p] = {passages[p].face, first + p, -passages[p].sign};
  std::sort(items.begin(), items.end(), before);
  return items;
}

// The faces of nodes from `low` to below `high` (keys).
struct FaceRange {
  std::uint64_t low, high;
  [[nodiscard]] bool has(std::uint64_t face) const { return face >> 2 >= low && face >> 2 < high; }
};

// Calls visit(c) for the crossings of all edges beside the faces, and of some others, in order: those edges
// begin at the faces' nodes or at the next one in the direction of an axis.
template <class Visit>
void forCrossingsBeside(const FaceRange& faces, const std::vector<Crossing>& crossings, Visit visit) {
  const auto from = [&](std::uint64_t node) {
    const auto at = std::lower_bound(crossings.begin(), crossings.end(), node,
                                     [](const Crossing& c, std::uint64_t n) { return c.edge >> 2 < n; });
    return static_cast<std::size_t>(at - crossings.begin());
  };
  std::size_t done = 0;
  for (const GridIndex& next : {GridIndex{}, GridIndex{1, 0, 0}, GridIndex{0, 1, 0}, GridIndex{0, 0, 1}}) {
    const std::uint64_t step = UniformGrid::key(next);
    const std::size_t end = from(faces.high + step);
    for (std::size_t c = std::max(done, from(faces.low + step)); c < end; ++c)
      visit(static_cast<std::uint32_t>(c));
    done = std::max(done, end);
  }
}

// The items of the faces, in their order. Crossings are in the order of their edges, so that their items are
// already where only edges of one axis and sides of one kind are looked at.
std::vector<Item> itemsOf(const FaceRange& faces, const std::vector<Crossing>& crossings,
                          std::span<const Item> passages) {
  std::array<std::vector<Item>, 12> runs;
  forCrossingsBeside(faces, crossings, [&](std::uint32_t c) {
    const std::uint64_t edge = crossings[c].edge;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const SideFace side = sideFace(edge, static_cast<int>(k));
      if (faces.has(side.key))
        runs[4 * (edge & 3) + k].push_back({side.key, 4 * c + k, crossings[c].jump * side.sense});
    }
  });
  std::vector<Item> items;
  std::vector<std::size_t> bounds{0};
  const auto append = [&](auto begin, auto end) {
    items.insert(items.end(), begin, end);
    bounds.push_back(items.size());
  };
  for (const std::vector<Item>& run : runs) append(run.begin(), run.end());
  const auto beside = [&](std::uint64_t node) {
    return std::lower_bound(passages.begin(), passages.end(), node,
                            [](const Item& i, std::uint64_t n) { return i.face >> 2 < n; });
  };
  append(beside(faces.low), beside(faces.high));
  mesh::mergeRuns(items, std::move(bounds), before, 1);
  return items;
}

// The arcs of the items' faces; appends those that share their face with others to `together`.
std::vector<Arc> arcsOf(std::span<const Item> items, const Places& places, std::vector<Arc>& together) {
  std::vector<Arc> arcs(items.size() / 2);
  for (std::size_t i = 0, j = 0; i < items.size(); i = j) {
    int sum = 0;
    for (; j < items.size() && items[j].face == items[i].face; ++j) sum += items[j].value;
    if (sum != 0)
      throw Error(ErrorCode::kInternal, "the contour's crossings do not cancel around a face of the grid");
    matchOne(places, items.subspan(i, j - i), &arcs[i / 2]);
    if (j - i > 2) together.insert(together.end(), &arcs[i / 2], &arcs[i / 2] + (j - i) / 2);
  }
  return arcs;
}

}  // namespace

GridIndex sectorOffset(int axis, int k) {
  GridIndex offset{};
  if (k == 1 || k == 2) offset[(axis + 1) % 3] = -1;
  if (k == 2 || k == 3) offset[(axis + 2) % 3] = -1;
  return offset;
}

std::vector<Arc> matchFaces(const std::vector<Crossing>& crossings, const std::vector<RimPassage>& passages,
                            int threads, const VisitArcs& visit) {
  constexpr std::size_t kPart = 1 << 12;
  const std::vector<Item> ofPassages = passageItems(passages, crossings.size());
  const Places places(crossings, passages);
  const std::size_t parts = std::max<std::size_t>(1, (crossings.size() + kPart - 1) / kPart);
  // Faces of nodes before the first crossing's are those of the first part.
  const auto bound = [&](std::size_t part) {
    return part == 0 ? 0 : part == parts ? ~std::uint64_t{0} >> 2 : crossings[part * kPart].edge >> 2;
  };
  std::vector<std::vector<Arc>> together(parts);
  parallel::parallelFor(parts, threads, RunContext(), 1, [&](std::size_t part) {
    const FaceRange faces{bound(part), bound(part + 1)};
    visit(arcsOf(itemsOf(faces, crossings, ofPassages), places, together[part]));
  });
  std::vector<Arc> all;
  for (const auto& part : together) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace thicken::contour
