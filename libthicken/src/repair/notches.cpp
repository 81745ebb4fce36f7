// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/notches.h"

#include <algorithm>
#include <array>

#include "exact/box_tree.h"
#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "mesh/bounds.h"
#include "mesh/edge_key.h"
#include "mesh/float_lattice.h"
#include "mesh/half_edges.h"
#include "repair/divided_triangle.h"

namespace thicken::repairing {

using mesh::Bounds;
using mesh::boundsOf;
using mesh::edgeKey;

namespace {

// How far a new corner may be on the way from the corner between the neighbours to the middle of the third
// edge, as far as the parts up to there meet nothing. Less would leave the notch, and slivers.
constexpr std::array kClear{0.75, 0.5};
// How much of that way is taken: a wall needs room. With all of it more triangles go as folds afterwards than
// came back (opensim_goalie, bff_face, cgal_mannequin-devil: bench/repair_table.py).
constexpr double kTaken = 2.0 / 3;

bool isOfAHole(const Workpiece& piece, TriangleId t) {
  return piece.present[t] == 0 && leavesAHole(piece.reason[t]);
}

class Notches {
 public:
  Notches(Workpiece& piece, int threads)
      : piece_(piece),
        edges_(piece.mesh.positions.size(), piece.mesh.triangles, piece.present),
        tree_(piece.mesh.positions, piece.mesh.triangles, threads, piece.present),
        lattice_(piece.mesh.positions) {}

  double fill() {
    double area = 0;
    const auto count = static_cast<TriangleId>(piece_.mesh.triangles.size());
    for (TriangleId t = 0; t < count; ++t)
      if (isOfAHole(piece_, t)) area += shareOf(t) * piece_.area(t);
    return area;
  }

 private:
  // A part of a triangle that came back.
  struct Part {
    Triangle corners;
    Bounds box;
  };

  // Whether a triangle that is present has the edge to itself, so that another one may use it from a to b.
  [[nodiscard]] bool isFree(VertexId a, VertexId b) const {
    return edges_.uses(a, b).empty() && edges_.uses(b, a).size() == 1 && taken_.count(edgeKey(a, b)) == 0;
  }

  // The share of the triangle that came back; 0: none.
  double shareOf(TriangleId t) {
    const Triangle c = piece_.mesh.triangles[t];
    for (const Triangle& sense : {c, Triangle{c[0], c[2], c[1]}})
      for (int k = 0; k < 3; ++k) {
        const Triangle whole{sense[k], sense[(k + 1) % 3], sense[(k + 2) % 3]};
        if (!isFree(whole[0], whole[1]) || !isFree(whole[2], whole[0])) continue;
        if (sense != c) piece_.turn(t);
        for (const double clear : kClear)
          if (isClear(whole, clear) && divide(t, whole, kTaken * clear)) return kTaken * clear;
        if (sense != c) piece_.turn(t);
      }
    return 0;
  }

  // Adds the corner at this share of the way from the first corner to the middle of the edge before it.
  VertexId addCorner(const Triangle& whole, double share) {
    auto& at = piece_.mesh.positions;
    const Vec3 point = at[whole[0]] + share * (0.5 * (at[whole[1]] + at[whole[2]]) - at[whole[0]]);
    at.push_back(lattice_.nearest(point));
    return static_cast<VertexId>(at.size() - 1);
  }

  // Whether what would come back meets nothing.
  bool isClear(const Triangle& whole, double share) {
    const VertexId corner = addCorner(whole, share);
    const bool clear = isClear({whole[0], whole[1], corner}) && isClear({whole[0], corner, whole[2]});
    piece_.mesh.positions.pop_back();
    return clear;
  }

  bool divide(TriangleId t, const Triangle& whole, double share) {
    const auto [apex, next, last] = whole;
    const Facing facing = facingOf(piece_.mesh.positions, whole);
    const VertexId corner = addCorner(whole, share);
    const auto& at = piece_.mesh.positions;
    const std::array<Triangle, 3> parts{{{apex, next, corner}, {apex, corner, last}, {corner, next, last}}};
    const bool alike = std::all_of(parts.begin(), parts.end(), [&](const Triangle& part) {
      return exact::orientation2(at[part[0]], at[part[1]], at[part[2]], facing.axis) == facing.sign;
    });
    if (!alike || !isClear(parts[0]) || !isClear(parts[1])) {
      piece_.mesh.positions.pop_back();
      return false;
    }
    const RepairKind why = piece_.reason[t];
    for (const Triangle& part : parts) piece_.addPart(part, t);
    piece_.remove(static_cast<TriangleId>(piece_.mesh.triangles.size() - 1), why);
    piece_.remove(t, RepairKind::kDivided);
    taken_.insert({edgeKey(apex, next), edgeKey(last, apex)});
    for (const int i : {0, 1}) back_.push_back({parts[i], boundsOf(piece_.mesh, parts[i])});
    return true;
  }

  [[nodiscard]] bool isClear(const Triangle& part) const {
    const auto meets = [&](const Triangle& other) { return exact::meet(piece_.mesh.positions, part, other); };
    const Bounds box = boundsOf(piece_.mesh, part);
    const std::vector<TriangleId> near = tree_.near(box.low, box.high);
    return std::none_of(near.begin(), near.end(),
                        [&](TriangleId u) { return meets(piece_.mesh.triangles[u]); }) &&
           std::none_of(back_.begin(), back_.end(),
                        [&](const Part& other) { return other.box.overlaps(box) && meets(other.corners); });
  }

  Workpiece& piece_;
  mesh::HalfEdges edges_;
  exact::BoxTree tree_;
  mesh::Lattice lattice_;
  std::vector<Part> back_;
  mesh::EdgeSet taken_;  // edges that a part has
};

}  // namespace

bool leavesAHole(RepairKind why) {
  return removes(why) && why != RepairKind::kDuplicate && why != RepairKind::kDegenerate &&
         why != RepairKind::kNotFinite;
}

double fillNotches(Workpiece& piece, int threads) {
  for (TriangleId t = 0; t < piece.present.size(); ++t)
    if (isOfAHole(piece, t)) return Notches(piece, threads).fill();
  return 0;
}

}  // namespace thicken::repairing
