// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/joints.h"

#include <algorithm>
#include <map>

#include "exact/predicates.h"
#include "mesh/half_edges.h"

namespace thicken::repairing {
namespace {

// Whether x lies on the open segment from p to q. Exact.
bool strictlyBetween(const Vec3& p, const Vec3& q, const Vec3& x) {
  int axis = 0;
  (q - p).cwiseAbs().maxCoeff(&axis);
  const bool inside = (p[axis] < x[axis] && x[axis] < q[axis]) || (q[axis] < x[axis] && x[axis] < p[axis]);
  return inside && exact::collinear(p, q, x);
}

class Joints {
 public:
  Joints(const Workpiece& piece)
      : mesh_(piece.mesh), edges_(mesh_.positions.size(), mesh_.triangles, piece.present) {}

  // Notes the corners of `other` that lie on rim edges of `t`.
  void look(TriangleId t, TriangleId other) {
    const Triangle& c = mesh_.triangles[t];
    for (const VertexId x : mesh_.triangles[other]) {
      if (std::find(c.begin(), c.end(), x) != c.end()) continue;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const VertexId p = c[k], q = c[(k + 1) % 3];
        if (!onRim(p, q) || !strictlyBetween(at(p), at(q), at(x)) || !rimRunsAlong(x, p, q)) continue;
        found_[3 * t + k].push_back(x);
      }
    }
  }

  // Per triangle the edge with the lowest number and the corners on it, in their order along it.
  [[nodiscard]] std::map<std::uint32_t, std::vector<VertexId>> oneEdgeEach() {
    std::map<std::uint32_t, std::vector<VertexId>> result;
    TriangleId last = 0;
    for (auto& [slot, corners] : found_) {
      if (!result.empty() && slot / 3 == last) continue;
      last = slot / 3;
      const Vec3 from = at(mesh_.triangles[slot / 3][slot % 3]);
      std::sort(corners.begin(), corners.end(), [&](VertexId a, VertexId b) {
        const double da = (at(a) - from).squaredNorm(), db = (at(b) - from).squaredNorm();
        return da != db ? da < db : a < b;
      });
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      result.emplace(slot, corners);
    }
    return result;
  }

 private:
  [[nodiscard]] const Vec3& at(VertexId v) const { return mesh_.positions[v]; }
  [[nodiscard]] bool onRim(VertexId a, VertexId b) const {
    return edges_.uses(a, b).size() + edges_.uses(b, a).size() == 1;
  }
  // Whether a rim edge at x runs along the line from p to q: only then does dividing join something.
  [[nodiscard]] bool rimRunsAlong(VertexId x, VertexId p, VertexId q) const {
    const auto along = [&](VertexId y) {
      return y != x && onRim(x, y) && exact::collinear(at(p), at(q), at(y));
    };
    for (const mesh::HalfEdge& e : edges_.from(x)) {
      const VertexId third = mesh_.triangles[e.triangle()][(e.corner() + 2) % 3];
      if (along(e.to) || along(third)) return true;
    }
    return false;
  }

  const TriangleMesh& mesh_;
  mesh::HalfEdges edges_;
  std::map<std::uint32_t, std::vector<VertexId>> found_;  // by 3 · triangle + corner
};

}  // namespace

std::size_t divideAtCorners(Workpiece& piece, std::span<const exact::TrianglePair> pairs) {
  if (pairs.empty()) return 0;
  Joints joints(piece);
  for (const auto& [a, b] : pairs) {
    joints.look(a, b);
    joints.look(b, a);
  }
  const auto divisions = joints.oneEdgeEach();
  for (const auto& [slot, corners] : divisions) {
    const TriangleId whole = slot / 3;
    const Triangle c = piece.mesh.triangles[whole];
    const VertexId apex = c[(slot + 2 - 3 * whole) % 3];
    VertexId from = c[slot % 3];
    for (const VertexId x : corners) {
      piece.addPart({from, x, apex}, whole);
      from = x;
    }
    piece.addPart({from, c[(slot + 1 - 3 * whole) % 3], apex}, whole);
    piece.remove(whole, RepairKind::kDivided);
  }
  return divisions.size();
}

}  // namespace thicken::repairing
