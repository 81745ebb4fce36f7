// SPDX-License-Identifier: LGPL-2.1-or-later
#include "job/rim_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "mesh/segment.h"
#include "mesh/topology.h"
#include "thicken/error.h"

namespace thicken::job {

namespace {

// The vertices that share a triangle with one of the rim and are not on it themselves: how far they are, the
// median.
double distanceOfFirstRow(const TriangleMesh& surface, const std::vector<double>& distance) {
  std::vector<std::uint8_t> isNext(distance.size(), 0);
  for (const Triangle& t : surface.triangles)
    if (std::ranges::any_of(t, [&](VertexId v) { return distance[v] == 0; }))
      for (const VertexId v : t) isNext[v] = static_cast<std::uint8_t>(distance[v] > 0);
  std::vector<double> row;
  for (VertexId v = 0; v < distance.size(); ++v)
    if (isNext[v] != 0) row.push_back(distance[v]);
  if (row.empty())
    throw Error(
        ErrorCode::kInvalidArgument,
        "all corners of the surface are on its rim, so that the thickness of the rim would be that of "
        "the whole solid; divide the triangles of the surface, or leave out the profile of the rim");
  const auto middle = row.begin() + static_cast<std::ptrdiff_t>(row.size() / 2);
  std::nth_element(row.begin(), middle, row.end());
  return *middle;
}

}  // namespace

bool hasRimProfile(const Options& options) {
  return options.rimThickness || options.rimRound;
}

Options withoutRimProfile(Options options) {
  options.rimThickness = options.rimWidth = options.rimRound = std::nullopt;
  return options;
}

double profiled(double r, double distance, const Options& options) {
  if (options.rimThickness && distance < *options.rimWidth)
    r = *options.rimThickness + (r - *options.rimThickness) * (distance / *options.rimWidth);
  if (options.rimRound && distance < *options.rimRound) {
    const double radius = *options.rimRound, away = radius - distance;
    r -= radius - std::sqrt(std::max(0.0, radius * radius - away * away));
  }
  return r;
}

std::vector<double> distancesToRim(const TriangleMesh& surface, double reach, int threads) {
  std::vector<double> distance(surface.positions.size(), std::numeric_limits<double>::infinity());
  const mesh::Rim rim = mesh::rimOf(surface.positions.size(), surface.triangles, threads);
  if (rim.edges.empty()) return distance;
  const mesh::VertexTriangles around =
      mesh::vertexTriangles(surface.positions.size(), surface.triangles, threads);
  using Entry = std::tuple<double, VertexId, std::uint32_t>;  // distance of the vertex from the rim's edge
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::uint32_t e = 0; e < rim.edges.size(); ++e)
    for (const VertexId v : {rim.edges[e].from, rim.edges[e].to}) {
      distance[v] = 0;
      open.emplace(0, v, e);
    }
  // Every vertex asks its neighbours whether the edge that it is nearest to is nearer to them than theirs.
  while (!open.empty()) {
    const auto [far, v, e] = open.top();
    open.pop();
    if (far > distance[v] || far > reach) continue;
    const Vec3 &a = surface.positions[rim.edges[e].from], &b = surface.positions[rim.edges[e].to];
    for (const TriangleId t : around.of(v))
      for (const VertexId other : surface.triangles[t])
        if (const double there = mesh::toSegment(surface.positions[other], a, b); there < distance[other]) {
          distance[other] = there;
          open.emplace(there, other, e);
        }
  }
  return distance;
}

RimFacts addRimProfile(const TriangleMesh& surface, const Options& options, int threads,
                       std::vector<double>& r) {
  RimFacts facts{options.rimThickness, options.rimWidth, options.rimRound, std::nullopt};
  const double reach = std::max(options.rimThickness ? *options.rimWidth : 0, options.rimRound.value_or(0));
  const std::vector<double> distance = distancesToRim(surface, reach, threads);
  if (std::ranges::none_of(distance, [](double d) { return d == 0; })) return facts;
  facts.row = distanceOfFirstRow(surface, distance);
  for (VertexId v = 0; v < r.size(); ++v) r[v] = profiled(r[v], distance[v], options);
  return facts;
}

}  // namespace thicken::job
