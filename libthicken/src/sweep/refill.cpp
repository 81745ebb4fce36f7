// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/refill.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "mesh/minimal_area.h"
#include "sweep/conflicts.h"
#include "sweep/direction.h"

namespace thicken {

namespace {

using Loop = std::vector<VertexId>;

// What one connected set of dropped copies leaves.
struct Hole {
  std::vector<std::uint32_t> dropped;
  std::vector<Triangle> removed;
  std::vector<Loop> loops;  // borders, in the sense of the removed triangles
};

std::uint64_t edgeKey(VertexId a, VertexId b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}
std::uint64_t directedKey(VertexId a, VertexId b) {
  return (std::uint64_t{a} << 32) | b;
}

bool isDropped(const SweptMesh& mesh, VertexId v) {
  return mesh.isCopy(v) && mesh.copyOf(v).dropped;
}
bool usesDropped(const SweptMesh& mesh, const Triangle& t) {
  return std::any_of(t.begin(), t.end(), [&](VertexId v) { return isDropped(mesh, v); });
}

// Groups the removed triangles by the dropped copies that they share.
std::vector<Hole> holesOf(const SweptMesh& mesh) {
  std::vector<std::uint32_t> up(mesh.copies.size());
  std::iota(up.begin(), up.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (up[i] != i) i = up[i] = up[up[i]];
    return i;
  };
  std::vector<std::pair<std::uint32_t, Triangle>> removed;  // one dropped copy of it, the triangle
  for (std::size_t t = mesh.surfaceTriangles; t < mesh.triangles.size(); ++t) {
    if (!usesDropped(mesh, mesh.triangles[t])) continue;
    std::optional<std::uint32_t> first;
    for (const VertexId v : mesh.triangles[t]) {
      if (!isDropped(mesh, v)) continue;
      const auto i = static_cast<std::uint32_t>(v - mesh.surfaceVertices);
      if (first) up[root(i)] = root(*first);
      first = i;
    }
    removed.emplace_back(*first, mesh.triangles[t]);
  }
  std::map<std::uint32_t, Hole> byRoot;
  for (const auto& [i, t] : removed) byRoot[root(i)].removed.push_back(t);
  for (std::uint32_t i = 0; i < mesh.copies.size(); ++i)
    if (mesh.copies[i].dropped && byRoot.contains(root(i))) byRoot[root(i)].dropped.push_back(i);
  std::vector<Hole> holes;
  for (auto& [i, hole] : byRoot) holes.push_back(std::move(hole));
  return holes;
}

// Finds the loops of a hole, or the vertices at which its border touches itself.
std::vector<VertexId> findLoops(Hole& hole) {
  EdgeSet directed;
  for (const Triangle& t : hole.removed)
    for (int k = 0; k < 3; ++k) directed.insert(directedKey(t[k], t[(k + 1) % 3]));
  std::map<VertexId, VertexId> next;
  std::vector<VertexId> pinched;
  for (const Triangle& t : hole.removed)
    for (int k = 0; k < 3; ++k) {
      const VertexId a = t[k], b = t[(k + 1) % 3];
      if (!directed.contains(directedKey(b, a)) && !next.emplace(a, b).second) pinched.push_back(a);
    }
  hole.loops.clear();
  while (pinched.empty() && !next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const VertexId to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    hole.loops.push_back(std::move(loop));
  }
  return pinched;
}

// Decides which triangles may fill a hole: those that stay clear of S around it however far the
// copies draw back. So the test is made with the copies next to S; deeper, the exact tests of the
// whole sweep decide.
class ShallowTest {
 public:
  ShallowTest(const SweptMesh& mesh, const Hole& hole) : mesh_(mesh), positions_(mesh.positions) {
    std::unordered_set<VertexId> near;
    for (const Triangle& t : hole.removed)
      for (const VertexId v : t) near.insert(mesh.isCopy(v) ? mesh.copyOf(v).base : v);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < mesh.surfaceTriangles; ++t) {
      const Triangle& s = mesh.triangles[t];
      if (std::none_of(s.begin(), s.end(), [&](VertexId v) { return near.contains(v); })) continue;
      obstacles_.push_back(s);
      for (int k = 0; k < 3; ++k)
        shortest = std::min(shortest, (mesh.positions[s[k]] - mesh.positions[s[(k + 1) % 3]]).norm());
    }
    constexpr double kShallow = 1e-3;
    step_ = kShallow * shortest;
    for (const Loop& loop : hole.loops)
      for (const VertexId v : loop)
        if (mesh.isCopy(v)) aim(v, mesh.copyOf(v).offset / mesh.copyOf(v).length);
  }

  // Puts copy `v` next to S in the unit direction `way`.
  void aim(VertexId v, const Vec3& way) {
    positions_[v] = mesh_.positions[mesh_.copyOf(v).base] + step_ * way;
  }

