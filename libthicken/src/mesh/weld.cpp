// SPDX-License-Identifier: LGPL-2.1-or-later
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

// Open addressing over ids into the welded positions.
class PlaceTable {
 public:
  explicit PlaceTable(std::size_t places) : slot_(std::bit_ceil(2 * places + 2), kNone) {}

  // The id of `p` among `positions`, to which it is added when it is new.
  VertexId idOf(const Vec3& p, std::vector<Vec3>& positions) {
    const Key key = keyOf(p);
    const std::size_t mask = slot_.size() - 1;
    for (std::size_t i = hashOf(key) & mask;; i = (i + 1) & mask) {
      if (slot_[i] == kNone) {
        slot_[i] = static_cast<VertexId>(positions.size());
        positions.push_back(p);
        return slot_[i];
      }
      if (keyOf(positions[slot_[i]]) == key) return slot_[i];
    }
  }

 private:
  std::vector<VertexId> slot_;
};

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.triangles.reserve(mesh.triangles.size());
  PlaceTable table(mesh.positions.size());
  std::vector<VertexId> id(mesh.positions.size(), kNone);
  for (const Triangle& t : mesh.triangles) {
    Triangle welded;
    for (int k = 0; k < 3; ++k) {
      VertexId& v = id[t[k]];
      if (v == kNone) v = table.idOf(mesh.positions[t[k]], result.positions);
      welded[k] = v;
    }
    result.triangles.push_back(welded);
  }
  return result;
}

}  // namespace thicken
