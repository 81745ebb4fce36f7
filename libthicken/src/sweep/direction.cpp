// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/direction.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "parallel/parallel_for.h"

namespace thicken::sweep {

using job::Job;
using mesh::kNone;
using mesh::Rim;

namespace {

// Below this smallest n·m/|m| the even direction gives way to the safest one.
constexpr double kSafeCosine = 0.35;
// A mitre longer than the first is taken where that leaves the definition by less; never one longer than the
// second.
constexpr double kLongMitre = 1.5, kLongestMitre = 4;
// Pull towards the mean normal, against the noise of nearly flat fans.
constexpr double kDamping = 0.01;
constexpr double kRimWeight = 0.5;

double smallestCosine(const Vec3& m, std::span<const Vec3> normals) {
  double s = std::numeric_limits<double>::infinity();
  for (const Vec3& n : normals) s = std::min(s, n.dot(m));
  return s / m.norm();
}

// The point of least norm of the affine hull of `count` points, if it lies in their convex hull.
bool affineMinimum(const Vec3* const* p, int count, Vec3& x) {
  if (count == 1) {
    x = *p[0];
    return true;
  }
  if (count == 2) {
    const Vec3 d = *p[1] - *p[0];
    const double t = -p[0]->dot(d) / d.squaredNorm();
    x = *p[0] + t * d;
    return t > 0 && t < 1;
  }
  const Vec3 u = *p[1] - *p[0], v = *p[2] - *p[0];
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), pu = -p[0]->dot(u), pv = -p[0]->dot(v);
  const double det = uu * vv - uv * uv;
  if (!(det > 1e-14 * uu * vv)) return false;
  const double s = (pu * vv - pv * uv) / det, t = (pv * uu - pu * uv) / det;
  x = *p[0] + s * u + t * v;
  return s > 0 && t > 0 && s + t < 1;
}

// Reduces a simplex of up to four points to the face that holds its point of least norm.
Vec3 reduceSimplex(std::array<Vec3, 4>& simplex, int& size) {
  Vec3 best = Vec3::Zero();
  double bestNorm = std::numeric_limits<double>::infinity();
  std::array<int, 3> bestFace{};
  int bestCount = 0;
  for (int mask = 1; mask < (1 << size); ++mask) {
    const Vec3* p[4];
    std::array<int, 3> face{};
    int count = 0;
    for (int i = 0; i < size; ++i) {
      if (!(mask & (1 << i))) continue;
      if (count < 3) {
        face[count] = i;
        p[count] = &simplex[i];
      }
      ++count;
    }
    if (count > 3) continue;
    Vec3 x;
    if (!affineMinimum(p, count, x) || x.squaredNorm() >= bestNorm) continue;
    best = x;
    bestNorm = x.squaredNorm();
    bestFace = face;
    bestCount = count;
  }
  for (int i = 0; i < bestCount; ++i) simplex[i] = simplex[bestFace[i]];  // bestFace ascends
  size = bestCount;
  return best;
}

// Whether the origin lies in the tetrahedron.
bool holdsOrigin(const std::array<Vec3, 4>& s) {
  for (int k = 0; k < 4; ++k) {
    const Vec3 &a = s[(k + 1) % 4], &b = s[(k + 2) % 4], &c = s[(k + 3) % 4];
    const Vec3 n = (b - a).cross(c - a);
    if (n.dot(s[k] - a) * n.dot(-a) <= 0) return false;
  }
  return true;
}

// Least squares over Σ area·(n·m − way)² + the rim planes' Σ (c·m)², damped towards the mean normal.
class EvenDirection {
 public:
  void addFace(const Vec3& normal, const OffsetPlane& plane, double area, double altitude) {
    altitude_ += area * altitude;
    a_ += area * plane.normal * plane.normal.transpose();
    b_ += area * plane.way * plane.normal;
    mean_ += area * normal;
    weight_ += area;
  }
  void addRim(const Vec3& conormal) {
    rim_ += conormal * conormal.transpose();
    conormals_[std::min(conormalCount_++, 1)] = conormal;
  }
  /// How long a mitre of so many thicknesses may be: at its tip there is too much, but a shorter one tilts
  /// the triangles around it as far as they reach.
  [[nodiscard]] double longestMitre(double mitre, double thickness) const {
    if (mitre <= kLongMitre) return kLongMitre;
    const double excess = std::sqrt(mitre * mitre - 1) - std::acos(1 / mitre);  // in r², of a cross-section
    const double missing = (1 - kLongMitre / mitre) * altitude_ / weight_ / thickness;
    return missing < excess ? kLongMitre : kLongestMitre;
  }
  [[nodiscard]] Vec3 solve() const {
    const Vec3 mean = mean_.stableNormalized();
    const Eigen::Matrix3d a = a_ / weight_ + kRimWeight * rim_ + kDamping * Eigen::Matrix3d::Identity();
    return leanOutward(a.ldlt().solve(b_ / weight_ + kDamping * mean));
  }

