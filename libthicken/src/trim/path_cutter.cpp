// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim/path_cutter.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/bounds.h"
#include "mesh/float_lattice.h"
#include "mesh/place_text.h"
#include "thicken/error.h"
#include "trim/edge_way.h"
#include "trim/trim_line_error.h"

namespace thicken::trimming {

using mesh::kNone;
using mesh::roundToFloat;
using mesh::text;

namespace {

// So often the way between two points is halved, at vertices of the surface: enough for any that a person
// would leave between two clicks.
constexpr int kMostHalvings = 12;
// Where the cut between two points leaves the surface, a way that is so many times as long as their distance
// is taken instead. A longer one leads around a hole, which is not what was drawn.
constexpr double kLongestAroundRim = 1.5;
// Of the diagonal; a loop that is farther away belongs to another surface, or has another unit.
constexpr double kFarthestPoint = 0.1;
// A plane needs a direction: that of normals which do not cancel, across the way.
constexpr double kLeastUp = 0.2;

// The least of the shares that the corners of `t` have in `p`: below 0 outside of the triangle.
double leastShare(const DividedSurface& surface, TriangleId t, const Vec3& p) {
  const auto& [a, b, c] = surface.triangles()[t];
  const Vec3 &pa = surface.at(a), &pb = surface.at(b), &pc = surface.at(c);
  const Vec3 normal = (pb - pa).cross(pc - pa);
  const auto share = [&](const Vec3& q, const Vec3& r) {
    return (q - p).cross(r - p).dot(normal) / normal.squaredNorm();
  };
  return std::min({share(pb, pc), share(pc, pa), share(pa, pb)});
}

Vec3 onSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double squared = (b - a).squaredNorm();
  return squared > 0 ? a + std::clamp((p - a).dot(b - a) / squared, 0., 1.) * (b - a) : a;
}

}  // namespace

Ground::Ground(const TriangleMesh& s, int threads)
    : surface(s), tree(s, threads), whole(s, threads), floatStep(0), diagonal(0) {
  const mesh::Bounds box = mesh::boundsOf(s);
  diagonal = (box.high - box.low).norm();
  const double farthest = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  floatStep = static_cast<double>(std::nextafter(static_cast<float>(farthest), INFINITY)) - farthest;
  floatStep = std::max(floatStep, farthest * 0x1p-24);
}

PathCutter::PathCutter(const Ground& ground, double tolerance)
    : ground_(ground), surface_(ground.whole), tolerance_(tolerance) {}

TriangleId PathCutter::pieceOf(const ClosestPoint& c) const {
  TriangleId best = kNone;
  double most = 0;
  for (const TriangleId t : surface_.piecesOf(c.triangle)) {
    const double share = leastShare(surface_, t, c.point);
    if (best != kNone && share <= most) continue;
    best = t;
    most = share;
  }
  return best;
}

TriangleId PathCutter::pieceAt(const Vec3& p) const {
  return pieceOf(*ground_.tree.closest(p));
}

// Notes how far `v` is from its place on the path.
VertexId PathCutter::moved(VertexId v, const Vec3& exact) {
  deviation_ = std::max(deviation_, (surface_.at(v) - exact).norm());
  return v;
}

// The vertex at a point of the surface: one that is there, or a new one.
VertexId PathCutter::place(const ClosestPoint& c) {
  const TriangleId t = pieceOf(c);
  const Triangle corners = surface_.triangles()[t];
  for (const VertexId v : corners)
    if ((surface_.at(v) - c.point).norm() <= tolerance_) return moved(v, c.point);
  for (int k = 0; k < 3; ++k) {
    const Vec3 p = onSegment(surface_.at(corners[k]), surface_.at(corners[(k + 1) % 3]), c.point);
    if ((p - c.point).norm() <= tolerance_)
      return moved(surface_.divideEdge({t, k}, roundToFloat(p)), c.point);
  }
  return moved(surface_.divideTriangle(t, roundToFloat(c.point)), c.point);
}

VertexId PathCutter::placePoint(const Vec3& p, double& farthest) {
  const auto c = ground_.tree.closest(p);
  if (!c) throw Error(ErrorCode::kInvalidArgument, "a point of a loop has a coordinate that is not a number");
  if (c->distance > kFarthestPoint * ground_.diagonal)
    throw trimLineError(
        fmt::format("loop {} is {:.4g} mm away from the surface at its point {}; a loop has to lie near it",
                    loop_ + 1, c->distance, text(p)),
        p);
  farthest = std::max(farthest, c->distance);
  const VertexId v = place(*c);
  normalAt_.try_emplace(v, c->pseudonormal);
  return v;
}

Error PathCutter::blocked(const Way& way, VertexId from, VertexId to) const {
  const auto between = fmt::format("between {} and {}", text(surface_.at(from)), text(surface_.at(to)));
  const auto whose = [&] {
    return marks_.loopOf(way.met) == loop_ ? std::string("itself")
                                           : fmt::format("loop {}", marks_.loopOf(way.met) + 1);
  };
  switch (way.end) {
    case WayEnd::kLeaves:
      return trimLineError(fmt::format("loop {} leaves the surface at {}, {}; keep it inside of the rim",
                                       loop_ + 1, text(way.place), between),
                           way.place);
    case WayEnd::kCrosses:
    case WayEnd::kTouches:
      return trimLineError(
          fmt::format("loop {} {} {} at {}, {}; move its points apart there", loop_ + 1,
                      way.end == WayEnd::kCrosses ? "crosses" : "touches", whose(), text(way.place), between),
          way.place);
    default:
      return trimLineError(
          fmt::format("loop {} finds no short way {}; put more points there", loop_ + 1, between),
          surface_.at(from));
  }
}