  [[nodiscard]] bool allows(const Triangle& t) const {
    if (exact::collinear(positions_[t[0]], positions_[t[1]], positions_[t[2]])) return false;
    return std::none_of(obstacles_.begin(), obstacles_.end(),
                        [&](const Triangle& s) { return exact::meet(positions_, t, s); });
  }
  [[nodiscard]] bool meet(const Triangle& a, const Triangle& b) const {
    return exact::meet(positions_, a, b);
  }

 private:
  const SweptMesh& mesh_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> obstacles_;
  double step_ = 0;
};

// One copy that takes the place of all that a hole lost: where it stands and which way it goes.
struct Centre {
  std::uint32_t copy = 0;
  Vec3 hull = Vec3::Zero();  // point of least norm of the outward normals' hull
};

// Outward normals, at S, of the triangles that the copies on the loop keep: those with an edge on it.
std::vector<Vec3> normalsAlong(const SweptMesh& mesh, const Hole& hole) {
  EdgeSet border;
  const Loop& loop = hole.loops.front();
  for (std::size_t i = 0; i < loop.size(); ++i)
    border.insert(directedKey(loop[i], loop[(i + 1) % loop.size()]));
  std::vector<Vec3> normals;
  for (const Triangle& t : hole.removed) {
    bool onBorder = false, isShell = true;
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) {
      onBorder = onBorder || border.contains(directedKey(t[k], t[(k + 1) % 3]));
      isShell = isShell && mesh.isCopy(t[k]);
      p[k] = mesh.positions[mesh.isCopy(t[k]) ? mesh.copyOf(t[k]).base : t[k]];
    }
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    if (onBorder && isShell && n.norm() > 0) normals.push_back(n.normalized());
  }
  return normals;
}

std::vector<Triangle> starOf(const Loop& loop, VertexId centre) {
  std::vector<Triangle> star;
  for (std::size_t i = 0; i < loop.size(); ++i)
    star.push_back({loop[i], loop[(i + 1) % loop.size()], centre});
  return star;
}

bool starIsClear(const ShallowTest& test, const std::vector<Triangle>& star) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (!test.allows(star[i])) return false;
    for (std::size_t j = 0; j < i; ++j)
      if (test.meet(star[i], star[j])) return false;
  }
  return true;
}

// The place, among those of the dropped copies, from which the whole loop is seen; nullopt when there
// is none.
std::optional<Centre> centreOf(const SweptMesh& mesh, const Hole& hole, ShallowTest& test) {
  const auto normals = normalsAlong(mesh, hole);
  if (normals.empty()) return std::nullopt;
  const Vec3 hull = minNormPoint(normals);
  if (hull.norm() < kLeastSafety) return std::nullopt;
  for (const std::uint32_t i : hole.dropped) {
    const VertexId v = mesh.vertexOf(i);
    test.aim(v, hull.normalized());
    if (starIsClear(test, starOf(hole.loops.front(), v))) return Centre{i, hull};
  }
  return std::nullopt;
}

// Sends a copy the way of `hull`, the point of least norm of its outward normals' hull.
void aim(Copy& c, const Vec3& hull, double thickness) {
  constexpr double kLongest = 1.5;
  c.safety = hull.norm();
  c.offset = hull.normalized() * thickness * std::min(1 / c.safety, kLongest);
  c.length = c.offset.norm();
}

void revive(SweptMesh& mesh, const Centre& centre, const Loop& loop) {
  Copy& c = mesh.copies[centre.copy];
  aim(c, centre.hull, mesh.thickness);
  c.dropped = false;
  c.depth = 1;
  for (const VertexId v : loop)  // no deeper than what it joins
    if (mesh.isCopy(v)) c.depth = std::min(c.depth, mesh.copyOf(v).depth * mesh.copyOf(v).length / c.length);
}

// Fills one hole; `edges` holds what the mesh has. Empty when it cannot be filled.
std::vector<Triangle> fill(SweptMesh& mesh, const Hole& hole, const EdgeSet& edges) {
  ShallowTest test(mesh, hole);
  if (hole.loops.size() == 1)
    if (const auto centre = centreOf(mesh, hole, test)) {
      revive(mesh, *centre, hole.loops.front());
      return starOf(hole.loops.front(), mesh.vertexOf(centre->copy));
    }
  std::vector<Triangle> all;
  for (const Loop& loop : hole.loops) {
    const auto triangles = minimalAreaTriangulation(mesh.positions, loop, edges,
                                                    [&](const Triangle& t) { return test.allows(t); });
    if (triangles.empty()) return {};
    all.insert(all.end(), triangles.begin(), triangles.end());
  }
  return all;
}

// The label of a filled triangle: wall where it uses the rim of S itself.
Region regionOf(const SweptMesh& mesh, const Triangle& t) {
  return std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh.isCopy(v); }) ? Region::kShell
                                                                                     : Region::kWall;
}

void removeDroppedTriangles(SweptMesh& mesh) {
  std::size_t kept = mesh.surfaceTriangles;
  for (std::size_t t = kept; t < mesh.triangles.size(); ++t) {
    if (usesDropped(mesh, mesh.triangles[t])) continue;
    mesh.triangles[kept] = mesh.triangles[t];
    mesh.region[kept++] = mesh.region[t];
  }
  mesh.triangles.resize(kept);
  mesh.region.resize(kept);
}