 private:
  // Where the wall's planes do not agree on a direction it leans out of them and not into the part, so that
  // next to the rim S has its thickness below it as well.
  [[nodiscard]] Vec3 leanOutward(const Vec3& m) const {
    if (conormalCount_ != 2) return m;
    const double inward = std::max(conormals_[0].dot(m), conormals_[1].dot(m));
    const Vec3 out = conormals_[0] + conormals_[1];
    const double gain = std::min(conormals_[0].dot(out), conormals_[1].dot(out));
    constexpr double kLeastGain = 0.2, kMostLean = 0.35;
    if (!(inward > 0) || gain < kLeastGain) return m;
    const double step = inward / gain;
    return step * out.norm() > kMostLean ? m : Vec3(m - step * out);
  }

  std::array<Vec3, 2> conormals_;
  int conormalCount_ = 0;
  Eigen::Matrix3d a_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d rim_ = Eigen::Matrix3d::Zero();
  Vec3 b_ = Vec3::Zero(), mean_ = Vec3::Zero();
  double weight_ = 0, altitude_ = 0;
};

// The rim edges that end at each vertex: two on the rim of a valid surface, else none.
std::vector<std::array<std::uint32_t, 2>> rimEdgesAt(std::size_t vertexCount, const Rim& rim) {
  std::vector<std::array<std::uint32_t, 2>> at(vertexCount, {kNone, kNone});
  for (std::uint32_t i = 0; i < rim.edges.size(); ++i)
    for (const VertexId v : {rim.edges[i].from, rim.edges[i].to}) at[v][at[v][0] == kNone ? 0 : 1] = i;
  return at;
}

}  // namespace

Vec3 minNormPoint(std::span<const Vec3> points) {
  std::array<Vec3, 4> simplex;
  simplex[0] = points[0];
  int size = 1;
  Vec3 x = points[0];
  // Each step lowers the norm; the bound only guards against rounding.
  for (int step = 0; step < 100; ++step) {
    const Vec3* support = &points[0];
    for (const Vec3& p : points)
      if (p.dot(x) < support->dot(x)) support = &p;
    if (support->dot(x) >= x.squaredNorm() - 1e-12) break;
    simplex[size++] = *support;
    if (size == 4 && holdsOrigin(simplex)) return Vec3::Zero();
    const Vec3 next = reduceSimplex(simplex, size);
    if (next.squaredNorm() >= x.squaredNorm()) break;
    x = next;
  }
  return x;
}

std::vector<OffsetPlane> offsetPlanes(const Job& job, std::span<const Vec3> faceNormal, double sign) {
  std::vector<OffsetPlane> planes;
  planes.reserve(faceNormal.size());
  for (TriangleId t = 0; t < faceNormal.size(); ++t) {
    // The points q − r(q)·n of the plane of t.
    const double way = 1 / std::sqrt(1 + job.thickness.slope(t).squaredNorm());
    planes.push_back({way * (faceNormal[t] - sign * job.thickness.slope(t)), way});
  }
  return planes;
}

std::vector<SweepDirection> sweepDirections(const Job& job, std::span<const Vec3> faceNormal,
                                            std::span<const OffsetPlane> plane,
                                            const mesh::VertexTriangles& around, const Rim& rim) {
  const TriangleMesh& surface = job.surface;
  const std::size_t n = surface.positions.size();
  const auto rimAt = rimEdgesAt(n, rim);
  const auto evenDirection = [&](VertexId v) {
    EvenDirection even;
    for (const TriangleId t : around.of(v)) {
      const auto& [a, b, c] = surface.triangles[t];
      const Vec3 &p = surface.positions[a], &q = surface.positions[b], &r = surface.positions[c];
      const double area = (q - p).cross(r - p).norm();
      const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
      even.addFace(faceNormal[t], plane[t], area, area / longest);
    }
    for (const std::uint32_t i : rimAt[v]) {
      if (i == kNone) continue;
      const mesh::RimEdge& e = rim.edges[i];
      const Vec3 along = (surface.positions[e.to] - surface.positions[e.from]).stableNormalized();
      even.addRim(along.cross(faceNormal[e.triangle]));
    }
    return even;
  };
  std::vector<SweepDirection> direction(n);
  constexpr std::size_t kGrain = 1024;
  parallel::parallelFor(n, job.threads, RunContext(), kGrain, [&](std::size_t v) {
    const auto fan = around.of(static_cast<VertexId>(v));
    if (fan.empty()) return;
    thread_local std::vector<Vec3> normals;
    normals.clear();
    for (const TriangleId t : fan) normals.push_back(faceNormal[t]);
    const EvenDirection even = evenDirection(static_cast<VertexId>(v));
    Vec3 m = even.solve();
    double safety = smallestCosine(m, normals);
    if (!(safety >= kSafeCosine)) {
      const Vec3 hull = minNormPoint(normals);
      const double least = hull.norm();  // the smallest n·m over all unit m, at m = hull/|hull|
      if (least > 1e-6) {
        m = hull / (least * least);  // n·m ≥ 1 everywhere
        safety = smallestCosine(m, normals);
      } else {
        safety = 0;
      }
    }
    const double r = job.thickness.at(static_cast<VertexId>(v));
    if (const double most = even.longestMitre(m.norm(), r); m.norm() > most) m *= most / m.norm();
    direction[v] = {m, safety};
  });
  return direction;
}

}  // namespace thicken::sweep
