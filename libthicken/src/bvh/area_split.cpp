// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bvh/area_split.h"

#include <algorithm>
#include <array>
#include <vector>

#include "parallel/parallel_for.h"

namespace thicken::bvh {

namespace {

constexpr int kBins = 16;
// Ranges of so few take fewer bins: most of the time of these is what it costs to compare them.
constexpr std::uint32_t kFew = 32;
constexpr int kBinsOfFew = 6;
// Triangles that a thread takes at a time of a large range.
constexpr std::uint32_t kPart = 8192;

struct Bin {
  AreaSplit::Box box, middles;
  std::uint32_t count = 0;
  void add(const Bin& b) {
    box.add(b.box);
    middles.add(b.middles);
    count += b.count;
  }
  [[nodiscard]] double cost() const { return count == 0 ? 0 : count * box.halfArea(); }
};

// The last bin on the left where the costs of both sides are the least; −1 where all are in one bin.
int bestBin(std::span<const Bin> bins) {
  const int count = static_cast<int>(bins.size());
  double rightCost[kBins] = {};
  Bin side;
  for (int b = count - 1; b > 0; --b) {
    side.add(bins[static_cast<std::size_t>(b)]);
    rightCost[b] = side.cost();
  }
  side.add(bins[0]);
  const std::uint32_t all = side.count;
  side = Bin();
  double best = std::numeric_limits<double>::infinity();
  int bestBin = -1;
  for (int b = 0; b + 1 < count; ++b) {
    side.add(bins[static_cast<std::size_t>(b)]);
    if (side.count == 0 || side.count == all) continue;
    const double cost = side.cost() + rightCost[b + 1];
    if (cost < best) {
      best = cost;
      bestBin = b;
    }
  }
  return bestBin;
}

}  // namespace

double AreaSplit::Box::halfArea() const {
  const double x = double{high[0]} - double{low[0]}, y = double{high[1]} - double{low[1]},
               z = double{high[2]} - double{low[2]};
  return x * y + y * z + z * x;
}

AreaSplit::AreaSplit(std::span<const Vec3> positions, std::span<const Triangle> triangles, const Vec3& centre,
                     int threads)
    : count_(static_cast<std::uint32_t>(triangles.size())),
      items_(
          new Item[triangles.size()]),  // uninitialised, so that its pages are first touched by all threads
      other_(new Item[triangles.size()]) {
  parallel::parallelFor(triangles.size(), threads, RunContext(), 4096, [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    const Vec3 &p = positions[a], &q = positions[b], &r = positions[c];
    Item& item = items_[t];
    item.low.head<3>() = (p.cwiseMin(q).cwiseMin(r) - centre).cast<float>().array();
    item.high.head<3>() = (p.cwiseMax(q).cwiseMax(r) - centre).cast<float>().array();
    item.low[3] = std::bit_cast<float>(static_cast<std::uint32_t>(t));
    item.high[3] = 0;
  });
}

AreaSplit::Range AreaSplit::rangeOf(std::uint32_t begin, std::uint32_t end) const {
  Range r{begin, end, {}, {}};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Item& item = items_[i];
    const Four middle = item.low + item.high;
    r.box.add({item.low, item.high});
    r.middles.add({middle, middle});
  }
  return r;
}

AreaSplit::Range AreaSplit::whole() const {
  return rangeOf(0, count_);
}

std::pair<AreaSplit::Range, AreaSplit::Range> AreaSplit::halve(const Range& r) const {
  const std::uint32_t middle = r.begin + r.size() / 2;
  return {rangeOf(r.begin, middle), rangeOf(middle, r.end)};
}

std::pair<AreaSplit::Range, AreaSplit::Range> AreaSplit::split(const Range& r, int threads) {
  int axis = 0;
  const float extent = (r.middles.high - r.middles.low).head<3>().maxCoeff(&axis);
  if (!(extent > 0)) return halve(r);  // all middles coincide
  const int binCount = r.size() > kFew ? kBins : kBinsOfFew;
  const float low = r.middles.low[axis], last = static_cast<float>(binCount - 1),
              scale = static_cast<float>(binCount) / extent;
  std::array<Bin, kBins> room;
  const std::span<Bin> bins(room.data(), static_cast<std::size_t>(binCount));
  const auto sortInto = [&](std::span<Bin> into, std::uint32_t i) {
    Item& item = items_[i];
    const Four middle = item.low + item.high;
    // in this order also for what is no number, by overflow
    const float at = std::min(last, std::max(0.0f, (middle[axis] - low) * scale));
    const auto b = static_cast<std::uint32_t>(at);
    into[b].box.add({item.low, item.high});
    into[b].middles.add({middle, middle});
    ++into[b].count;
    item.setBin(b);
  };
  if (r.size() <= kPart) {
    for (std::uint32_t i = r.begin; i < r.end; ++i) sortInto(bins, i);
  } else {
    std::vector<std::array<Bin, kBins>> parts((r.size() + kPart - 1) / kPart);
    parallel::parallelForParts(r.size(), threads, RunContext(), kPart,
                               [&](std::size_t part, std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end; ++i)
                                   sortInto(parts[part], r.begin + static_cast<std::uint32_t>(i));
                               });
    for (const auto& part : parts)
      for (std::size_t b = 0; b < bins.size(); ++b) bins[b].add(part[b]);
  }
  const int best = bestBin(bins);
  if (best < 0) return halve(r);
  // Each is written to both sides, and stays on one: what side it is on cannot be predicted.
  Item *left = items_.get() + r.begin, *right = other_.get() + r.begin;
  for (std::uint32_t i = r.begin; i < r.end; ++i) {
    const Item item = items_[i];
    const bool toLeft = item.bin() <= static_cast<std::uint32_t>(best);
    *left = *right = item;
    left += toLeft;
    right += !toLeft;
  }
  std::copy(other_.get() + r.begin, right, left);
  const auto middle = static_cast<std::uint32_t>(left - items_.get());
  Bin sides[2];
  for (int b = 0; b < binCount; ++b) sides[b > best].add(bins[static_cast<std::size_t>(b)]);
  return {{r.begin, middle, sides[0].box, sides[0].middles}, {middle, r.end, sides[1].box, sides[1].middles}};
}

}  // namespace thicken::bvh