std::vector<std::uint32_t> copiesOf(const SweptMesh& mesh, std::span<const VertexId> vertices) {
  std::vector<std::uint32_t> ids;
  for (const VertexId v : vertices)
    if (mesh.isCopy(v)) ids.push_back(static_cast<std::uint32_t>(v - mesh.surfaceVertices));
  sortUnique(ids);
  return ids;
}

// Opens the holes that dropping `copies` leaves, with the copies at which a hole would touch itself.
// Returns false, with the copies of that hole in `around`, where S itself is pinched.
bool openHoles(SweptMesh& mesh, std::vector<std::uint32_t> copies, std::vector<Hole>& holes,
               std::vector<std::uint32_t>& around) {
  while (!copies.empty()) {
    for (const std::uint32_t i : copies) mesh.copies[i].dropped = true;
    copies.clear();
    holes = holesOf(mesh);
    for (Hole& hole : holes) {
      const auto pinched = findLoops(hole);
      if (pinched.empty()) continue;
      const auto inTheWay = copiesOf(mesh, pinched);
      if (inTheWay.empty()) {
        std::vector<VertexId> border;
        for (const Triangle& t : hole.removed) border.insert(border.end(), t.begin(), t.end());
        around = copiesOf(mesh, border);
        return false;
      }
      copies.insert(copies.end(), inTheWay.begin(), inTheWay.end());
    }
  }
  removeDroppedTriangles(mesh);
  return true;
}

void append(SweptMesh& mesh, const std::vector<Triangle>& triangles) {
  for (const Triangle& t : triangles) {
    mesh.triangles.push_back(t);
    mesh.region.push_back(regionOf(mesh, t));
  }
  mesh.fixed.resize(mesh.triangles.size());
  std::fill(mesh.fixed.begin() + static_cast<std::ptrdiff_t>(mesh.surfaceTriangles), mesh.fixed.end(),
            std::uint8_t{0});
}

// Gives a copy the safest direction for the shell triangles that now use it.
void aimAfresh(SweptMesh& mesh, VertexId v) {
  std::vector<Vec3> normals;
  for (std::size_t t = mesh.surfaceTriangles; t < mesh.triangles.size(); ++t) {
    const Triangle& s = mesh.triangles[t];
    if (std::find(s.begin(), s.end(), v) == s.end() || mesh.region[t] != Region::kShell) continue;
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) p[k] = mesh.positions[mesh.copyOf(s[k]).base];
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    if (n.norm() > 0) normals.push_back(n.normalized());
  }
  if (normals.empty()) return;
  const Vec3 hull = minNormPoint(normals);
  if (hull.norm() > kLeastSafety) aim(mesh.copyOf(v), hull, mesh.thickness);
}

}  // namespace

bool collapseCopies(SweptMesh& mesh, std::span<const std::uint32_t> copies) {
  SweptMesh next = mesh;
  std::vector<Hole> holes;
  std::vector<std::uint32_t> around;
  if (!openHoles(next, {copies.begin(), copies.end()}, holes, around)) return false;
  if (holes.size() != 1 || holes[0].loops.size() != 1) return false;
  const Hole& hole = holes[0];
  const Loop& loop = hole.loops[0];
  for (const std::uint32_t i : copies) {
    SweptMesh trial = next;
    const VertexId v = mesh.vertexOf(i);
    trial.copies[i].dropped = false;
    append(trial, starOf(loop, v));
    aimAfresh(trial, v);
    if (trial.copies[i].safety < kLeastSafety) continue;
    for (const VertexId u : loop)
      if (trial.isCopy(u) && trial.copyOf(u).safety < kLeastSafety) aimAfresh(trial, u);
    ShallowTest test(trial, hole);
    test.aim(v, trial.copies[i].offset / trial.copies[i].length);
    if (!starIsClear(test, starOf(loop, v))) continue;
    mesh = std::move(trial);
    return true;
  }
  return false;
}

std::vector<std::uint32_t> dropAndRefill(SweptMesh& mesh, std::vector<std::uint32_t> copies) {
  SweptMesh next = mesh;
  std::vector<Hole> holes;
  std::vector<std::uint32_t> around;
  if (!openHoles(next, std::move(copies), holes, around)) return around;
  EdgeSet edges;
  const auto addEdges = [&](std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) edges.insert(edgeKey(t[k], t[(k + 1) % 3]));
  };
  addEdges(next.triangles);
  for (const Hole& hole : holes) {
    const auto triangles = fill(next, hole, edges);
    if (triangles.empty() && !hole.loops.empty()) {
      std::vector<VertexId> border;
      for (const Loop& loop : hole.loops) border.insert(border.end(), loop.begin(), loop.end());
      return copiesOf(mesh, border);
    }
    addEdges(triangles);
    append(next, triangles);
  }
  mesh = std::move(next);
  return {};
}

}  // namespace thicken
