// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/retreat.h"

#include <algorithm>
#include <cmath>

#include "mesh/sort_unique.h"

namespace thicken::sweep {

using mesh::sortUnique;

namespace {

// A copy of a triangle that meets another is drawn back unless its way is below this share of the
// triangle's longest: it is not what reaches too far.
constexpr double kMuchSmaller = 0.5;
// What remains of the depth after a round; later rounds take more, to end soon.
double remainder(std::size_t round) {
  return round < 8 ? 0.8 : round < 30 ? 0.65 : 0.5;
}
// Least way of a copy in float steps of its coordinates: less is rounding, not depth.
constexpr double kLeastSteps = 16;
constexpr std::size_t kMostRounds = 400;

double leastWay(const Vec3& base) {
  return kLeastSteps * std::ldexp(base.cwiseAbs().maxCoeff(), -23);
}

double wayOf(const Copy& c) {
  return c.depth * c.length;
}

// Lowers the deep copies of the triangles that meet; each copy at most once a round.
class Drawback {
 public:
  Drawback(SweptMesh& mesh, const ConflictTester& tester)
      : mesh_(mesh), tester_(tester), lowered_(mesh.copies.size(), 0) {}

  std::vector<std::uint32_t> apply(const Conflicts& conflicts, double share) {
    std::vector<std::uint32_t> ids;
    conflicts.forTriangles([&](TriangleId t) { apply(t, share, ids); });
    for (const std::uint32_t i : ids) lowered_[i] = 0;
    return ids;
  }

 private:
  void apply(TriangleId t, double share, std::vector<std::uint32_t>& ids) {
    double longest = 0;
    tester_.forCopies(t, [&](std::uint32_t i) { longest = std::max(longest, wayOf(mesh_.copies[i])); });
    tester_.forCopies(t, [&](std::uint32_t i) {
      Copy& c = mesh_.copies[i];
      const double way = wayOf(c), least = leastWay(mesh_.positions[c.base]);
      if (lowered_[i] || way < kMuchSmaller * longest || way <= least) return;
      c.depth *= std::max(share, least / way);
      lowered_[i] = 1;
      ids.push_back(i);
    });
  }

  SweptMesh& mesh_;
  const ConflictTester& tester_;
  std::vector<std::uint8_t> lowered_;
};

std::vector<std::uint32_t> copiesOf(const Conflicts& conflicts, const ConflictTester& tester) {
  std::vector<std::uint32_t> ids;
  conflicts.forTriangles(
      [&](TriangleId t) { tester.forCopies(t, [&](std::uint32_t i) { ids.push_back(i); }); });
  sortUnique(ids);
  return ids;
}

std::vector<VertexId> surfaceVerticesOf(const Conflicts& conflicts, const SweptMesh& mesh) {
  std::vector<VertexId> ids;
  conflicts.forTriangles([&](TriangleId t) {
    if (t >= mesh.surfaceTriangles) ids.insert(ids.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  });
  sortUnique(ids);
  return ids;
}

// The copies and those they are linked to: what a bound on the slope of the copies can come from.
std::vector<std::uint32_t> withNeighbours(const std::vector<std::uint32_t>& copies, const CopyGraph& graph) {
  std::vector<std::uint32_t> all = copies;
  for (const std::uint32_t i : copies)
    for (std::uint32_t k = graph.offset[i]; k < graph.offset[i + 1]; ++k) all.push_back(graph.links[k].copy);
  sortUnique(all);
  return all;
}

}  // namespace

RetreatResult retreat(SweptMesh& mesh, const CopyGraph& graph, ConflictTester& tester, Conflicts conflicts,
                      const RunContext& context) {
  RetreatResult result;
  Drawback drawback(mesh, tester);
  while (!conflicts.empty()) {
    context.throwIfCancelled();
    auto moved = drawback.apply(conflicts, remainder(result.rounds));
    if (moved.empty() || ++result.rounds > kMostRounds) {
      result.stuck = copiesOf(conflicts, tester);
      if (result.stuck.empty()) result.buried = surfaceVerticesOf(conflicts, mesh);
      break;
    }
    const auto more = limitSlope(mesh, graph, moved);
    moved.insert(moved.end(), more.begin(), more.end());
    sortUnique(moved);
    for (const std::uint32_t i : moved) mesh.place(i);
    conflicts = tester.after(moved, conflicts);
  }
  return result;
}

void advance(SweptMesh& mesh, const CopyGraph& graph, ConflictTester& tester, std::span<const double> goal,
             const RunContext& context) {
  constexpr double kStep = 1.25;
  constexpr int kSteps = 8;
  constexpr double kWorthwhile = 1.01;
  std::vector<std::uint8_t> blocked(mesh.copies.size(), 0);
  for (int step = 0; step < kSteps; ++step) {
    context.throwIfCancelled();
    std::vector<double> before(mesh.copies.size());
    std::vector<std::uint32_t> raised;
    for (std::uint32_t i = 0; i < mesh.copies.size(); ++i) {
      Copy& c = mesh.copies[i];
      before[i] = c.depth;
      if (c.dropped || blocked[i] || c.depth * kWorthwhile >= goal[i]) continue;
      c.depth = std::min(goal[i], c.depth * kStep);
      raised.push_back(i);
    }
    if (raised.empty()) break;
    limitSlope(mesh, graph, withNeighbours(raised, graph));
    std::erase_if(raised, [&](std::uint32_t i) { return mesh.copies[i].depth <= before[i]; });
    for (const std::uint32_t i : raised) mesh.place(i);
    Conflicts conflicts = tester.after(raised, {});
    while (!conflicts.empty()) {  // every pass takes at least one raised copy back
      std::vector<std::uint32_t> back;
      for (const std::uint32_t i : copiesOf(conflicts, tester))
        if (mesh.copies[i].depth > before[i]) {
          mesh.copies[i].depth = before[i];
          blocked[i] = 1;
          back.push_back(i);
        }
      for (const std::uint32_t i : back) mesh.place(i);
      conflicts = tester.after(back, conflicts);
    }
  }
}

}  // namespace thicken::sweep
