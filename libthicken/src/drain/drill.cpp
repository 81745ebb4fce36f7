// SPDX-License-Identifier: LGPL-2.1-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_set>

#include "check/audit.h"
#include "drain/sheet_cut.h"
#include "drain/strip.h"
#include "mesh/place_text.h"
#include "thicken/check.h"
#include "thicken/drain.h"
#include "thicken/error.h"

namespace thicken {

using checking::audit;
using checking::AuditResult;

namespace {

using drain::CannotCut;
using drain::Frame;
using drain::SheetCut;
using drain::SheetCutter;

constexpr int kMostSides = 360;

// The cross-section may be turned by a part of a side and shifted by a part of the diameter until it is
// clear of edges and vertices: try after try, each by another step of a spiral.
constexpr int kTries = 8;
constexpr double kLargestShift = 0.02;

// Where a line along the axis runs through the boundary.
struct Piercing {
  double along;
  TriangleId triangle;
  bool upward;  // out of the material
};

bool strictlyWithin(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto side = [](const Vec3& p, const Vec3& q) { return p[0] * q[1] - p[1] * q[0]; };
  const double s = side(a, b), t = side(b, c), u = side(c, a);
  return (s > 0 && t > 0 && u > 0) || (s < 0 && t < 0 && u < 0);
}

std::vector<Piercing> piercings(const TriangleMesh& mesh, const Frame& frame) {
  std::vector<Piercing> found;
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 p = frame.local(mesh.positions[a]), q = frame.local(mesh.positions[b]),
               r = frame.local(mesh.positions[c]);
    if (!strictlyWithin(p, q, r)) continue;
    const Vec3 normal = (q - p).cross(r - p);
    found.push_back({p.dot(normal) / normal[2], t, normal[2] > 0});
  }
  std::sort(found.begin(), found.end(), [](const Piercing& x, const Piercing& y) {
    return x.along != y.along ? x.along < y.along : x.triangle < y.triangle;
  });
  return found;
}

// The piece of material on the axis that begins nearest to the place.
std::pair<Piercing, Piercing> wallAt(const TriangleMesh& mesh, const Frame& frame) {
  const std::vector<Piercing> found = piercings(mesh, frame);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i + 1 < found.size(); ++i)
    if (!found[i].upward && found[i + 1].upward &&
        (!best || std::abs(found[i].along) < std::abs(found[*best].along)))
      best = i;
  if (!best) throw CannotCut("no material lies on the axis of the hole");
  return {found[*best], found[*best + 1]};
}

std::vector<Vec3> crossSection(const DrainHole& hole, double turn) {
  const double step = 2 * std::numbers::pi / hole.sides;
  const double radius = hole.diameter / 2 / std::cos(step / 2);
  std::vector<Vec3> corners;
  for (int k = 0; k < hole.sides; ++k)
    corners.emplace_back(radius * std::cos((k + turn) * step), radius * std::sin((k + turn) * step), 0);
  return corners;
}

// The wall of the hole along one side of the cross-section: the flat polygon between the two sheets.
void appendWall(const std::vector<Vec3>& positions, const Frame& frame, const Vec3& along,
                const std::vector<VertexId>& low, const std::vector<VertexId>& high,
                std::vector<Triangle>& triangles) {
  std::vector<VertexId> loop = high;
  loop.insert(loop.end(), low.rbegin(), low.rend());
  std::vector<Vec3> flat;
  for (const VertexId v : loop) {
    const Vec3 q = frame.local(positions[v]);
    flat.emplace_back(-q.dot(along), q[2], 0);  // seen from the axis of the hole
  }
  const std::vector<Triangle> made = drain::triangulate(loop, flat);
  if (made.empty()) throw CannotCut("the two sides of the wall are too close there");
  triangles.insert(triangles.end(), made.begin(), made.end());
}

DrilledSolid tryToDrill(const TriangleMesh& mesh, const std::vector<std::array<TriangleId, 3>>& across,
                        const Frame& frame, const DrainHole& hole, double turn) {
  const auto [entry, exit] = wallAt(mesh, frame);
  const std::vector<Vec3> corners = crossSection(hole, turn);
  std::vector<Vec3> positions = mesh.positions;
  SheetCut low = SheetCutter(positions, mesh.triangles, across, frame, corners, false).cut(entry.triangle);
  SheetCut high = SheetCutter(positions, mesh.triangles, across, frame, corners, true).cut(exit.triangle);

  std::unordered_set<TriangleId> gone(low.replaced.begin(), low.replaced.end());
  for (const TriangleId t : high.replaced)
    if (!gone.insert(t).second) throw CannotCut("the two sides of the wall meet within the hole");
  DrilledSolid result;
  for (TriangleId t = 0; t < mesh.triangles.size(); ++t)
    if (gone.count(t) == 0) result.mesh.triangles.push_back(mesh.triangles[t]);
  result.untouched = result.mesh.triangles.size();
  for (const SheetCut* cut : {&low, &high})
    result.mesh.triangles.insert(result.mesh.triangles.end(), cut->around.begin(), cut->around.end());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3 along = (corners[(k + 1) % corners.size()] - corners[k]).normalized();
    appendWall(positions, frame, along, low.sides[k], high.sides[k], result.mesh.triangles);
  }
  result.mesh.positions = std::move(positions);
  result.axis = frame.w;
  result.entry = frame.global({0, 0, entry.along});
  result.exit = frame.global({0, 0, exit.along});
  for (const Vec3& c : corners) result.outline.push_back(frame.global({c[0], c[1], entry.along}));
  result.walledFrom = low.highest - entry.along;
  result.walledTo = high.lowest - entry.along;
  return result;
}

