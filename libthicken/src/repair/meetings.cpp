// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/meetings.h"

#include <algorithm>
#include <numeric>

#include "exact/triangle_pair.h"
#include "mesh/bounds.h"
#include "repair/joints.h"

namespace thicken::repairing {
namespace {

// 64 MiB of pairs and twice that for their graph: a hundred times what the worst scan shows.
constexpr std::size_t kMostPairs = std::size_t{4} << 20;

// Every round divides each triangle at one edge; a triangle that was divided can have corners on
// its other edges, hardly ever more.
constexpr int kMostRounds = 16;

std::size_t dropRepeated(Workpiece& piece, const std::vector<exact::TrianglePair>& pairs) {
  const auto sorted = [&](TriangleId t) {
    Triangle c = piece.mesh.triangles[t];
    std::sort(c.begin(), c.end());
    return c;
  };
  std::size_t dropped = 0;
  for (const auto& [first, later] : pairs) {
    if (piece.present[first] == 0 || piece.present[later] == 0 || sorted(first) != sorted(later)) continue;
    piece.remove(later, RepairKind::kDuplicate);
    ++dropped;
  }
  return dropped;
}

// Nearly everything meets nearly everything: the graph would not fit. The largest triangles first,
// each is kept that meets none of those kept before.
void keepLargestFree(Workpiece& piece, const exact::BoxTree& tree, const RunContext& context) {
  const auto& p = piece.mesh.positions;
  std::vector<TriangleId> order;
  std::vector<double> area(piece.present.size(), 0);
  for (TriangleId t = 0; t < piece.present.size(); ++t) {
    if (piece.present[t] == 0) continue;
    order.push_back(t);
    area[t] = piece.area(t);
  }
  std::stable_sort(order.begin(), order.end(), [&](TriangleId a, TriangleId b) { return area[a] > area[b]; });
  std::vector<std::uint8_t> kept(piece.present.size(), 0);
  for (const TriangleId t : order) {
    context.throwIfCancelled();
    const Triangle& c = piece.mesh.triangles[t];
    mesh::Bounds box;
    for (const VertexId v : c) box.add(p[v]);
    const std::vector<TriangleId> near = tree.near(box.low, box.high);
    kept[t] = std::none_of(near.begin(), near.end(), [&](TriangleId u) {
      return kept[u] != 0 && exact::meet(p, c, piece.mesh.triangles[u]);
    });
    if (kept[t] == 0) piece.remove(t, RepairKind::kSelfIntersecting);
  }
}

}  // namespace

KnownMeetings findMeetings(Workpiece& piece, const RunContext& context, int threads) {
  KnownMeetings known;
  for (int round = 0;; ++round) {
    context.throwIfCancelled();
    const exact::BoxTree tree(piece.mesh.positions, piece.mesh.triangles, threads, piece.present);
    known.pairs =
        tree.meetingPairs(piece.mesh.positions, piece.mesh.triangles, {}, context, threads, kMostPairs);
    known.goneForGood.assign(piece.present.size(), 0);
    if (known.pairs.size() > kMostPairs) {
      const std::vector<std::uint8_t> before = piece.present;
      keepLargestFree(piece, tree, context);
      for (std::size_t t = 0; t < before.size(); ++t) known.goneForGood[t] = before[t] != piece.present[t];
      known.pairs.clear();
      return known;
    }
    const std::size_t dropped = dropRepeated(piece, known.pairs);
    if (dropped > 0) continue;
    if (round >= kMostRounds || divideAtCorners(piece, known.pairs) == 0) return known;
  }
}

}  // namespace thicken::repairing
