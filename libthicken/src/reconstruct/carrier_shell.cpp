// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/carrier_shell.h"

#include <algorithm>
#include <utility>

#include "measure/measure.h"
#include "mesh/bounds.h"
#include "reconstruct/carrier.h"
#include "reconstruct/cells.h"
#include "reconstruct/shell_plan.h"

namespace thicken::reconstruct {

namespace {

// The largest triangle of the sweep that is opened for the sake of others, in squares of a cell.
constexpr double kLargestGiven = 1000;

}  // namespace

CarrierShell::CarrierShell(const sweep::SweepResult& swept, std::span<const std::uint8_t> openable,
                           std::vector<std::uint8_t> keep, double width, int threads)
    : swept_(swept),
      openable_(openable),
      keep_(std::move(keep)),
      width_(width),
      opened_(keep_.size(), 0),
      tree_(swept.mesh.positions, swept.mesh.triangles, threads, openable) {
  bool anyOpenable = false;
  for (std::size_t t = 0; t < keep_.size(); ++t) anyOpenable |= openable_[t] && keep_[t];
  if (anyOpenable) trimSpikes(swept.mesh, openable_, kLargestGiven * width * width, keep_);
  // Walls that were proved alone have none to separate.
  if (anyOpenable || swept.shellProved) separateFans();
  openAtFirst_ = openArea(swept, keep_);
}

bool CarrierShell::open(const Assembly& assembly, std::span<const TriangleId> meeting, double reach) {
  const std::vector<std::uint8_t> before = keep_;
  for (const TriangleId t : meeting)
    for (const TriangleId s : near(assembly.mesh, t, reach)) {
      if (opened_[s]) continue;
      opened_[s] = 1;
      if (measure::areaOf(swept_.mesh.positions, swept_.mesh.triangles[s]) > kLargestGiven * width_ * width_)
        continue;
      keep_[s] = 0;
    }
  if (keep_ == before) return false;
  separateFans();
  if (openArea(swept_, keep_) > std::max(openAtFirst_, kManyBesideSweep * width_ * width_)) keep_ = before;
  return keep_ != before;
}

bool CarrierShell::takeBack(const Assembly& assembly, std::span<const TriangleId> meeting, double first) {
  constexpr double kFarthest = 64;  // cells
  const bool onlyCarrier = std::all_of(meeting.begin(), meeting.end(),
                                       [&](TriangleId t) { return t < assembly.carrierTriangles; });
  bool any = false;
  for (double reach = first; reach < kFarthest * width_ && !any; reach *= 2)
    for (const TriangleId t : meeting) {
      if (t < assembly.carrierTriangles && !onlyCarrier) continue;
      for (const TriangleId s : near(assembly.mesh, t, reach)) {
        any |= keep_[s] == 0;
        keep_[s] = 1;
      }
    }
  if (any) closeFans(swept_.mesh, keep_);
  return any;
}

bool CarrierShell::takeAllBack() {
  if (std::find(keep_.begin(), keep_.end(), 0) == keep_.end()) return false;
  std::fill(keep_.begin(), keep_.end(), std::uint8_t{1});
  return true;
}

// The openable triangles within `reach` mm of the box around a triangle.
std::vector<TriangleId> CarrierShell::near(const TriangleMesh& mesh, TriangleId t, double reach) const {
  const mesh::Bounds b = mesh::boundsOf(mesh, mesh.triangles[t]);
  return tree_.near(b.low - Vec3::Constant(reach), b.high + Vec3::Constant(reach));
}

// Leaves no non-manifold vertex: by less shell where that is enough, else by more.
void CarrierShell::separateFans() {
  openFans(swept_.mesh, openable_, keep_);
  closeFans(swept_.mesh, keep_);
}

}  // namespace thicken::reconstruct
