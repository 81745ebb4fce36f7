// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/closest_point.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "bvh/distance_tree.h"
#include "mesh/normals.h"
#include "mesh/topology.h"

namespace thicken {

using bvh::DistanceTree;
using bvh::PreparedTriangle;
using mesh::kNone;

struct ClosestPointTree::Impl {
  Impl(const TriangleMesh& s, int threads)
      : triangles(s.triangles),
        tree(s.positions, s.triangles, threads),
        across(mesh::neighbours(s.positions.size(), s.triangles, threads)),
        faceNormal(mesh::faceNormals(s.positions, s.triangles, threads)),
        vertexNormal(mesh::vertexNormals(s.positions, s.triangles, faceNormal, threads)),
        rimVertex(s.positions.size(), 0) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (across[t][k] == kNone) rimVertex[triangles[t][k]] = rimVertex[triangles[t][(k + 1) % 3]] = 1;
  }

  [[nodiscard]] ClosestPoint closestOf(const DistanceTree::Hit& hit) const {
    const TriangleId t = hit.triangle;
    const std::uint8_t k = hit.closest.corner;
    ClosestPoint c;
    c.point = hit.closest.point;
    c.distance = std::sqrt(hit.closest.squaredDistance);
    c.triangle = t;
    c.feature = hit.closest.feature;
    c.corner = k;
    switch (c.feature) {
      case Feature::kFace:
        c.pseudonormal = faceNormal[t];
        break;
      case Feature::kEdge: {
        const TriangleId other = across[t][k];
        c.onRim = other == kNone;
        c.pseudonormal = c.onRim ? faceNormal[t] : (faceNormal[t] + faceNormal[other]).stableNormalized();
        break;
      }
      case Feature::kVertex:
        c.onRim = rimVertex[triangles[t][k]] != 0;
        c.pseudonormal = vertexNormal[triangles[t][k]];
        break;
    }
    return c;
  }

  std::vector<Triangle> triangles;
  DistanceTree tree;
  std::vector<std::array<TriangleId, 3>> across;
  std::vector<Vec3> faceNormal;
  std::vector<Vec3> vertexNormal;
  std::vector<std::uint8_t> rimVertex;
};

ClosestPointTree::ClosestPointTree(const TriangleMesh& surface, int threads)
    : impl_(std::make_unique<Impl>(surface, threads)) {}
ClosestPointTree::~ClosestPointTree() = default;
ClosestPointTree::ClosestPointTree(ClosestPointTree&&) noexcept = default;
ClosestPointTree& ClosestPointTree::operator=(ClosestPointTree&&) noexcept = default;

std::optional<ClosestPoint> ClosestPointTree::closest(const Vec3& p, double within) const {
  DistanceTree::Hit hit{{Vec3::Zero(), within * within, Feature::kFace, 0}, kNone};
  if (!impl_->tree.nearest(p, hit)) return std::nullopt;
  return impl_->closestOf(hit);
}

void ClosestPointTree::closest(std::span<const Query> queries, std::span<ClosestPoint> answers) const {
  constexpr std::size_t kMost = 64;
  const DistanceTree& tree = impl_->tree;
  for (std::size_t begin = 0; begin < queries.size(); begin += kMost) {
    const std::size_t count = std::min(kMost, queries.size() - begin);
    Vec3 points[kMost];
    DistanceTree::Hit hits[kMost];
    for (std::size_t i = 0; i < count; ++i) {
      const Query& q = queries[begin + i];
      points[i] = q.point;
      hits[i] = {{Vec3::Zero(), q.within * q.within, Feature::kFace, 0}, kNone};
      if (!q.hint) continue;
      const bvh::TriangleClosest c = tree.measure(q.point, *q.hint);
      if (c.squaredDistance <= hits[i].closest.squaredDistance) hits[i] = {c, *q.hint};
    }
    tree.nearest(std::span(points, count), std::span(hits, count));
    for (std::size_t i = 0; i < count; ++i) {
      if (hits[i].triangle != kNone)
        answers[begin + i] = impl_->closestOf(hits[i]);
      else
        answers[begin + i].distance = std::numeric_limits<double>::infinity();
    }
  }
}

std::size_t ClosestPointTree::placeOf(TriangleId t) const {
  return impl_->tree.placeOf(t);
}

std::size_t ClosestPointTree::triangleCount() const {
  return impl_->triangles.size();
}

double ClosestPointTree::distance(const Vec3& p, std::optional<TriangleId> hint) const {
  DistanceTree::Hit hit{{Vec3::Zero(), std::numeric_limits<double>::infinity(), Feature::kFace, 0}, kNone};
  if (hint) hit = {impl_->tree.measure(p, *hint), *hint};
  impl_->tree.nearest(p, hit);
  return std::sqrt(hit.closest.squaredDistance);
}

double ClosestPointTree::distanceTo(TriangleId t, const Vec3& p) const {
  return std::sqrt(impl_->tree.measure(p, t).squaredDistance);
}

Vec3 ClosestPointTree::closestOn(TriangleId t, const Vec3& p) const {
  return impl_->tree.measure(p, t).point;
}

void ClosestPointTree::near(const std::array<Vec3, 3>& triangle, double within,
                            const std::function<void(TriangleId)>& visit) const {
  impl_->tree.near(PreparedTriangle(triangle, {0, 1, 2}), within, visit);
}

double ClosestPointTree::distance(const std::array<Vec3, 3>& triangle, double within, Except except) const {
  // A normal of a triangle that is no needle is exact to a tenth of this angle.
  constexpr double kClear = 1e-5;
  const Impl& s = *impl_;
  const PreparedTriangle t(triangle, {0, 1, 2});
  std::function<bool(const PreparedTriangle&)> skip;
  if (except != Except::kNothing)
    skip = [&, sense = except == Except::kBefore ? 1 : -1](const PreparedTriangle& own) {
      if (except == Except::kBehind)
        for (const VertexId v : own.ids)
          if (s.rimVertex[v]) return false;
      return std::all_of(triangle.begin(), triangle.end(), [&](const Vec3& p) {
        const Vec3 from = p - own.corner[0];
        return sense * own.normal.dot(from) > kClear * from.norm();
      });
    };
  double squared = within > 0 ? within * within : 0;
  return s.tree.nearest(t, skip, squared) ? std::sqrt(squared) : within;
}

double signedDistance(const Vec3& p, const ClosestPoint& c) {
  const double side = (p - c.point).dot(c.pseudonormal);
  return side > 0 ? c.distance : side < 0 ? -c.distance : 0;
}

bool insideThickened(const Vec3& p, const ClosestPoint& c, double r) {
  if (c.distance == 0) return true;
  return !c.onRim && c.distance <= r && (p - c.point).dot(c.pseudonormal) < 0;
}

}  // namespace thicken
