// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Every decision is the sign of an orientation. Two facts carry the cases that are not coplanar.
// With planes A, B of the triangles and their line of intersection d = nA × nB:
//  - In plane A, d points to the left of the side that B's normal points to. So a counter-clockwise
//    corner pair that passes from the positive to the negative side of B does so toward +d; for
//    triangle B and plane A the same holds with −d.
//  - Where both triangles cross the line, their intervals on it overlap unless an end of one lies
//    beyond the far end of the other, which is the orientation of the two edges that make the ends.
#include "exact/triangle_pair.h"

#include <Eigen/Geometry>
#include <utility>

#include "exact/predicates.h"

namespace thicken::exact {
namespace {

struct Corners {
  const Vec3* p[3];
  const Vec3& operator[](int k) const { return *p[k]; }
};

Corners cornersOf(std::span<const Vec3> positions, const Triangle& t) {
  return {{&positions[t[0]], &positions[t[1]], &positions[t[2]]}};
}

// The axis that the triangle is seen best along (in floating point: any answer is a valid one).
int widestAxis(const Corners& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
  return n[0] > n[1] ? (n[0] > n[2] ? 0 : 2) : (n[1] > n[2] ? 1 : 2);
}

// An axis along which the triangle is seen as a triangle, and the sense it is seen in.
struct View {
  int axis, sense;
};
View viewOf(const Corners& t) {
  int axis = widestAxis(t);
  for (int tries = 0; tries < 3; ++tries, axis = (axis + 1) % 3) {
    const int sense = orientation2(t[0], t[1], t[2], axis);
    if (sense != 0) return {axis, sense};
  }
  return {0, 0};
}

bool strictlyOneSided(int x, int y) {
  return x * y > 0;
}

// --- three different vertices on either side

// Whether all corners of `b` are strictly outside of an edge of `a`, seen along an axis.
bool separatedByEdge(const Corners& a, const Corners& b, const View& view) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 &from = a[k], &to = a[(k + 1) % 3];
    bool outside = true;
    for (int i = 0; i < 3 && outside; ++i) outside = orientation2(from, to, b[i], view.axis) * view.sense < 0;
    if (outside) return true;
  }
  return false;
}

bool meetInPlane(const Corners& a, const Corners& b) {
  const View view = viewOf(a);
  const View other{view.axis, orientation2(b[0], b[1], b[2], view.axis)};
  return !separatedByEdge(a, b, view) && !separatedByEdge(b, a, other);
}

// The corner that the line cuts off from the other two, and its side. Corners on the line count for
// whichever side makes this possible.
struct Apex {
  int corner, side;
};
Apex apexOf(const int side[3]) {
  int above = 0, below = 0;
  for (int k = 0; k < 3; ++k) {
    above += side[k] > 0;
    below += side[k] < 0;
  }
  const int wanted = above == 1 ? 1 : (below == 1 ? -1 : 0);
  const int apexSide = wanted != 0 ? wanted : (above == 2 ? -1 : 1);
  for (int k = 0; k < 3; ++k)
    if (side[k] == wanted) return {k, apexSide};
  return {0, apexSide};
}

bool sidesOf(const Corners& plane, const Corners& t, int side[3]) {
  for (int k = 0; k < 3; ++k) side[k] = orientation(plane[0], plane[1], plane[2], t[k]);
  return !(side[0] == side[1] && side[1] == side[2] && side[0] != 0);
}

bool meetApart(const Corners& a, const Corners& b) {
  int sideOfB[3], sideOfA[3];
  if (!sidesOf(a, b, sideOfB)) return false;
  if (sideOfB[0] == 0 && sideOfB[1] == 0 && sideOfB[2] == 0) return meetInPlane(a, b);
  if (!sidesOf(b, a, sideOfA)) return false;

  const Apex top = apexOf(sideOfA), tip = apexOf(sideOfB);
  Corners p{{a.p[top.corner], a.p[(top.corner + 1) % 3], a.p[(top.corner + 2) % 3]}};
  Corners q{{b.p[tip.corner], b.p[(tip.corner + 1) % 3], b.p[(tip.corner + 2) % 3]}};
  // turn each triangle so that the other's apex is on its positive side
  if (top.side < 0) std::swap(q.p[1], q.p[2]);
  if (tip.side < 0) std::swap(p.p[1], p.p[2]);
  return orientation(p[0], p[1], q[0], q[1]) <= 0 && orientation(p[0], p[2], q[0], q[2]) >= 0;
}

