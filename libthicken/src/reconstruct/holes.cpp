// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/holes.h"

#include <algorithm>
#include <utility>

#include "exact/pair_search.h"
#include "exact/predicates.h"
#include "mesh/sort_unique.h"
#include "mesh/topology.h"
#include "reconstruct/cut_around.h"
#include "reconstruct/strip_region.h"

namespace thicken::reconstruct {

using mesh::kNone;
using mesh::sortUnique;
using sweep::SweepResult;

namespace {

bool anyFlat(const TriangleMesh& mesh, std::span<const TriangleId> triangles) {
  return std::any_of(triangles.begin(), triangles.end(), [&](TriangleId t) {
    const auto& [a, b, c] = mesh.triangles[t];
    return exact::collinear(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
  });
}

// Cuts holes until the rest of a boundary is clear of itself. Walls that were drawn back with the contour go
// back to where the carrier had them, clear of each other.
class Cutter {
 public:
  Cutter(Holes& holes, std::span<const Vec3> start, const RunContext& context, int threads)
      : holes_(holes), mesh_(holes.carried.mesh), start_(start), context_(context), threads_(threads) {}

  bool cut(std::span<const TriangleId> meeting) {
    // Ends of walls go back where triangles meet, and in the end all of them: what is put back may meet what
    // stands beside it, all along the wall.
    constexpr int kMostTimes = 8, kLocally = 3, kRings = 3;
    std::vector<TriangleId> bad(meeting.begin(), meeting.end());
    for (int i = 0; i < kMostTimes; ++i) {
      cutAround(mesh_, bad, holes_.openable, kRings, holes_.keep);
      std::erase_if(bad, [this](TriangleId t) { return holes_.openable[t] != 0; });
      if (bad.empty()) return true;
      std::vector<std::uint8_t> moved = verticesOf(bad);
      for (VertexId v = 0; v < start_.size(); ++v) {
        if (mesh_.positions[v] == start_[v] || (i < kLocally && !moved[v])) continue;
        mesh_.positions[v] = start_[v];
        moved[v] = 1;
      }
      const std::vector<TriangleId> left = meetingOnceMoved(moved);
      if (left.empty()) return !anyFlat(mesh_, bad);
      bad = left;
    }
    return false;
  }

 private:
  [[nodiscard]] std::vector<std::uint8_t> verticesOf(std::span<const TriangleId> triangles) const {
    std::vector<std::uint8_t> are(mesh_.positions.size(), 0);
    for (const TriangleId t : triangles)
      for (const VertexId v : mesh_.triangles[t]) are[v] = 1;
    return are;
  }

  // What is kept that meets other triangles of it, one of which has such a vertex.
  [[nodiscard]] std::vector<TriangleId> meetingOnceMoved(std::span<const std::uint8_t> moved) const {
    TriangleMesh kept;
    kept.positions = mesh_.positions;
    std::vector<TriangleId> id;
    std::vector<std::uint8_t> clear;
    for (TriangleId t = 0; t < holes_.keep.size(); ++t) {
      if (!holes_.keep[t]) continue;
      const Triangle& corners = mesh_.triangles[t];
      id.push_back(t);
      kept.triangles.push_back(corners);
      clear.push_back(
          std::none_of(corners.begin(), corners.end(), [&](VertexId v) { return moved[v] != 0; }));
    }
    const exact::PairSearch search(kept, exact::PairSearch::kAll, threads_);
    std::vector<TriangleId> meeting;
    for (const auto& [a, b] : search.all(clear, context_, threads_)) {
      meeting.push_back(id[a]);
      meeting.push_back(id[b]);
    }
    sortUnique(meeting);
    return meeting;
  }

  Holes& holes_;
  TriangleMesh& mesh_;
  std::span<const Vec3> start_;
  const RunContext& context_;
  int threads_;
};

}  // namespace

std::vector<std::uint8_t> openableOf(const Assembly& assembly, const ContourTask& task) {
  std::vector<std::uint8_t> is(assembly.region.size(), 1);
  for (TriangleId t = 0; t < assembly.carrierTriangles; ++t) is[t] = task.openable[assembly.source[t]];
  return is;
}

std::optional<Holes> holesOf(const job::Job& job, const SweepResult& swept, const Attempt& attempt,
                             const ContourTask& task, std::span<const TriangleId> meeting) {
  Assembly made = attempt.assembly();
  labelStrip(made, job.threads);
  Holes holes;
  const std::size_t count = made.region.size();
  holes.keep.assign(count, 1);
  holes.openable = openableOf(made, task);
  holes.left.assign(count, 0);
  SweepResult& carried = holes.carried;
  carried.base.assign(made.mesh.positions.size(), kNone);
  for (VertexId v = 0; v < job.surface.positions.size(); ++v) carried.base[v] = v;
  for (TriangleId t = 0; t < made.carrierTriangles; ++t) {
    if (made.region[t] != Region::kShell) continue;
    holes.left[t] = task.left[made.source[t]];
    // What is deeper than a piece of the sweep's shell is not the material of the triangles that it copies.
    for (const VertexId v : made.mesh.triangles[t])
      carried.base[v] = v < swept.base.size() ? swept.base[v] : kNone;
  }
  carried.distance = swept.distance;
  carried.distance.resize(made.mesh.positions.size(), 0);
  carried.up = attempt.carrier().up;
  carried.up.resize(made.mesh.positions.size(), Vec3::Zero());
  carried.mesh = std::move(made.mesh);
  carried.region = std::move(made.region);
  // Where triangles meet, edges are not looked at before.
  std::vector<TriangleId> bad = attempt.nonManifoldTriangles();
  bad.insert(bad.end(), meeting.begin(), meeting.end());
  sortUnique(bad);
  if (!Cutter(holes, attempt.carrier().mesh.positions, job.context, job.threads).cut(bad))
    return std::nullopt;
  return holes;
}

}  // namespace thicken::reconstruct
