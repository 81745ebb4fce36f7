// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "bvh/triangle_distance.h"
#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "mesh/topology.h"
#include "repair/crumbs.h"

namespace thicken::repairing {
namespace {

constexpr double kSameOrientation = 0.5;  // cosine of the largest angle between normals
constexpr double kAcross = 0.7;           // cosine: what lies on another sheet is above or below it
constexpr double kLeastMeeting = 0.25;    // share of the triangles of an overlap that meet the other part
constexpr int kSmoothings = 4;

class Overlaps {
 public:
  Overlaps(Workpiece& piece, int threads) : piece_(piece), threads_(threads), partOf_(partsOfPiece(piece)) {}

  bool run(std::span<const exact::TrianglePair> pairs) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<TriangleId>> meeting;
    for (const auto& [t, u] : pairs) {
      if (piece_.present[t] == 0 || piece_.present[u] == 0) continue;
      const std::uint32_t a = partOf_[t], b = partOf_[u];
      if (a == b || normal(t).dot(normal(u)) < kSameOrientation) continue;
      auto& list = meeting[std::minmax(a, b)];
      list.push_back(t);
      list.push_back(u);
    }
    if (meeting.empty()) return false;
    measureParts();
    bool removed = false;
    for (auto& [key, list] : meeting) {
      mesh::sortUnique(list);
      removed |= removeOverlap(key.first, key.second, list);
    }
    return removed;
  }

 private:
  [[nodiscard]] Vec3 normal(TriangleId t) const {
    const Triangle& c = piece_.mesh.triangles[t];
    const Vec3& p = piece_.mesh.positions[c[0]];
    return (piece_.mesh.positions[c[1]] - p).cross(piece_.mesh.positions[c[2]] - p).normalized();
  }

  void measureParts() {
    for (TriangleId t = 0; t < piece_.mesh.triangles.size(); ++t)
      if (piece_.present[t] != 0) {
        members_[partOf_[t]].push_back(t);
        area_[partOf_[t]] += piece_.area(t);
      }
  }

  [[nodiscard]] double meanEdge(const std::vector<TriangleId>& triangles) const {
    double sum = 0;
    for (const TriangleId t : triangles) {
      const Triangle& c = piece_.mesh.triangles[t];
      for (int k = 0; k < 3; ++k)
        sum += (piece_.mesh.positions[c[k]] - piece_.mesh.positions[c[(k + 1) % 3]]).norm();
    }
    return sum / (3.0 * static_cast<double>(triangles.size()));
  }

  bool removeOverlap(std::uint32_t a, std::uint32_t b, const std::vector<TriangleId>& meeting) {
    const std::uint32_t larger = area_[a] >= area_[b] ? a : b, smaller = larger == a ? b : a;
    const double reach = std::max(meanEdge(members_[a]), meanEdge(members_[b]));
    std::vector<std::uint8_t> on = lyingOn(smaller, larger, reach);
    std::size_t covered = 0, crossing = 0;
    for (const TriangleId t : members_[smaller]) covered += on[t];
    for (const TriangleId t : meeting) crossing += on[t];
    if (crossing == 0 || static_cast<double>(crossing) < kLeastMeeting * static_cast<double>(covered))
      return false;
    smooth(members_[smaller], on);
    bool removed = false;
    for (const TriangleId t : members_[smaller])
      if (on[t] != 0 && piece_.present[t] != 0) {
        piece_.remove(t, RepairKind::kOverlapping);
        removed = true;
      }
    return removed;
  }

  // Whether the middle of a triangle lies above or below the part of `tree`, and not beside it.
  [[nodiscard]] bool liesOn(TriangleId t, const exact::BoxTree& tree, double reach) const {
    const Vec3 p = piece_.middle(t), n = normal(t), margin = Vec3::Constant(reach);
    double least = reach * reach;
    Vec3 closest = p;
    bool found = false;
    for (const TriangleId u : tree.near(p - margin, p + margin)) {
      const Triangle& c = piece_.mesh.triangles[u];
      if (n.dot(normal(u)) < kSameOrientation) continue;
      const bvh::PreparedTriangle other(
          {piece_.mesh.positions[c[0]], piece_.mesh.positions[c[1]], piece_.mesh.positions[c[2]]}, c);
      const bvh::TriangleClosest hit = bvh::closestOnTriangle(p, other, least);
      if (hit.squaredDistance > least) continue;
      least = hit.squaredDistance;
      closest = hit.point;
      found = true;
    }
    return found && std::abs(n.dot(p - closest)) >= kAcross * (p - closest).norm();
  }

  [[nodiscard]] std::vector<std::uint8_t> lyingOn(std::uint32_t part, std::uint32_t other, double reach) {
    std::vector<std::uint8_t> in(piece_.present.size(), 0), on(piece_.present.size(), 0);
    for (const TriangleId t : members_[other]) in[t] = piece_.present[t];
    const exact::BoxTree tree(piece_.mesh.positions, piece_.mesh.triangles, threads_, in);
    for (const TriangleId t : members_[part]) on[t] = piece_.present[t] != 0 && liesOn(t, tree, reach);
    return on;
  }

  // Gives the border straight runs: a triangle goes with two of its neighbours.
  void smooth(const std::vector<TriangleId>& part, std::vector<std::uint8_t>& on) const {
    const mesh::HalfEdges edges(piece_.mesh.positions.size(), piece_.mesh.triangles, piece_.present);
    for (int round = 0; round < kSmoothings; ++round) {
      const std::vector<std::uint8_t> before = on;
      for (const TriangleId t : part) {
        int alike = 0, others = 0;
        const Triangle& c = piece_.mesh.triangles[t];
        for (int k = 0; k < 3; ++k)
          for (const auto& list : {edges.uses(c[k], c[(k + 1) % 3]), edges.uses(c[(k + 1) % 3], c[k])})
            for (const mesh::HalfEdge& e : list)
              if (e.triangle() != t) ++(before[e.triangle()] == before[t] ? alike : others);
        if (others > alike) on[t] = before[t] ^ 1;
      }
    }
  }

  Workpiece& piece_;
  int threads_;
  std::vector<std::uint32_t> partOf_;
  std::map<std::uint32_t, std::vector<TriangleId>> members_;
  std::map<std::uint32_t, double> area_;
};

}  // namespace

bool removeOverlaps(Workpiece& piece, std::span<const exact::TrianglePair> pairs, int threads) {
  return Overlaps(piece, threads).run(pairs);
}

}  // namespace thicken::repairing
