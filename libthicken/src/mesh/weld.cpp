// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "platform/prefetch.h"
#include "thicken/check.h"

namespace thicken {

using mesh::kNone;
using parallel::parallelFor;

namespace {

using Key = std::array<std::uint64_t, 3>;

// Bit patterns make NaN equal to itself; adding 0 makes −0 equal to 0.
Key keyOf(const Vec3& p) {
  return {std::bit_cast<std::uint64_t>(p[0] + 0.0), std::bit_cast<std::uint64_t>(p[1] + 0.0),
          std::bit_cast<std::uint64_t>(p[2] + 0.0)};
}

std::uint64_t hashOf(const Key& key) {
  std::uint64_t h = 0;
  for (const std::uint64_t k : key) {  // the finaliser of splitmix64, chained
    h += k + 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
    h ^= h >> 31;
  }
  return h;
}

// Open addressing over the ids of places, which grows with what it holds.
class PlaceTable {
 public:
  PlaceTable(std::span<const Vec3> places, std::span<const std::uint64_t> hashes, std::size_t expected)
      : places_(places), hashes_(hashes), slot_(std::bit_ceil(2 * expected + 2), kNone) {}

  // Brings the line that firstOf() looks at first into the cache.
  void prefetch(std::uint32_t id) const { platform::prefetch(&slot_[hashes_[id] & (slot_.size() - 1)]); }

  // The place that was asked for first of those that equal this one: the place itself when it is new.
  std::uint32_t firstOf(std::uint32_t id) {
    if (2 * count_ + 2 > slot_.size()) grow();
    const Key key = keyOf(places_[id]);
    const std::size_t mask = slot_.size() - 1;
    for (std::size_t i = hashes_[id] & mask;; i = (i + 1) & mask) {
      if (slot_[i] == kNone) {
        ++count_;
        return slot_[i] = id;
      }
      if (keyOf(places_[slot_[i]]) == key) return slot_[i];
    }
  }

 private:
  void grow() {
    const std::vector<std::uint32_t> old = std::exchange(slot_, {});
    slot_.assign(2 * old.size(), kNone);
    const std::size_t mask = slot_.size() - 1;
    for (const std::uint32_t id : old) {
      if (id == kNone) continue;
      std::size_t i = hashes_[id] & mask;
      while (slot_[i] != kNone) i = (i + 1) & mask;
      slot_[i] = id;
    }
  }

  std::span<const Vec3> places_;
  std::span<const std::uint64_t> hashes_;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> slot_;
};

// Of each place the first that equals it. Places are shared out by their hashes, so that equal ones come to
// one thread.
std::vector<std::uint32_t> firstEqual(std::span<const Vec3> places, int threads) {
  constexpr std::size_t kGrain = 8192, kAhead = 16;
  std::vector<std::uint64_t> hashes(places.size());
  parallelFor(places.size(), threads, RunContext(), kGrain,
              [&](std::size_t i) { hashes[i] = hashOf(keyOf(places[i])); });
  const std::size_t shares =
      places.size() > kGrain
          ? std::min<std::size_t>(static_cast<std::size_t>(parallel::threadCount(threads)), 8)
          : 1;
  std::vector<std::uint32_t> first(places.size());
  parallelFor(shares, threads, RunContext(), 1, [&](std::size_t share) {
    const auto isMine = [&](std::size_t i) { return (hashes[i] >> 32) % shares == share; };
    PlaceTable table(places, hashes, places.size() / shares + places.size() / 16);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      if (i + kAhead < places.size() && isMine(i + kAhead)) table.prefetch(i + kAhead);
      if (isMine(i)) first[i] = table.firstOf(i);
    }
  });
  return first;
}

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh, int threads) {
  // Places are numbered by their first use, so that the lowest of equal ones is used first.
  std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
  std::vector<Vec3> places;
  places.reserve(std::min(mesh.positions.size(), 3 * mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles)
    for (const VertexId v : t)
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(places.size());
        places.push_back(mesh.positions[v]);
      }
  const std::vector<std::uint32_t> first = firstEqual(places, threads);
  TriangleMesh result;
  result.positions.reserve(places.size());
  std::vector<VertexId> id(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    id[i] = first[i] == i ? static_cast<VertexId>(result.positions.size()) : id[first[i]];
    if (first[i] == i) result.positions.push_back(places[i]);
  }
  result.triangles.resize(mesh.triangles.size());
  parallelFor(result.triangles.size(), threads, RunContext(), 8192, [&](std::size_t t) {
    const auto& [a, b, c] = mesh.triangles[t];
    result.triangles[t] = {id[number[a]], id[number[b]], id[number[c]]};
  });
  return result;
}

}  // namespace thicken