void PathCutter::connect(VertexId from, VertexId to, int depth, std::vector<VertexId>& path) {
  const Vec3 ahead = surface_.at(to) - surface_.at(from);
  const Vec3 up = normalAt_.at(from) + normalAt_.at(to);
  Way way;
  way.place = surface_.at(from);
  if (ahead.cross(up).norm() > kLeastUp * ahead.norm() || surface_.edgeBetween(from, to).triangle != kNone)
    way = planeCut(surface_, marks_, from, to, up, tolerance_);
  if (way.end == WayEnd::kArrived) return divideAlong(way, from, path);
  const bool isBlocked = way.end == WayEnd::kCrosses || way.end == WayEnd::kTouches;
  if (isBlocked || depth == kMostHalvings) throw blocked(way, from, to);
  const double longest =
      way.end == WayEnd::kLeaves ? kLongestAroundRim * ahead.norm() : std::numeric_limits<double>::infinity();
  const VertexId middle = middleOfEdgeWay(surface_, marks_, from, to, longest);
  if (middle == kNone) throw blocked(way, from, to);
  normalAt_.try_emplace(middle, ground_.tree.closest(surface_.at(middle))->pseudonormal);
  marks_.addVertex(middle, loop_);
  connect(from, middle, depth + 1, path);
  connect(middle, to, depth + 1, path);
}

void PathCutter::divideAlong(const Way& way, VertexId from, std::vector<VertexId>& path) {
  for (const WayPoint& p : way.points) {
    VertexId v = p.vertex;
    if (v == kNone) {
      const EdgeOf edge = surface_.edgeBetween(p.edge[0], p.edge[1]);
      if (edge.triangle == kNone) throw TooNarrow(p.place);  // the way came to this edge before
      v = moved(surface_.divideEdge(edge, roundToFloat(p.place)), p.place);
    }
    if (surface_.edgeBetween(from, v).triangle == kNone) throw TooNarrow(p.place);
    if (marks_.hasEdge(from, v))
      throw trimLineError(fmt::format("loop {} turns back on itself at {}; leave out a point there",
                                      loop_ + 1, text(surface_.at(from))),
                          surface_.at(from));
    marks_.addVertex(v, loop_);
    marks_.addEdge(from, v);
    path.push_back(v);
    from = v;
  }
}

CutPath PathCutter::cut(std::span<const Vec3> points, bool closed) {
  CutPath result;
  std::vector<VertexId> stops;
  for (const Vec3& p : points) {
    const VertexId v = placePoint(p, result.facts.farthest);
    if (!stops.empty() && (v == stops.back() || (closed && v == stops.front() && &p == &points.back())))
      continue;
    if (marks_.hasVertex(v))
      throw trimLineError(
          fmt::format("loop {} comes to {} where loop {} has been already; move its points apart there",
                      loop_ + 1, text(surface_.at(v)), marks_.loopOf(v) + 1),
          surface_.at(v));
    marks_.addVertex(v, loop_);
    stops.push_back(v);
  }
  if (stops.size() < (closed ? 3u : 1u))
    throw trimLineError(
        fmt::format("loop {} has {} points on the surface; it takes three", loop_ + 1, stops.size()),
        points.empty() ? Vec3(Vec3::Zero()) : points.front());
  result.vertices.push_back(stops.front());
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) connect(stops[i], stops[i + 1], 0, result.vertices);
  if (closed) {
    connect(stops.back(), stops.front(), 0, result.vertices);
    result.vertices.pop_back();
  }
  result.facts.points = stops.size();
  for (std::size_t i = closed ? 0 : 1; i < result.vertices.size(); ++i) {
    const VertexId before = i > 0 ? result.vertices[i - 1] : result.vertices.back();
    result.facts.length += (surface_.at(result.vertices[i]) - surface_.at(before)).norm();
  }
  ++loop_;
  return result;
}

// The interpolating four-point scheme of Dyn, Gregory and Levin (1987).
TrimLoop smoothed(std::span<const Vec3> points, bool closed, int rounds) {
  TrimLoop loop(points.begin(), points.end());
  for (int round = 0; round < rounds && loop.size() > 2; ++round) {
    const auto n = static_cast<std::ptrdiff_t>(loop.size());
    const auto at = [&](std::ptrdiff_t i) -> const Vec3& {
      return loop[static_cast<std::size_t>(closed ? (i + n) % n : std::clamp<std::ptrdiff_t>(i, 0, n - 1))];
    };
    TrimLoop finer;
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      finer.push_back(at(i));
      if (closed || i + 1 < n)
        finer.push_back(9. / 16 * (at(i) + at(i + 1)) - 1. / 16 * (at(i - 1) + at(i + 2)));
    }
    loop = std::move(finer);
  }
  return loop;
}

}  // namespace thicken::trimming