// What the hole leaves untouched has to be there still, and all of it to be a solid.
void require(const DrilledSolid& drilled, const RunContext& context, int threads) {
  TriangleMesh kept;
  kept.positions = drilled.mesh.positions;
  kept.triangles.assign(drilled.mesh.triangles.begin(),
                        drilled.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(drilled.untouched));
  const AuditResult audited = audit(drilled.mesh, kept, Side::kNegative, context, threads);
  if (!audited.facts.passed()) throw CannotCut("the hole would cut into other parts of the solid");
}

void requireArguments(const DrainHole& hole) {
  const bool good = hole.place.allFinite() && hole.axis.allFinite() && hole.axis.norm() > 0 &&
                    std::isfinite(hole.diameter) && hole.diameter > 0 && hole.sides >= 3 &&
                    hole.sides <= kMostSides;
  if (!good)
    throw Error(
        ErrorCode::kInvalidArgument,
        fmt::format("A hole needs a finite place, an axis of a length above 0, a diameter above 0 mm and 3 "
                    "to {} sides.",
                    kMostSides));
}

// The hole, or why there is none.
std::optional<DrilledSolid> drillOne(const TriangleMesh& mesh,
                                     const std::vector<std::array<TriangleId, 3>>& across,
                                     const DrainHole& hole, const RunContext& context, int threads,
                                     std::string& reason) {
  const Frame middle(hole.place, hole.axis);
  for (int attempt = 0; attempt < kTries; ++attempt) {
    context.throwIfCancelled();
    // Never exactly on the place: it may be a vertex, which the axis must not meet.
    const double golden = std::numbers::pi * (3 - std::sqrt(5.)) * attempt + 1;
    const double shift = kLargestShift * hole.diameter * (attempt + 0.5) / kTries;
    Frame frame = middle;
    frame.origin = middle.global({shift * std::cos(golden), shift * std::sin(golden), 0});
    try {
      DrilledSolid result = tryToDrill(mesh, across, frame, hole, 0.37 * attempt + 0.11);
      require(result, context, threads);
      result.mesh = weld(result.mesh);
      return result;
    } catch (const drain::TooSteep& failure) {
      reason = failure.what();
      if (attempt > 0) return std::nullopt;
    } catch (const CannotCut& failure) {
      reason = failure.what();
    }
  }
  return std::nullopt;
}

}  // namespace

DrilledSolid drill(const TriangleMesh& solid, std::span<const DrainHole> candidates, RunContext context,
                   int threads) {
  if (candidates.empty())
    throw Error(ErrorCode::kInvalidArgument, "There is no hole to drill: give a place.");
  for (const DrainHole& hole : candidates) requireArguments(hole);
  const TriangleMesh mesh = weld(solid);
  const AuditResult before = audit(mesh, {}, Side::kNegative, context, threads);
  if (!before.defects.empty())
    throw Error(ErrorCode::kNoSolid,
                "There is no valid solid to drill: " + before.defects.front().sentence + ".", before.defects);
  const auto across = mesh::neighbours(mesh.positions.size(), mesh.triangles);
  std::string reason, firstReason;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (auto drilled = drillOne(mesh, across, candidates[i], context, threads, reason)) {
      drilled->candidate = i;
      return *std::move(drilled);
    }
    if (i == 0) firstReason = reason;
  }
  const DrainHole& first = candidates.front();
  throw Error(
      ErrorCode::kNoSolid,
      fmt::format("A hole of {:.4g} mm cannot be drilled at {}{}: {}; choose another place, another "
                  "direction or a smaller diameter.",
                  first.diameter, mesh::text(first.place),
                  candidates.size() > 1 ? fmt::format(" nor at {} other place{}", candidates.size() - 1,
                                                      candidates.size() == 2 ? "" : "s")
                                        : "",
                  firstReason));
}

}  // namespace thicken
