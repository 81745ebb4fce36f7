// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/near_corners.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "check/surface_facts.h"
#include "mesh/half_edges.h"
#include "mesh/topology.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::kNone;

namespace {

// Cells of the search distance. Their numbers are whole doubles: they do not overflow however small
// the distance is against the coordinates.
using Cell = std::array<double, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const double x : cell)
      h = (h ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15u + (h >> 29);
    return h ^ (h >> 32);
  }
};

// For every vertex on a rim the length of its shortest edge; 0 for all others, whose edges are
// shared, so that there is nothing to weld at them.
std::vector<double> shortestEdgesAtRims(const TriangleMesh& mesh) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  std::vector<double> shortest(mesh.positions.size(), kInf);
  std::vector<std::uint8_t> onRim(mesh.positions.size(), 0);
  const mesh::HalfEdges edges(mesh.positions.size(), mesh.triangles);
  edges.forEachEdge(
      [&](VertexId a, VertexId b, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
        if (a == b) return;
        if (uses.size() + back.size() == 1) onRim[a] = onRim[b] = 1;
        const double length = (mesh.positions[a] - mesh.positions[b]).norm();
        for (const VertexId v : {a, b}) shortest[v] = std::min(shortest[v], length);
      });
  for (VertexId v = 0; v < onRim.size(); ++v)
    if (onRim[v] == 0 || !checking::isFinite(mesh.positions[v])) shortest[v] = 0;
  return shortest;
}

class Pairing {
 public:
  Pairing(const TriangleMesh& mesh, double distance)
      : mesh_(mesh),
        distance_(distance),
        shortest_(shortestEdgesAtRims(mesh)),
        around_(mesh::vertexTriangles(mesh.positions.size(), mesh.triangles)) {
    result_.onto.resize(mesh.positions.size());
    std::iota(result_.onto.begin(), result_.onto.end(), 0u);
  }

  NearCorners run() {
    for (VertexId v = 0; v < mesh_.positions.size(); ++v) {
      if (shortest_[v] <= 0) continue;
      const VertexId target = nearestStaying(v);
      if (target == kNone) {
        staying_[cellOf(mesh_.positions[v])].push_back(v);
        continue;
      }
      result_.onto[v] = target;
      ++result_.moved;
      result_.farthest = std::max(result_.farthest, (mesh_.positions[v] - mesh_.positions[target]).norm());
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Cell cellOf(const Vec3& p) const {
    return {std::floor(p[0] / distance_), std::floor(p[1] / distance_), std::floor(p[2] / distance_)};
  }

  [[nodiscard]] bool mayJoin(VertexId v, VertexId target, double apart) const {
    if (!(apart <= distance_) || apart > 0.5 * std::min(shortest_[v], shortest_[target])) return false;
    const auto triangles = around_.of(v);
    return std::none_of(triangles.begin(), triangles.end(), [&](TriangleId t) {
      const Triangle& c = mesh_.triangles[t];
      return std::any_of(c.begin(), c.end(), [&](VertexId w) { return result_.onto[w] == target; });
    });
  }

  [[nodiscard]] VertexId nearestStaying(VertexId v) const {
    const Vec3& p = mesh_.positions[v];
    const Cell middle = cellOf(p);
    VertexId best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 27; ++i) {
      const auto found =
          staying_.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1});
      if (found == staying_.end()) continue;
      for (const VertexId w : found->second) {
        const double apart = (p - mesh_.positions[w]).norm();
        if ((apart < least || (apart == least && w < best)) && mayJoin(v, w, apart)) {
          least = apart;
          best = w;
        }
      }
    }
    return best;
  }

  const TriangleMesh& mesh_;
  double distance_;
  std::vector<double> shortest_;
  mesh::VertexTriangles around_;
  std::unordered_map<Cell, std::vector<VertexId>, CellHash> staying_;
  NearCorners result_;
};

}  // namespace

NearCorners nearCorners(const TriangleMesh& mesh, double distance) {
  if (!(distance > 0)) {
    NearCorners none;
    none.onto.resize(mesh.positions.size());
    std::iota(none.onto.begin(), none.onto.end(), 0u);
    return none;
  }
  return Pairing(mesh, distance).run();
}

}  // namespace thicken::repairing
