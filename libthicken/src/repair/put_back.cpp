// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/put_back.h"

#include <algorithm>
#include <queue>
#include <utility>

namespace thicken::repairing {

using mesh::VertexTriangles;

namespace {

enum class Fit { kNot, kAsItIs, kTurned };

// Whether the triangle uses the edge from a to b in this direction (1), the other (−1), or not (0).
int useOf(const Triangle& t, VertexId a, VertexId b) {
  for (int k = 0; k < 3; ++k) {
    if (t[k] == a && t[(k + 1) % 3] == b) return 1;
    if (t[k] == b && t[(k + 1) % 3] == a) return -1;
  }
  return 0;
}

class Returning {
 public:
  Returning(Workpiece& piece, const VertexTriangles& around, const MeetingGraph& graph)
      : piece_(piece), around_(around), graph_(graph) {}

  [[nodiscard]] Fit fitOf(TriangleId t) const {
    for (const TriangleId u : graph_.of(t))
      if (piece_.present[u] != 0) return Fit::kNot;
    const Triangle& c = piece_.mesh.triangles[t];
    bool wantsSame = false, wantsTurned = false;
    std::array<bool, 3> shared{};
    for (int k = 0; k < 3; ++k) {
      const auto [uses, sum] = usesOf(c[k], c[(k + 1) % 3]);
      if (uses > 1) return Fit::kNot;
      shared[k] = uses == 1;
      wantsSame |= sum < 0;
      wantsTurned |= sum > 0;
    }
    if (wantsSame && wantsTurned) return Fit::kNot;
    // a corner that is in use has to be entered along an edge of its fan
    for (int k = 0; k < 3; ++k)
      if (!shared[k] && !shared[(k + 2) % 3] && inUse(c[k])) return Fit::kNot;
    return wantsTurned ? Fit::kTurned : Fit::kAsItIs;
  }

 private:
  // Number of present triangles at an edge, and the sum of their directions.
  [[nodiscard]] std::pair<int, int> usesOf(VertexId a, VertexId b) const {
    const VertexId fewer = around_.of(a).size() <= around_.of(b).size() ? a : b;
    int uses = 0, sum = 0;
    for (const TriangleId t : around_.of(fewer)) {
      if (piece_.present[t] == 0) continue;
      const int use = useOf(piece_.mesh.triangles[t], a, b);
      uses += use != 0;
      sum += use;
    }
    return {uses, sum};
  }
  [[nodiscard]] bool inUse(VertexId v) const {
    const auto list = around_.of(v);
    return std::any_of(list.begin(), list.end(), [&](TriangleId t) { return piece_.present[t] != 0; });
  }

  Workpiece& piece_;
  const VertexTriangles& around_;
  const MeetingGraph& graph_;
};

}  // namespace

void putBack(Workpiece& piece, const VertexTriangles& around, const MeetingGraph& graph,
             std::span<const std::uint8_t> candidate) {
  using Offer = std::pair<double, TriangleId>;
  const auto later = [](const Offer& a, const Offer& b) {
    return a.first != b.first ? a.first < b.first : a.second > b.second;
  };
  std::priority_queue<Offer, std::vector<Offer>, decltype(later)> offers(later);
  const auto offer = [&](TriangleId t) {
    if (candidate[t] != 0 && piece.present[t] == 0) offers.emplace(piece.area(t), t);
  };
  for (TriangleId t = 0; t < candidate.size(); ++t) offer(t);
  const Returning returning(piece, around, graph);
  while (!offers.empty()) {
    const TriangleId t = offers.top().second;
    offers.pop();
    if (piece.present[t] != 0) continue;
    const Fit fit = returning.fitOf(t);
    if (fit == Fit::kNot) continue;
    if (fit == Fit::kTurned) piece.turn(t);
    piece.present[t] = 1;
    // its neighbours may fit now
    for (const VertexId v : piece.mesh.triangles[t])
      for (const TriangleId u : around.of(v)) offer(u);
  }
}

}  // namespace thicken::repairing
