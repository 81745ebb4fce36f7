// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/contourer.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mesh/bounds.h"
#include "parallel/parallel_for.h"
#include "platform/memory.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

using contour::Crossing;
using contour::EdgePart;
using contour::RimWay;
using contour::Seeds;
using field::GridIndex;
using field::Membership;

namespace {

constexpr double kMargin = 3;  // cells around the box grown by r
constexpr int kMostShifts = 8;

// Shifts the grid so that no node is likely to be at a coordinate of a file. Each try has another shift.
field::UniformGrid gridFor(const TriangleMesh& surface, double thickness, double width, int attempt) {
  const mesh::Bounds b = mesh::boundsOf(surface);
  const Vec3 shift{0.3819660112501051, 0.2360679774997896, 0.1458980337503154};
  Vec3 origin = b.low - Vec3::Constant(thickness + kMargin * width);
  GridIndex cells{};
  for (int k = 0; k < 3; ++k) {
    const double part = shift[k] * (attempt + 1);
    origin[k] -= width * (part - std::floor(part));
    cells[k] = static_cast<int>((b.high[k] + thickness + kMargin * width - origin[k]) / width) + 1;
  }
  return {origin, width, cells};
}

bool before(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  for (int k = 0; k < 3; ++k)
    for (int x = 0; x < 3; ++x)
      if (a[k][x] != b[k][x]) return a[k][x] < b[k][x];
  return false;
}

TriangleMesh meshOf(std::span<const std::array<Vec3, 3>> corners) {
  TriangleMesh mesh;
  for (const auto& c : corners) {
    const auto first = static_cast<VertexId>(mesh.positions.size());
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.positions.insert(mesh.positions.end(), c.begin(), c.end());
  }
  return mesh;
}

std::vector<GridIndex> rimCells(const std::vector<RimWay>& ways) {
  std::vector<GridIndex> cells;
  for (const RimWay& way : ways)
    for (const contour::RimVisit& visit : way) cells.push_back(visit.cell);
  return cells;
}

}  // namespace

Contourer::Contourer(const job::Job& job, double width, const WorkingSet& working, const Cut* cut)
    : job_(job), width_(width), working_(working), cut_(cut) {}

Contour Contourer::contour(const Carrier& carrier, const Membership& membership, const Seeds& seeds) {
  for (;;) {
    try {
      if (!field_) startGrid();
      return attempt(carrier, membership, seeds);
    } catch (const field::GridTouches&) {
      if (shifts_ == kMostShifts)
        throw Error(ErrorCode::kNoSolid,
                    "no grid was found that the surface does not touch; change the cell width");
      field_.reset();
    }
  }
}

void Contourer::startGrid() {
  grid_ = gridFor(job_.surface, job_.thickness.most(), width_, ++shifts_);
  onSurface_.emplace(grid_, job_.surface.positions, job_.surface.triangles, job_.threads);
  field_.emplace(grid_, working_.nodes);
  beyondSurface_.clear();
  covered_.assign(job_.surface.triangles.size(), 0);
  changed_.reset();
  last_.clear();
}

Contour Contourer::attempt(const Carrier& carrier, const Membership& membership, const Seeds& seeds) {
  const std::span<const Triangle> beyond =
      std::span(carrier.mesh.triangles).subspan(job_.surface.triangles.size());
  const field::SurfaceCrossings onRest(grid_, carrier.mesh.positions, beyond, job_.threads);
  const field::CarrierCrossings crossed(*onSurface_, onRest);
  Contour made;
  made.ways = contour::rimWays(grid_, carrier.mesh.positions, carrier.rim);
  std::vector<Corners> corners(beyond.size());
  for (std::size_t t = 0; t < beyond.size(); ++t)
    for (int k = 0; k < 3; ++k) corners[t][k] = carrier.mesh.positions[beyond[t][k]];
  forgetChanges(std::move(corners), carrier.covered);
  const auto placing = [&](const EdgePart& part) {
    const Crossing* old = recalled(part);
    const Crossing crossing = old != nullptr ? *old : contour::placed(part, grid_, *field_, membership);
    if (cut_ != nullptr && !cut_->zone.contains(crossing.at)) throw LeavesWindow();
    return crossing;
  };
  made.crossings = contour::followContour(grid_, rimCells(made.ways), seeds, crossed, membership, *field_,
                                          placing, job_.context, job_.threads);
  if (working_.isLean) platform::returnFreedMemory();
  job_.watch.lap("field");
  job_.context.enter(Stage::kContouring);
  made.dual = contour::dualSurface(made.crossings, made.ways, carrier.mesh.positions, job_.threads);
  return made;
}

void Contourer::remember(std::vector<Crossing> crossings) {
  last_ = std::move(crossings);
  // Shaping left normals on the wall's crossings. Another contour must not begin with them.
  for (Crossing& c : last_)
    if (c.beyond == field::Standing::kRim) c.normal = Vec3::Zero();
}

// Before the first carrier there is nothing to forget.
void Contourer::forgetChanges(std::vector<Corners> beyondSurface, std::span<const std::uint8_t> covered) {
  std::sort(beyondSurface.begin(), beyondSurface.end(), before);
  std::vector<Corners> changes;
  std::set_symmetric_difference(beyondSurface.begin(), beyondSurface.end(), beyondSurface_.begin(),
                                beyondSurface_.end(), std::back_inserter(changes), before);
  beyondSurface_ = std::move(beyondSurface);
  std::vector<std::uint8_t> marked(job_.surface.triangles.size(), 0);
  for (std::size_t t = 0; t < marked.size(); ++t) marked[t] = covered_[t] != covered[t];
  covered_.assign(covered.begin(), covered.end());
  changed_.reset();
  if (changes.empty() || field_->size() == 0) return;
  changed_.emplace(meshOf(changes));
  field_->forget(*changed_, marked, job_.context, job_.threads);
}

// The crossing that a part had the last time, unless a change is near enough to have moved it.
const Crossing* Contourer::recalled(const EdgePart& part) const {
  constexpr double kSure = 1.01;
  const int axis = static_cast<int>(part.edge & 3);
  auto old = std::lower_bound(last_.begin(), last_.end(), part.edge,
                              [](const Crossing& c, std::uint64_t edge) { return c.edge < edge; });
  while (old != last_.end() && old->edge == part.edge && old->at[axis] < part.from) ++old;
  if (old == last_.end() || old->edge != part.edge || old->at[axis] > part.to || old->jump != part.jump ||
      (changed_ && changed_->closest(old->at, kSure * job_.thickness.most())))
    return nullptr;
  return &*old;
}

}  // namespace thicken::reconstruct
