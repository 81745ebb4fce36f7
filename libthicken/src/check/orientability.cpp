// SPDX-License-Identifier: LGPL-2.1-or-later
#include "check/orientability.h"

#include <numeric>
#include <utility>

namespace thicken::checking {

using mesh::HalfEdge;

namespace {

// Disjoint sets whose members also know whether they have to be turned over against their root.
class SenseSets {
 public:
  explicit SenseSets(std::size_t count) : up_(count), turned_(count, 0) {
    std::iota(up_.begin(), up_.end(), 0u);
  }

  // The root, and whether `i` is of the other sense.
  std::pair<TriangleId, bool> find(TriangleId i) {
    TriangleId top = i;
    bool turned = false;
    while (up_[top] != top) {
      turned ^= turned_[top] != 0;
      top = up_[top];
    }
    bool rest = turned;
    while (up_[i] != top && i != top) {  // hang everything on the way directly below the root
      const bool step = turned_[i] != 0;
      turned_[i] = rest;
      rest ^= step;
      i = std::exchange(up_[i], top);
    }
    return {top, turned};
  }

  // States that a and b are of the other sense (or not); false when this contradicts what was stated.
  bool relate(TriangleId a, TriangleId b, bool otherSense) {
    const auto [rootA, turnedA] = find(a);
    const auto [rootB, turnedB] = find(b);
    const bool turned = turnedA ^ turnedB ^ otherSense;
    if (rootA == rootB) return !turned;
    up_[rootA > rootB ? rootA : rootB] = rootA > rootB ? rootB : rootA;
    turned_[rootA > rootB ? rootA : rootB] = turned;
    return true;
  }

 private:
  std::vector<TriangleId> up_;
  std::vector<std::uint8_t> turned_;
};

}  // namespace

Orientability orientability(const TriangleMesh& mesh, const mesh::HalfEdges& edges) {
  Orientability result;
  const std::size_t count = mesh.triangles.size();
  SenseSets senses(count);
  std::vector<TriangleId> contradicting;
  edges.forEachEdge(
      [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
        if (uses.size() + back.size() != 2) return;
        const TriangleId other = back.empty() ? uses[1].triangle() : back[0].triangle();
        if (senses.relate(uses[0].triangle(), other, back.empty())) return;
        result.oneSided.push_back({a, b});
        contradicting.push_back(other);
      });

  std::vector<std::size_t> size(count, 0), turned(count, 0);
  for (TriangleId t = 0; t < count; ++t) {
    const auto [root, isTurned] = senses.find(t);
    ++size[root];
    turned[root] += isTurned;
  }
  std::vector<std::uint8_t> oneSided(count, 0);
  for (const TriangleId t : contradicting) oneSided[senses.find(t).first] = 1;
  for (TriangleId t = 0; t < count; ++t) {
    const auto [root, isTurned] = senses.find(t);
    const bool turnedAreFewer = 2 * turned[root] <= size[root];
    if (oneSided[root] == 0 && isTurned == turnedAreFewer) result.toTurn.push_back(t);
  }
  return result;
}

}  // namespace thicken::checking