// --- one shared vertex: the triangles meet elsewhere if and only if the cones that they span from it do

// Corners: shared vertex, then the two others in the order of the triangle.
bool conesMeetInPlane(const Corners& a, const Corners& b) {
  const View view = viewOf(a);
  const int senseB = orientation2(b[0], b[1], b[2], view.axis);
  const auto inCone = [&view](const Corners& c, int sense, const Vec3& x) {
    return sense * orientation2(c[0], c[1], x, view.axis) >= 0 &&
           sense * orientation2(c[0], x, c[2], view.axis) >= 0;
  };
  // two cones that overlap do so up to a side of one of them
  return inCone(a, view.sense, b[1]) || inCone(a, view.sense, b[2]) || inCone(b, senseB, a[1]) ||
         inCone(b, senseB, a[2]);
}

// Whether a line along a side of a cone separates the two in a projection: cheap, and true for
// most neighbours on a smooth surface, coplanar ones among them.
bool conesSeparatedInView(const Corners& a, const Corners& b) {
  const int axis = widestAxis(a);
  const int sense = orientation2(a[0], a[1], a[2], axis);
  if (sense == 0) return false;
  const auto beyond = [axis](const Vec3& s, const Vec3& to, const Corners& c, int side) {
    return orientation2(s, to, c[1], axis) * side < 0 && orientation2(s, to, c[2], axis) * side < 0;
  };
  if (beyond(a[0], a[1], b, sense) || beyond(a[0], a[2], b, -sense)) return true;
  const int other = orientation2(b[0], b[1], b[2], axis);
  return other != 0 && (beyond(b[0], b[1], a, other) || beyond(b[0], b[2], a, -other));
}

bool meetAtVertex(const Corners& a, const Corners& b) {
  if (conesSeparatedInView(a, b)) return false;
  const int b1 = orientation(a[0], a[1], a[2], b[1]), b2 = orientation(a[0], a[1], a[2], b[2]);
  if (strictlyOneSided(b1, b2)) return false;
  if (b1 == 0 && b2 == 0) return conesMeetInPlane(a, b);
  const int a1 = orientation(b[0], b[1], b[2], a[1]), a2 = orientation(b[0], b[1], b[2], a[2]);
  if (strictlyOneSided(a1, a2)) return false;
  // each cone holds one ray of the line: +d or −d by the sense of its passage
  return (a1 > a2) == (b1 < b2);
}

// --- two shared vertices: the triangles meet elsewhere only when one is folded onto the other

bool meetAtEdge(const Vec3& p, const Vec3& q, const Vec3& u, const Vec3& v) {
  const Corners a{{&p, &q, &u}};
  const View view = viewOf(a);
  if (orientation2(p, q, v, view.axis) != view.sense) return false;
  return orientation(p, q, u, v) == 0;
}

}  // namespace

bool meet(std::span<const Vec3> positions, const Triangle& a, const Triangle& b) {
  int shared = 0, atA[3], atB[3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] != b[j] || shared == 3) continue;
      atA[shared] = i;
      atB[shared] = j;
      ++shared;
    }
  }
  const Corners p = cornersOf(positions, a), q = cornersOf(positions, b);
  if (shared == 0) return meetApart(p, q);
  if (shared == 1) {
    const int i = atA[0], j = atB[0];
    return meetAtVertex({{p.p[i], p.p[(i + 1) % 3], p.p[(i + 2) % 3]}},
                        {{q.p[j], q.p[(j + 1) % 3], q.p[(j + 2) % 3]}});
  }
  if (shared == 2) return meetAtEdge(p[atA[0]], p[atA[1]], p[3 - atA[0] - atA[1]], q[3 - atB[0] - atB[1]]);
  return true;
}

}  // namespace thicken::exact
