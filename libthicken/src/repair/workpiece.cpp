// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/workpiece.h"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

namespace thicken::repairing {

Workpiece::Workpiece(TriangleMesh surface)
    : mesh(std::move(surface)),
      origin(mesh.triangles.size()),
      present(mesh.triangles.size(), 1),
      reason(mesh.triangles.size(), RepairKind::kDegenerate),
      turned(mesh.triangles.size(), 0) {
  std::iota(origin.begin(), origin.end(), 0u);
}

void Workpiece::remove(TriangleId t, RepairKind why) {
  present[t] = 0;
  reason[t] = why;
}

void Workpiece::turn(TriangleId t) {
  std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  turned[t] ^= 1;
}

void Workpiece::addPart(const Triangle& part, TriangleId whole) {
  mesh.triangles.push_back(part);
  origin.push_back(origin[whole]);
  present.push_back(1);
  reason.push_back(RepairKind::kDegenerate);
  turned.push_back(turned[whole]);
}

void Workpiece::addNew(const Triangle& corners, RepairKind why) {
  mesh.triangles.push_back(corners);
  origin.push_back(RepairResult::kAdded);
  present.push_back(1);
  reason.push_back(why);
  turned.push_back(0);
}

double Workpiece::area(TriangleId t) const {
  const Triangle& c = mesh.triangles[t];
  const Vec3 &p = mesh.positions[c[0]], &q = mesh.positions[c[1]], &r = mesh.positions[c[2]];
  return 0.5 * (q - p).cross(r - p).norm();
}

Vec3 Workpiece::middle(TriangleId t) const {
  const Triangle& c = mesh.triangles[t];
  return mesh.positions[c[0]] / 3 + mesh.positions[c[1]] / 3 + mesh.positions[c[2]] / 3;
}

}  // namespace thicken::repairing
