// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/retreat.h"

#include <algorithm>
#include <map>
#include <utility>

#include "exact/predicates.h"
#include "mesh/float_lattice.h"
#include "repair/divided_triangle.h"

namespace thicken::repairing {
namespace {

// A half would lose a quarter of a triangle at each corner, an eighth makes gaps that walls hardly fit into.
constexpr double kCut = 0.25;

class Retreat {
 public:
  Retreat(Workpiece& piece, const GivenUp& given, RepairKind why)
      : piece_(piece), given_(given), why_(why), lattice_(piece.mesh.positions) {}

  void run() {
    const auto count = static_cast<TriangleId>(given_.corner.size() / 3);
    for (TriangleId t = 0; t < count; ++t) {
      const auto marked = [&](const std::vector<std::uint8_t>& marks) {
        return (marks[3 * t] | marks[3 * t + 1] | marks[3 * t + 2]) != 0;
      };
      if (piece_.present[t] != 0 && (marked(given_.corner) || marked(given_.edge))) cut(t);
    }
  }

 private:
  struct Corner {
    VertexId vertex;
    bool kept;
  };

  // The new corner near `from` on the edge to `to`.
  VertexId pointOn(VertexId from, VertexId to) {
    const auto [it, fresh] = points_.try_emplace({from, to}, 0u);
    if (fresh) {
      const Vec3 &p = piece_.mesh.positions[from], &q = piece_.mesh.positions[to];
      const Vec3 point = p + kCut * (q - p);
      it->second = static_cast<VertexId>(piece_.mesh.positions.size());
      piece_.mesh.positions.push_back(lattice_.nearest(point));
    }
    return it->second;
  }

  // The rim of the triangle with the new corners on it.
  std::vector<Corner> ringOf(TriangleId t) {
    const Triangle c = piece_.mesh.triangles[t];
    std::vector<Corner> ring;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t before = (k + 2) % 3, after = (k + 1) % 3;
      if (given_.corner[3 * t + k] == 0) {
        ring.push_back({c[k], true});
        continue;
      }
      if (given_.edge[3 * t + before] == 0) ring.push_back({pointOn(c[k], c[before]), true});
      ring.push_back({c[k], false});
      if (given_.edge[3 * t + k] == 0) ring.push_back({pointOn(c[k], c[after]), true});
    }
    return ring;
  }

  // The convex polygon as triangles around the corner that makes the best of them; empty where all turn over.
  [[nodiscard]] std::vector<Triangle> fanOver(const std::vector<VertexId>& ring, Facing facing) const {
    const auto& at = piece_.mesh.positions;
    const std::size_t n = ring.size();
    std::vector<Triangle> best;
    double most = 0;
    for (std::size_t first = 0; first < n; ++first) {
      std::vector<Triangle> fan;
      double least = 2;
      for (std::size_t i = 1; i + 1 < n; ++i) {
        const Triangle part{ring[first], ring[(first + i) % n], ring[(first + i + 1) % n]};
        if (exact::orientation2(at[part[0]], at[part[1]], at[part[2]], facing.axis) != facing.sign) least = 0;
        least = std::min(least, shapeOf(at, part));
        fan.push_back(part);
      }
      if (fan.empty() || least <= most) continue;
      most = least;
      best = std::move(fan);
    }
    return best;
  }

  // Whether an edge that is given up would stay.
  [[nodiscard]] bool keepsLostEdge(TriangleId t) const {
    for (std::uint32_t k = 0; k < 3; ++k)
      if (given_.edge[3 * t + k] != 0 && given_.corner[3 * t + k] == 0 &&
          given_.corner[3 * t + (k + 1) % 3] == 0)
        return true;
    return false;
  }

  void cut(TriangleId t) {
    const std::vector<Corner> ring = ringOf(t);
    std::vector<VertexId> kept;
    for (const Corner& c : ring)
      if (c.kept) kept.push_back(c.vertex);
    const Facing facing = facingOf(piece_.mesh.positions, piece_.mesh.triangles[t]);
    const std::vector<Triangle> parts = fanOver(kept, facing);
    if (parts.empty() || keepsLostEdge(t)) {
      piece_.remove(t, why_);
      return;
    }
    for (const Triangle& part : parts) piece_.addPart(part, t);
    addLost(t, ring);
    piece_.remove(t, RepairKind::kDivided);
  }

  // What lies beyond the cuts, as parts that are gone.
  void addLost(TriangleId t, const std::vector<Corner>& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (!ring[i].kept || ring[(i + 1) % n].kept) continue;
      for (std::size_t j = i + 1; !ring[j % n].kept; ++j) {
        piece_.addPart({ring[i].vertex, ring[j % n].vertex, ring[(j + 1) % n].vertex}, t);
        piece_.remove(static_cast<TriangleId>(piece_.present.size() - 1), why_);
      }
    }
  }

  Workpiece& piece_;
  const GivenUp& given_;
  RepairKind why_;
  mesh::Lattice lattice_;
  std::map<std::pair<VertexId, VertexId>, VertexId> points_;
};

}  // namespace

void retreat(Workpiece& piece, const GivenUp& given, RepairKind why) {
  Retreat(piece, given, why).run();
}

}  // namespace thicken::repairing
