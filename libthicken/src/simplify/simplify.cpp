// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "check/misplaced_shells.h"
#include "mesh/bounds.h"
#include "mesh/topology.h"
#include "simplify/collapse.h"

namespace thicken::simplify {

using job::Job;
using mesh::LinkedMesh;

namespace {

// A resin printer draws 25 to 50 µm, which is 1 % of a wall of some millimetres.
constexpr double kFollows = 0.01;
// Of the tolerance, what a collapse may take: errors are looked at in places, and between them there is more.
constexpr double kShare = 0.7;
// A proof for some triangles allows for less rounding than that for all of the solid.
constexpr double kProvedShare = 0.999;

// Drops triangles and vertices that none uses; S's vertices stay, used or not.
void compact(TriangleMesh& solid, std::vector<Region>& region, std::span<const std::uint8_t> isGone,
             std::size_t surfaceVertices) {
  constexpr VertexId kUnused = 0xffffffffu;
  std::size_t count = 0;
  std::vector<VertexId> to(solid.positions.size(), kUnused);
  for (TriangleId t = 0; t < solid.triangles.size(); ++t) {
    if (isGone[t]) continue;
    region[count] = region[t];
    solid.triangles[count++] = solid.triangles[t];
    for (const VertexId v : solid.triangles[t]) to[v] = 0;
  }
  solid.triangles.resize(count);
  region.resize(count);
  VertexId next = 0;
  for (VertexId v = 0; v < to.size(); ++v) {
    if (to[v] == kUnused && v >= surfaceVertices) continue;
    solid.positions[next] = solid.positions[v];
    to[v] = next++;
  }
  solid.positions.resize(next);
  for (Triangle& t : solid.triangles)
    for (VertexId& v : t) v = to[v];
}

// Triangles that went with an edge.
std::vector<std::uint8_t> collapsedIn(const LinkedMesh& links, std::size_t triangles) {
  std::vector<std::uint8_t> isGone(triangles);
  for (TriangleId t = 0; t < triangles; ++t) isGone[t] = links.isGone(t);
  return isGone;
}

// Drops parts smaller than the tolerance that another part of the boundary has passed.
void dropPassed(TriangleMesh& solid, std::vector<Region>& region, std::size_t surfaceVertices, int threads) {
  const mesh::Components shells = mesh::componentsOf(solid.positions.size(), solid.triangles, threads);
  const std::vector<std::uint8_t> isMisplaced = checking::misplacedShells(solid, region, shells, threads);
  if (std::ranges::find(isMisplaced, 1) == isMisplaced.end()) return;
  std::vector<std::uint8_t> isGone(solid.triangles.size());
  for (TriangleId t = 0; t < isGone.size(); ++t) isGone[t] = isMisplaced[shells.ofTriangle[t]];
  compact(solid, region, isGone, surfaceVertices);
}

double worstAspect(const TriangleMesh& solid, std::span<const Region> region) {
  double worst = 0;
  for (TriangleId t = 0; t < region.size(); ++t) {
    if (region[t] == Region::kOriginal) continue;
    const auto& [a, b, c] = solid.triangles[t];
    worst = std::max(worst, aspectOf(solid.positions[a], solid.positions[b], solid.positions[c]));
  }
  return worst;
}

// Collapses what it can of a solid. Returns the largest deviation, mm.
double collapsed(const Job& job, TriangleMesh& solid, std::vector<Region>& region, Simplify what) {
  LinkedMesh links(solid.positions.size(), solid.triangles, job.threads);
  if (!links.isClosedManifold()) return 0;
  const std::optional<double>& tolerance = job.options.tolerance;
  const double most = tolerance.value_or(kFollows * job.thickness.least());
  const mesh::Bounds bounds = mesh::boundsOf(solid);
  const Vec3 center = (bounds.low + bounds.high) / 2;
  const ShellDefinition definition(job, most);
  ShellTargets targets =
      shellTargets(job, solid, region, definition, kShare * most, what == Simplify::kShell, center);
  if (std::ranges::find(targets.isDense, 1) == targets.isDense.end()) return 0;
  Limits limits{kShare * most, {}};
  if (tolerance) limits.proved = kProvedShare * *tolerance;
  Collapse collapse(job, solid, links, region, definition, targets, center, limits);
  collapse.run();
  const std::size_t surfaceVertices = job.surface.positions.size();
  compact(solid, region, collapsedIn(links, solid.triangles.size()), surfaceVertices);
  if (job.options.side != Side::kBoth)  // where S is no part of the boundary
    dropPassed(solid, region, surfaceVertices, job.threads);
  return collapse.largestDeviation();
}

}  // namespace

SimplifyFacts simplify(const Job& job, TriangleMesh& solid, std::vector<Region>& region, Simplify what) {
  SimplifyFacts facts;
  facts.before = solid.triangles.size();
  if (what != Simplify::kOff) facts.deviation = collapsed(job, solid, region, what);
  facts.after = solid.triangles.size();
  facts.worstAspect = worstAspect(solid, region);
  return facts;
}

}  // namespace thicken::simplify
