// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simplify/simplify.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "check/misplaced_shells.h"
#include "mesh/bounds.h"
#include "mesh/topology.h"
#include "simplify/collapse.h"

namespace thicken {

namespace {

using namespace simplifying;

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

// Triangles of parts smaller than the tolerance that another part of the boundary has passed.
std::vector<std::uint8_t> passedBy(const TriangleMesh& solid, std::span<const Region> region, int threads) {
  const Components shells = componentsOf(solid.positions.size(), solid.triangles, threads);
  const std::vector<std::uint8_t> isMisplaced = misplacedShells(solid, region, shells, threads);
  std::vector<std::uint8_t> is(solid.triangles.size());
  for (TriangleId t = 0; t < is.size(); ++t) is[t] = isMisplaced[shells.ofTriangle[t]];
  return is;
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
double collapsed(TriangleMesh& solid, std::vector<Region>& region, const SimplifyRequest& request,
                 const RunContext& context, int threads) {
  LinkedMesh links(solid.positions.size(), solid.triangles, threads);
  if (!links.isClosedManifold()) return 0;
  const double r = request.thickness, most = request.tolerance.value_or(kFollows * r);
  const Bounds bounds = boundsOf(solid);
  const Vec3 center = (bounds.low + bounds.high) / 2;
  const std::size_t surfaceVertices = request.surface.positions.size();
  const ShellDefinition definition(request.surface, request.tree, r, request.join, most, threads);
  ShellTargets targets = shellTargets(solid, region, definition, r, kShare * most,
                                      request.what == Simplify::kShell, center, context, threads);
  if (std::ranges::find(targets.isDense, 1) == targets.isDense.end()) return 0;
  Limits limits{r, kShare * most, request.side, {}};
  if (request.tolerance) limits.proved = kProvedShare * *request.tolerance;
  Collapse collapse(solid, links, region, surfaceVertices, definition, request.tree, targets, center, limits,
                    threads);
  collapse.run(context);
  compact(solid, region, collapsedIn(links, solid.triangles.size()), surfaceVertices);
  if (request.side != Side::kBoth)  // where S is no part of the boundary
    compact(solid, region, passedBy(solid, region, threads), surfaceVertices);
  return collapse.largestDeviation();
}

}  // namespace

SimplifyFacts simplify(TriangleMesh& solid, std::vector<Region>& region, const SimplifyRequest& request,
                       const RunContext& context, int threads) {
  SimplifyFacts facts;
  facts.before = solid.triangles.size();
  if (request.what != Simplify::kOff) facts.deviation = collapsed(solid, region, request, context, threads);
  facts.after = solid.triangles.size();
  facts.worstAspect = worstAspect(solid, region);
  return facts;
}

}  // namespace thicken
