// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <array>
#include <bit>

#include "mesh/topology.h"
#include "thicken/check.h"

namespace thicken {
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

// Open addressing over ids into the welded positions. Grows with what it holds: the corners of an
// STL file are six times its vertices.
class PlaceTable {
 public:
  explicit PlaceTable(std::size_t expected) : slot_(std::bit_ceil(2 * expected + 2), kNone) {}

  // Brings the line that idOf() of a place with this hash looks at first into the cache.
  void prefetch(std::uint64_t hash) const { __builtin_prefetch(&slot_[hash & (slot_.size() - 1)]); }

  // The id of `p`, whose hash is `hash`, among `positions`, to which it is added when it is new.
  VertexId idOf(const Vec3& p, std::uint64_t hash, std::vector<Vec3>& positions) {
    if (2 * positions.size() + 2 > slot_.size()) grow(positions);
    const Key key = keyOf(p);
    const std::size_t mask = slot_.size() - 1;
    for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
      if (slot_[i] == kNone) {
        slot_[i] = static_cast<VertexId>(positions.size());
        positions.push_back(p);
        return slot_[i];
      }
      if (keyOf(positions[slot_[i]]) == key) return slot_[i];
    }
  }

 private:
  void grow(const std::vector<Vec3>& positions) {
    slot_.assign(2 * slot_.size(), kNone);
    const std::size_t mask = slot_.size() - 1;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      std::size_t i = hashOf(keyOf(positions[v])) & mask;
      while (slot_[i] != kNone) i = (i + 1) & mask;
      slot_[i] = static_cast<VertexId>(v);
    }
  }

  std::vector<VertexId> slot_;
};

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.triangles.reserve(mesh.triangles.size());
  // A surface has about half as many vertices as triangles.
  const std::size_t expected = std::min(mesh.positions.size(), mesh.triangles.size() / 2 + 64);
  result.positions.reserve(expected);
  PlaceTable table(expected);
  std::vector<VertexId> id(mesh.positions.size(), kNone);
  // Looking places up is bound by cache misses; hashes are taken some triangles ahead to hide them.
  constexpr std::size_t kAhead = 8;
  std::array<std::array<std::uint64_t, 3>, kAhead> hashes;
  const auto hash = [&](std::size_t t) {
    for (int k = 0; k < 3; ++k) {
      const VertexId v = mesh.triangles[t][k];
      if (id[v] != kNone) continue;
      hashes[t % kAhead][k] = hashOf(keyOf(mesh.positions[v]));
      table.prefetch(hashes[t % kAhead][k]);
    }
  };
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < std::min(kAhead, count); ++t) hash(t);
  for (std::size_t t = 0; t < count; ++t) {
    Triangle welded;
    for (int k = 0; k < 3; ++k) {
      const VertexId corner = mesh.triangles[t][k];
      VertexId& v = id[corner];
      if (v == kNone) v = table.idOf(mesh.positions[corner], hashes[t % kAhead][k], result.positions);
      welded[k] = v;
    }
    result.triangles.push_back(welded);
    if (t + kAhead < count) hash(t + kAhead);
  }
  return result;
}

}  // namespace thicken
