// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/attempt.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "platform/memory.h"
#include "reconstruct/cells.h"
#include "reconstruct/covered.h"
#include "reconstruct/diagonals.h"
#include "reconstruct/loose_parts.h"
#include "reconstruct/shape.h"
#include "reconstruct/strip_region.h"

namespace thicken::reconstruct {

using contour::Seeds;
using mesh::sortUnique;
using platform::returnFreedMemory;

namespace {

constexpr int kDefaultRounds = 15;  // of shape optimisation; the paper takes 10 to 20
// Cells that the end of a wall is drawn back by: for another contour, and while this one settles, where what
// it loses stays lost.
constexpr double kLift = 0.75, kSettlingLift = 0.25;

}  // namespace

Attempt::Attempt(const job::Job& job, const sweep::SweepResult& swept, double width,
                 const WorkingSet& working, const Cut* cut)
    : walls_(job, swept),
      contourer_(job, width, working, cut),
      job_(job),
      swept_(swept),
      width_(width),
      working_(working),
      cut_(cut) {}

std::vector<TriangleId> Attempt::run(std::span<const std::uint8_t> keep) {
  job_.context.enter(Stage::kField);
  walls_.fit(keep);
  Carrier carrier = makeCarrier(swept_, walls_.positions(), walls_.up(), job_.surface.triangles.size(), keep,
                                width_, cut_, job_.threads);
  carrier.covered = coveredTriangles(job_.surface, swept_, keep);
  const field::Membership membership(carrier.mesh, job_.tree, job_.surface.triangles.size(), job_.thickness,
                                     carrier.region, carrier.covered, job_.threads);
  job_.watch.lap("sweep");
  Contour contour = contourer_.contour(carrier, membership, openShell(keep));
  // How many crossings there are was an estimate until now.
  working_ = requireRoomForField(job_, contour.crossings.size(), width_);
  if (working_.isLean) returnFreedMemory();
  job_.context.enter(Stage::kJoining);
  assembly_ = assemble(carrier, contour.dual, contour.crossings, contour.ways, job_.threads);
  dropSpecks(assembly_, width_, job_.threads);
  if (working_.isLean) returnFreedMemory();
  job_.watch.lap("faces");
  job_.context.enter(Stage::kShaping);
  const int rounds = job_.options.smooth.value_or(kDefaultRounds);
  const std::vector<Vec3> target = shapedPositions(assembly_, contour.dual, contour.crossings, membership,
                                                   width_, rounds, job_.context, job_.threads);
  chooseDiagonals(assembly_, contour.dual, contour.crossings, target, job_.context, job_.threads);
  contour.dual = {};
  if (working_.isLean) {
    contour.crossings = std::vector<contour::Crossing>();
    returnFreedMemory();
  }
  const std::vector<TriangleId> unsettled = settle(assembly_, target, carrier.up, kSettlingLift * width_,
                                                   proved_, working_.triangles, job_.context, job_.threads);
  carrier_.up = std::move(carrier.up);
  std::vector<TriangleId> meeting = unsettled.empty() ? nonManifoldTriangles() : unsettled;
  if (meeting.empty()) {
    // A window does not show enough of the boundary to tell whether a part is misplaced.
    if (cut_ == nullptr) dropMisplaced(assembly_, job_.threads);
    labelStrip(assembly_, job_.threads);
    job_.watch.lap("shape");
    return meeting;
  }
  carrier_.mesh.positions = std::move(carrier.mesh.positions);
  if (!working_.isLean) {  // for the next attempt
    proved_.replace(assembly_.mesh, unsettled, job_.threads);
    contourer_.remember(std::move(contour.crossings));
  }
  job_.watch.lap("shape");
  return meeting;
}

bool Attempt::liftWalls(std::span<const TriangleId> meeting) {
  std::vector<VertexId> ids;
  for (const TriangleId t : meeting)
    for (const VertexId v : assembly_.mesh.triangles[t])
      if (v >= job_.surface.positions.size() && v < swept_.mesh.positions.size()) ids.push_back(v);
  sortUnique(ids);
  return walls_.lift(ids, kLift * width_);
}

// Where the rim circles around an edge of the grid, strips on either side of a vertex may use the same edge.
std::vector<TriangleId> Attempt::nonManifoldTriangles() const {
  std::vector<TriangleId> found;
  edgesAtStrip(assembly_, job_.threads).forEachEdge([&](VertexId, VertexId, auto forth, auto back) {
    if (forth.size() + back.size() <= 2) return;
    for (const auto& uses : {forth, back})
      for (const mesh::HalfEdge& use : uses)
        if (use.triangle() >= assembly_.carrierTriangles) found.push_back(use.triangle());
  });
  sortUnique(found);
  return found;
}

// Moves a point away from its closest point of S until nothing of S is nearer than the thickness. In a corner
// one side after the other pushes it. It does not leave a window.
Vec3 Attempt::pushedToShell(const Vec3& from) const {
  constexpr int kMostSteps = 16;
  constexpr double kClose = 0.01;
  Vec3 p = from;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto c = job_.tree.closest(p);
    const double r = job_.thickness.at(*c);
    if (!(c->distance > 0) || c->distance > (1 - kClose) * r) break;
    p = c->point + (r / c->distance) * (p - c->point);
  }
  return cut_ != nullptr && !cut_->zone.contains(p) ? from : p;
}

// Seeds on the sweep's shell where the carrier does not have it. A vertex is pushed to the same place in each
// attempt.
Seeds Attempt::openShell(std::span<const std::uint8_t> keep) {
  constexpr double kNotYet = std::numeric_limits<double>::infinity();
  const std::vector<Vec3>& swept = swept_.mesh.positions;
  Seeds seeds;
  std::vector<VertexId> vertices;
  std::vector<std::uint8_t> seen(swept.size(), 0);
  for (std::size_t t = 0; t < keep.size(); ++t)
    if (!keep[t])
      for (const VertexId v : swept_.mesh.triangles[t])
        if (!std::exchange(seen[v], std::uint8_t{1})) {
          seeds.points.push_back(swept[v]);
          vertices.push_back(v);
        }
  if (!working_.isLean) pushed_.resize(swept.size(), Vec3::Constant(kNotYet));
  seeds.toContour = [this, vertices = std::move(vertices)](std::size_t i) {
    const VertexId v = vertices[i];
    if (pushed_.empty()) return pushedToShell(swept_.mesh.positions[v]);
    if (pushed_[v].x() == kNotYet) pushed_[v] = pushedToShell(swept_.mesh.positions[v]);
    return pushed_[v];
  };
  return seeds;
}

}  // namespace thicken::reconstruct
