// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/shell_targets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "measure/measure.h"
#include "mesh/normals.h"
#include "parallel/parallel_for.h"

namespace thicken::simplify {

using job::Job;
using measure::areaOf;
using measure::joinOf;

namespace {

using Place = ShellDefinition::Place;
using Corners = std::array<Vec3, 3>;

Corners cornersOf(const TriangleMesh& mesh, TriangleId t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
}

// The middles of the n² triangles that a triangle is divided into.
template <class Visit>
void forMiddles(const Corners& t, int n, Visit visit) {
  const Vec3 u = (t[1] - t[0]) / (3 * n), v = (t[2] - t[0]) / (3 * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      visit(Vec3(t[0] + (3 * i + 1) * u + (3 * j + 1) * v));
      if (i + j + 1 < n) visit(Vec3(t[0] + (3 * i + 2) * u + (3 * j + 2) * v));
    }
}

// Whether each triangle has a vertex with a dense one.
std::vector<std::uint8_t> besideDense(const TriangleMesh& solid, std::span<const std::uint8_t> isDense) {
  std::vector<std::uint8_t> marked(solid.positions.size(), 0), beside(isDense.size(), 0);
  for (TriangleId t = 0; t < isDense.size(); ++t)
    if (isDense[t])
      for (const VertexId v : solid.triangles[t]) marked[v] = 1;
  for (TriangleId t = 0; t < beside.size(); ++t)
    for (const VertexId v : solid.triangles[t]) beside[t] |= marked[v];
  return beside;
}

double longestEdge(const Corners& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

// Triangles of a side are divided in so many for their targets.
int divisionsOf(const Corners& t, double r) {
  constexpr double kSide = 0.5;  // of r
  constexpr int kMost = 4;
  return static_cast<int>(std::clamp(std::ceil(longestEdge(t) / (kSide * r)), 1.0, double{kMost}));
}

// What the definition says of the middle of a triangle.
Place middleOf(const Corners& c, Region region, const ShellDefinition& definition) {
  const Vec3 p = (c[0] + c[1] + c[2]) / 3;
  Place place;
  if (region == Region::kWall) {
    place.target = p;
    place.isLoose = place.isWall = true;
  } else {
    place = definition.at(p);
  }
  if (place.isLoose) place.normal = (c[1] - c[0]).cross(c[2] - c[0]).stableNormalized();
  return place;
}

// How far from a target triangles may be, mm.
double reachOf(const Place& place, double error) {
  // A wall may lean (Remark 4), and its edges are as rough as the cells that it was made in. Chosen: with
  // the shell's own reach the rim of a contour keeps most of its triangles.
  constexpr double kWall = 3;
  return place.isWall ? kWall * error : error;
}

void addTargets(ShellTargets& made, TriangleId t, const Corners& c, const Place& middle,
                const ShellDefinition& definition, double r, double error) {
  const int n = divisionsOf(c, r);
  if (n == 1) {
    if (!middle.isFree) made.add(t, middle.target, reachOf(middle, error));
    return;
  }
  forMiddles(c, n, [&](const Vec3& p) {
    const Place place = middle.isLoose ? middle : definition.at(p);
    if (!place.isFree) made.add(t, place.isLoose ? p : place.target, reachOf(place, error));
  });
}

}  // namespace

ShellDefinition::ShellDefinition(const Job& job, double most)
    : job_(job),
      normal_(mesh::faceNormals(job.surface.positions, job.surface.triangles, job.threads)),
      around_(mesh::vertexTriangles(job.surface.positions.size(), job.surface.triangles, job.threads)),
      error_(job, normal_, around_, joinOf(job.options)),
      most_(most) {}

Place ShellDefinition::at(const Vec3& p) const {
  const ClosestPoint c = *job_.tree.closest(p);
  Place place;
  place.target = p;
  place.area = areaOf(job_.surface.positions, job_.surface.triangles[c.triangle]);
  const measure::OffsetError::Error error = error_.at(p, c);
  place.error = error.mm;
  place.isWall = c.onRim;
  place.isLoose = c.onRim || std::abs(error.mm) > most_ || c.distance <= 0;
  if (place.isLoose) return place;
  place.isFree = joinOf(job_.options) == Join::kMitre && c.feature != Feature::kFace && error.mm <= 0;
  place.target = p - error.mm * error.away;
  place.normal = error.gradient;
  return place;
}

bool isLookedAt(const Corners& corner, double r) {
  // A chord of a fifth across a round join is off by half a percent of r.
  return longestEdge(corner) > r / 5;
}

ShellTargets shellTargets(const Job& job, const TriangleMesh& solid, std::span<const Region> region,
                          const ShellDefinition& definition, double error, bool copies, const Vec3& center) {
  constexpr double kDense = 0.5;  // of the area of the triangle of S
  const std::size_t count = solid.triangles.size();
  std::vector<Place> middle(count);
  ShellTargets made;
  made.isDense.assign(count, 0);
  made.isLoose.assign(count, 0);
  made.first.assign(count, ShellTargets::kEnd);
  made.quadric.resize(solid.positions.size());
  parallel::parallelFor(count, job.threads, job.context, 256, [&](std::size_t i) {
    if (region[i] == Region::kOriginal) return;
    const auto t = static_cast<TriangleId>(i);
    middle[t] = middleOf(cornersOf(solid, t), region[t], definition);
    made.isLoose[t] = middle[t].isLoose;
    made.isDense[t] = copies || region[t] == Region::kWall ||
                      areaOf(solid.positions, solid.triangles[t]) < kDense * middle[t].area;
  });
  const std::vector<std::uint8_t> beside = besideDense(solid, made.isDense);
  std::vector<std::uint8_t> hasTarget(solid.positions.size(), 0);
  for (TriangleId t = 0; t < count; ++t) {
    if (t % 256 == 0) {
      job.context.throwIfCancelled();
      job.context.count();
    }
    if (!beside[t] || region[t] == Region::kOriginal) continue;
    if (!middle[t].isFree)
      for (const VertexId v : solid.triangles[t])
        made.quadric[v].add(middle[t].normal, middle[t].target - center,
                            areaOf(solid.positions, solid.triangles[t]));
    addTargets(made, t, cornersOf(solid, t), middle[t], definition, job.thickness.least(), error);
    if (made.isLoose[t])
      for (const VertexId v : solid.triangles[t])
        if (!std::exchange(hasTarget[v], std::uint8_t{1}))
          made.add(t, solid.positions[v], reachOf(middle[t], error));
  }
  return made;
}

}  // namespace thicken::simplify
