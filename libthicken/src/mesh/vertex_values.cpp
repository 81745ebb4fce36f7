// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_values.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <unordered_map>

#include "mesh/place_text.h"
#include "thicken/closest_point.h"
#include "thicken/error.h"

namespace thicken::mesh {

namespace {

struct PlaceHash {
  std::size_t operator()(const Vec3& p) const {
    std::size_t hash = 0;
    for (const double x : p) hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
    return hash;
  }
};

// The value at a point of a triangle, linear over it; of one without area, that of a corner.
double valueOn(const TriangleMesh& mesh, std::span<const double> values, const ClosestPoint& c) {
  const Triangle& t = mesh.triangles[c.triangle];
  const VertexId near = t[c.corner];
  const auto [least, most] = std::minmax({values[t[0]], values[t[1]], values[t[2]]});
  const double change = slopeOver(mesh, t, values).dot(c.point - mesh.positions[near]);
  return std::clamp(values[near] + change, least, most);
}

}  // namespace

Vec3 slopeOver(const TriangleMesh& mesh, const Triangle& t, std::span<const double> values) {
  const Vec3& p = mesh.positions[t[0]];
  const Vec3 u = mesh.positions[t[1]] - p, v = mesh.positions[t[2]] - p, n = u.cross(v);
  const double area2 = n.squaredNorm();
  if (!(area2 > 0)) return Vec3::Zero();
  return ((values[t[1]] - values[t[0]]) * v.cross(n) + (values[t[2]] - values[t[0]]) * n.cross(u)) / area2;
}

std::vector<double> valuesAt(const TriangleMesh& from, std::span<const double> values, const TriangleMesh& to,
                             std::string_view what) {
  std::unordered_map<Vec3, double, PlaceHash> at;
  at.reserve(from.positions.size());
  for (std::size_t v = 0; v < from.positions.size(); ++v) {
    const auto [place, isNew] = at.emplace(from.positions[v], values[v]);
    if (!isNew && place->second != values[v])
      throw Error(ErrorCode::kInvalidArgument,
                  fmt::format("vertices at {} have different values of {}, {:.6g} and {:.6g}; corners in one "
                              "place are one vertex",
                              text(from.positions[v]), what, place->second, values[v]));
  }
  std::vector<double> there;
  there.reserve(to.positions.size());
  std::optional<ClosestPointTree> tree;  // only where a vertex is new
  for (const Vec3& p : to.positions) {
    const auto place = at.find(p);
    if (place == at.end() && !tree) tree.emplace(from);
    there.push_back(place != at.end() ? place->second : valueOn(from, values, *tree->closest(p)));
  }
  return there;
}

}  // namespace thicken::mesh
