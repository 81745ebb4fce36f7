// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <utility>

#include "bvh/distance_tree.h"
#include "bvh/spatial_order.h"
#include "measure/measure.h"
#include "mesh/normals.h"
#include "mesh/sort_unique.h"
#include "mesh/topology.h"
#include "parallel/parallel_for.h"
#include "sweep/corners.h"
#include "sweep/direction.h"
#include "sweep/initial_depth.h"
#include "sweep/nearby.h"
#include "sweep/polish.h"
#include "sweep/retreat.h"
#include "sweep/shell_surgery.h"
#include "sweep/split.h"
#include "sweep/sweep_result.h"
#include "sweep/swept_mesh.h"
#include "thicken/error.h"

namespace thicken::sweep {

using job::Job;
using mesh::sortUnique;
using mesh::VertexTriangles;
using parallel::parallelFor;

namespace {

// A copy in the way of its neighbours is dropped; holes that grow this often do not end.
constexpr int kMostRefills = 12;
// After so many rounds with the same copies in the way there is no solid at their place.
constexpr int kMostRepeats = 3;
constexpr int kMostGrowths = 4;
// Copies that are farther off the planes around them, in r, get a corner of their own: half of what the shell
// may be off by.
constexpr double kCornerOff = 0.005;
constexpr int kMostCornerRetries = 4;

[[noreturn]] void throwNoSolidAt(const SweptMesh& mesh, const std::vector<VertexId>& vertices) {
  const VertexId v = vertices.front();
  const Vec3& p = mesh.positions[v];
  Defect d;
  d.code = ErrorCode::kNoSolid;
  d.vertices = vertices;
  sortUnique(d.vertices);
  d.count = d.vertices.size();
  d.vertices.resize(std::min(d.vertices.size(), Defect::kMaxListed));
  d.place = p;
  d.sentence = fmt::format(
      "no solid could be made below {} vertices, the first of them vertex {} at ({:.6g}, {:.6g}, {:.6g}): "
      "the surface is "
      "folded too sharply there for the precision of its coordinates; smooth or remesh it around that place",
      d.count, v, p.x(), p.y(), p.z());
  const std::string sentence = d.sentence;
  throw Error(ErrorCode::kNoSolid, sentence, {std::move(d)});
}

std::vector<VertexId> basesOf(const SweptMesh& mesh, const std::vector<std::uint32_t>& copies) {
  std::vector<VertexId> vertices;
  for (const std::uint32_t i : copies) vertices.push_back(mesh.copies[i].base);
  return vertices;
}

// The copies in groups of neighbours, so that each hole is treated by itself.
std::vector<std::vector<std::uint32_t>> groupsOf(const ShellSurgery& shell,
                                                 const std::vector<std::uint32_t>& copies) {
  std::vector<std::vector<std::uint32_t>> groups;
  std::set<std::uint32_t> open(copies.begin(), copies.end());
  while (!open.empty()) {
    std::vector<std::uint32_t> group{*open.begin()};
    open.erase(open.begin());
    for (std::size_t k = 0; k < group.size(); ++k)
      for (const std::uint32_t i : shell.neighboursOf(group[k]))
        if (open.erase(i) > 0) group.push_back(i);
    sortUnique(group);
    groups.push_back(std::move(group));
  }
  return groups;
}

// Drops one group of copies. Where its hole cannot be filled, one more copy around it may do; else all
// around it are dropped as well, and so on. Returns whether it was possible.
bool dropGroup(ShellSurgery& shell, std::vector<std::uint32_t> copies) {
  for (int growths = 0;; ++growths) {
    const auto around = shell.drop(copies);
    if (around.empty()) return true;
    const std::size_t before = copies.size();
    for (const std::uint32_t i : around) {
      auto more = copies;
      more.push_back(i);
      if (shell.drop(more).empty()) return true;
    }
    copies.insert(copies.end(), around.begin(), around.end());
    sortUnique(copies);
    if (growths == kMostGrowths || copies.size() == before) return false;
  }
}

// Drops copies. Returns those, of all groups, that could not be: an error names every place at once.
std::vector<std::uint32_t> drop(SweptMesh& mesh, const VertexTriangles& around,
                                const std::vector<std::uint32_t>& copies) {
  std::vector<std::uint32_t> stuck;
  if (copies.empty()) return stuck;
  ShellSurgery shell(mesh, around);
  for (auto& group : groupsOf(shell, copies)) {
    std::erase_if(group, [&](std::uint32_t i) { return mesh.copies[i].dropped; });  // by another's growth
    if (!group.empty() && !dropGroup(shell, group)) stuck.insert(stuck.end(), group.begin(), group.end());
  }
  return stuck;
}

// Merges copies without a direction with a neighbour, nearest first: slivers that are folded over
// vanish from the shell that way, and with them what the directions could not agree on.
void mergeFolds(SweptMesh& mesh, const VertexTriangles& around, const std::vector<std::uint32_t>& ids) {
  if (ids.empty()) return;
  ShellSurgery shell(mesh, around);
  for (const std::uint32_t i : ids) {
    if (mesh.copies[i].safety >= kLeastSafety || mesh.copies[i].dropped) continue;  // mended meanwhile
    for (const std::uint32_t j : shell.neighboursOf(i))
      if (shell.merge(std::array{i, j})) break;
  }
}

std::vector<std::uint32_t> copiesWithoutDirection(const SweptMesh& mesh) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
    if (mesh.copies[i].safety < kLeastSafety && !mesh.copies[i].dropped) ids.push_back(i);
  return ids;
}

struct Settled {
  std::size_t rounds = 0;
  std::vector<TriangleId> order;   // of the leaves of the tree that the last tests were made with
  std::vector<VertexId> hopeless;  // of S, that no depth is clear below; none: it is settled
  bool isShort = false;            // of more of the thickness than may be; nothing has been settled then
};

// Depths of the copies once their slope is limited.
std::vector<double> limited(SweptMesh& mesh, const CopyGraph& graph, int threads) {
  limitSlope(mesh, graph, {}, threads);
  std::vector<double> depth;
  for (const Copy& c : mesh.copies) depth.push_back(c.depth);
  return depth;
}

// An estimate of the share of S's area that will have a shell short of the thickness. That is where the free
// depth is less than all, and around copies that are in the way of others: the slope limit holds back their
// neighbours.
double shareShort(SweptMesh& mesh, const CopyGraph& graph, const ConflictTester& tester,
                  const Conflicts& conflicts, int threads) {
  constexpr double kDrawnBack = 0.5, kFull = 0.99;
  std::vector<double> depth;
  for (const Copy& c : mesh.copies) depth.push_back(c.depth);
  conflicts.forTriangles([&](TriangleId t) {
    tester.forCopies(t, [&](std::uint32_t i) { mesh.copies[i].depth = std::min(depth[i], kDrawnBack); });
  });
  limitSlope(mesh, graph, {}, threads);
  double all = 0, isShort = 0;
  for (TriangleId t = 0; t < mesh.surfaceTriangles; ++t) {
    const Triangle& corners = mesh.triangles[t];
    const double area = measure::areaOf(mesh.positions, corners);
    all += area;
    if (std::any_of(corners.begin(), corners.end(), [&](VertexId v) { return mesh.copies[v].depth < kFull; }))
      isShort += area;
  }
  for (std::size_t i = 0; i < depth.size(); ++i) mesh.copies[i].depth = depth[i];
  return all > 0 ? isShort / all : 0;
}

// Draws back, drops what stays in the way, and lets the rest advance again to `free`, the depth that is free
// below each copy, from its own. Only copies of vertices that `single` marks are dropped: others may be in
// the way because of their corner.
Settled settle(SweptMesh& mesh, const Job& job, const VertexTriangles& around,
               std::span<const std::uint8_t> single, std::span<const double> free, double mostShort) {
  const RunContext& context = job.context;
  const int threads = job.threads;
  Settled settled;
  std::vector<double> goal;
  std::vector<std::uint32_t> before;
  int repeats = 0;
  for (int refills = 0;; ++refills) {
    const CopyGraph graph = copyGraph(mesh, threads);
    if (refills == 0) {
      std::vector<double> now;
      for (std::size_t i = 0; i < free.size(); ++i)
        now.push_back(std::exchange(mesh.copies[i].depth, free[i]));
      goal = limited(mesh, graph, threads);
      for (std::size_t i = 0; i < free.size(); ++i) mesh.copies[i].depth = std::min(now[i], goal[i]);
    }
    limitSlope(mesh, graph, {}, threads);
    parallelFor(mesh.copies.size(), threads, context, 4096, [&](std::size_t i) { mesh.place(i); });
    ConflictTester tester(mesh, context, threads);
    Conflicts conflicts = tester.all();
    if (mostShort < 1 && shareShort(mesh, graph, tester, conflicts, threads) > mostShort) {
      settled.isShort = true;
      return settled;
    }
    mostShort = 1;
    const RetreatResult result = retreat(mesh, graph, tester, std::move(conflicts), context);
    settled.rounds += result.rounds;
    settled.hopeless = result.buried;
    if (!result.buried.empty()) return settled;
    if (result.stuck.empty()) {
      advance(mesh, graph, tester, goal, context);
      settled.order = tester.order();
      return settled;
    }
    settled.hopeless = basesOf(mesh, result.stuck);
    std::erase_if(settled.hopeless, [&](VertexId v) { return single[v] != 0; });
    if (!settled.hopeless.empty()) return settled;
    repeats = result.stuck == before ? repeats + 1 : 1;
    const bool isLast = refills == kMostRefills || repeats == kMostRepeats;
    settled.hopeless = basesOf(mesh, isLast ? result.stuck : drop(mesh, around, result.stuck));
    if (!settled.hopeless.empty()) return settled;
    before = result.stuck;
  }
}

// After corners changed: the depth that is free below copies that are new or stand beside new ones, which
// begin there again. All others stay as deep as they are.
void beginAgain(SweptMesh& mesh, const Job& job, Corners& corners, std::vector<double>& free) {
  std::vector<std::uint8_t> changed(mesh.copies.size(), 0);
  for (const std::uint32_t i : corners.takeChanged()) changed[i] = 1;
  setInitialDepths(mesh, job, changed);
  free.resize(mesh.copies.size(), 0);
  for (std::size_t i = 0; i < changed.size(); ++i)
    if (changed[i]) free[i] = mesh.copies[i].depth;
}

// Cuts the triangles around copies that were drawn back into small ones. Then all other copies may be as deep
// as `free` says. If that is not clear, the sweep stays as it is.
void cutShort(SweptMesh& mesh, const Job& job, Corners& corners, std::vector<double>& free,
              const VertexTriangles& around, Settled& settled) {
  SweptMesh before = mesh;
  corners.cutShort(free);
  if (mesh.copies.size() == before.copies.size()) return;
  beginAgain(mesh, job, corners, free);
  const std::vector<std::uint8_t> single(mesh.surfaceVertices, 0);
  Settled again = settle(mesh, job, around, single, free, 1);
  again.rounds += settled.rounds;
  if (again.hopeless.empty())
    settled = std::move(again);
  else
    mesh = std::move(before);
}

// Marks vertices and those around them. Returns those that were not marked.
std::vector<VertexId> markAround(const TriangleMesh& surface, const VertexTriangles& around,
                                 std::span<const VertexId> vertices, std::vector<std::uint8_t>& marked) {
  std::vector<VertexId> fresh;
  for (const VertexId v : vertices)
    for (const TriangleId t : around.of(v))
      for (const VertexId u : surface.triangles[t])
        if (std::exchange(marked[u], std::uint8_t{1}) == 0) fresh.push_back(u);
  return fresh;
}

// S as the sweep looks at it.
struct Fans {
  std::vector<Vec3> normal;                     // per triangle
  std::vector<std::vector<OffsetPlane>> plane;  // per triangle, for each shell
  VertexTriangles around;
  mesh::Rim rim;
};

// Makes corners, and settles the copies; those that must draw back until their copies are one are no corners,
// and are undone. Returns whether it is settled.
bool settleWithCorners(SweptMesh& mesh, const Job& job, const Fans& fans, std::vector<std::uint8_t>& single,
                       Polish polishing, double mostShort, Settled& settled) {
  const VertexTriangles& around = fans.around;
  Corners corners(mesh, fans.normal, fans.plane, around);
  corners.divide(kCornerOff, single);
  (void)corners.takeChanged();
  setInitialDepths(mesh, job);
  parallelFor(mesh.copies.size(), job.threads, job.context, 4096, [&](std::size_t i) { mesh.place(i); });
  if (polishing == Polish::kYes)
    polish(mesh, job, measure::OffsetError(job, fans.normal, around, Join::kMitre));
  std::vector<double> free;
  for (const Copy& c : mesh.copies) free.push_back(c.depth);
  for (int retries = 0;; ++retries) {
    settled = settle(mesh, job, around, single, free, mostShort);
    if (settled.isShort) return true;
    if (settled.hopeless.empty()) break;
    const std::vector<VertexId> fresh = markAround(job.surface, around, settled.hopeless, single);
    if (fresh.empty() || retries == kMostCornerRetries || !corners.undo(fresh)) return false;
    beginAgain(mesh, job, corners, free);
  }
  if (polishing == Polish::kYes) cutShort(mesh, job, corners, free, around, settled);
  return true;
}

std::optional<SweepResult> sweepWith(const Job& job, Polish polishing, double mostShort) {
  const auto& [positions, triangles] = job.surface;
  Fans fans{mesh::faceNormals(positions, triangles, job.threads),
            {},
            mesh::vertexTriangles(positions.size(), triangles, job.threads),
            mesh::rimOf(positions.size(), triangles, job.threads)};
  std::vector<std::vector<SweepDirection>> direction;
  for (const double sign : {-1.0, 1.0}) {
    if (sign > 0 && job.options.side != Side::kBoth) break;
    fans.plane.push_back(offsetPlanes(job, fans.normal, sign));
    direction.push_back(sweepDirections(job, fans.normal, fans.plane.back(), fans.around, fans.rim));
  }
  SweptMesh mesh = sweepMesh(job, direction, fans.rim);
  markBlockedRimCopies(mesh, fans.around, fans.rim);
  mergeFolds(mesh, fans.around, copiesWithoutDirection(mesh));
  const auto unserved = splitCopies(mesh, fans.normal, fans.around, copiesWithoutDirection(mesh));
  if (const auto stuck = drop(mesh, fans.around, unserved); !stuck.empty())
    throwNoSolidAt(mesh, basesOf(mesh, stuck));
  // Vertices that get no corner: all, where only the room below S is asked for.
  std::vector<std::uint8_t> single(positions.size(), polishing == Polish::kNo ? 1 : 0);
  Settled settled;
  for (const SweptMesh plain = mesh;; mesh = plain) {
    if (settleWithCorners(mesh, job, fans, single, polishing, mostShort, settled)) break;
    // Where corners cannot be undone, no vertex gets one.
    if (std::find(single.begin(), single.end(), 0) == single.end()) throwNoSolidAt(mesh, settled.hopeless);
    std::fill(single.begin(), single.end(), std::uint8_t{1});
  }
  if (settled.isShort) return std::nullopt;
  SweepResult result = resultOf(mesh, job);
  result.rounds = settled.rounds;
  // On both sides S is no part of the result.
  if (job.options.side != Side::kBoth) result.order = std::move(settled.order);
  return result;
}

}  // namespace

SweepResult sweep(const Job& job, Polish polishing) {
  return *sweepWith(job, polishing, 1);
}

std::optional<SweepResult> sweepUnlessShort(const Job& job, double mostShort) {
  return sweepWith(job, Polish::kYes, mostShort);
}

}  // namespace thicken::sweep
