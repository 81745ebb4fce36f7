// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/shell_surgery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <unordered_map>

#include "exact/predicates.h"
#include "exact/triangle_pair.h"
#include "mesh/minimal_area.h"
#include "mesh/sort_unique.h"
#include "sweep/direction.h"

namespace thicken::sweep {

using mesh::directedKey;
using mesh::edgeKey;
using mesh::EdgeSet;
using mesh::sortUnique;
using mesh::vertexTriangles;

namespace {

bool uses(const Triangle& t, VertexId v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

// Sends a copy the way of `hull`, the point of least norm of its outward normals' hull.
void aim(Copy& c, const Vec3& hull, double thickness) {
  constexpr double kLongest = 1.5;
  c.safety = hull.norm();
  c.offset = hull.normalized() * thickness * std::min(1 / c.safety, kLongest);
  c.length = c.offset.norm();
}

std::vector<Triangle> starOf(std::span<const VertexId> loop, VertexId centre) {
  std::vector<Triangle> star;
  for (std::size_t i = 0; i < loop.size(); ++i)
    star.push_back({loop[i], loop[(i + 1) % loop.size()], centre});
  return star;
}

}  // namespace

// The copies around one hole next to S, and the triangles of S that a patch must not meet.
class ShellSurgery::ShallowTest {
 public:
  ShallowTest(const ShellSurgery& shell, const Hole& hole) : shell_(shell) {
    std::vector<TriangleId> near;
    for (const TriangleId t : hole.removed)
      for (const VertexId v : shell.mesh_.triangles[t]) {
        const auto fan = shell.around_.of(shell.baseOf(v));
        near.insert(near.end(), fan.begin(), fan.end());
      }
    sortUnique(near);
    double shortest = std::numeric_limits<double>::infinity();
    const auto& p = shell.mesh_.positions;
    for (const TriangleId t : near) {
      const Triangle& s = shell.mesh_.triangles[t];
      for (int k = 0; k < 3; ++k) shortest = std::min(shortest, (p[s[k]] - p[s[(k + 1) % 3]]).norm());
    }
    constexpr double kShallow = 1e-3;
    step_ = kShallow * shortest;
    for (const TriangleId t : near) obstacles_.push_back(local(shell.mesh_.triangles[t]));
    for (const Loop& loop : hole.loops)
      for (const VertexId v : loop)
        if (shell.mesh_.isCopy(v)) put(v, shell.mesh_.copyOf(v));
  }

  // Puts vertex `v`, a copy like `c`, next to S.
  void put(VertexId v, const Copy& c) {
    positions_[localId(v)] = shell_.mesh_.positions[c.base] + step_ / c.length * c.offset;
  }

  [[nodiscard]] bool allows(const Triangle& t) {
    const Triangle s = local(t);
    return !exact::collinear(positions_[s[0]], positions_[s[1]], positions_[s[2]]) &&
           std::none_of(obstacles_.begin(), obstacles_.end(),
                        [&](const Triangle& o) { return exact::meet(positions_, s, o); });
  }

  // Whether all of `patch` is clear of S and of itself.
  [[nodiscard]] bool allowsAll(std::span<const Triangle> patch) {
    for (std::size_t i = 0; i < patch.size(); ++i) {
      if (!allows(patch[i])) return false;
      for (std::size_t j = 0; j < i; ++j)
        if (exact::meet(positions_, local(patch[i]), local(patch[j]))) return false;
    }
    return true;
  }

 private:
  VertexId localId(VertexId v) {
    const auto [it, fresh] = ids_.emplace(v, static_cast<VertexId>(positions_.size()));
    if (fresh) positions_.push_back(shell_.mesh_.positions[v]);
    return it->second;
  }
  Triangle local(const Triangle& t) { return {localId(t[0]), localId(t[1]), localId(t[2])}; }

  const ShellSurgery& shell_;
  std::unordered_map<VertexId, VertexId> ids_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> obstacles_;
  double step_ = 0;
};

ShellSurgery::ShellSurgery(SweptMesh& mesh, const mesh::VertexTriangles& around)
    : mesh_(mesh), around_(around), uses_(vertexTriangles(mesh.positions.size(), mesh.triangles)) {}

std::vector<std::uint32_t> ShellSurgery::copiesAmong(std::span<const VertexId> vertices) const {
  std::vector<std::uint32_t> ids;
  for (const VertexId v : vertices)
    if (mesh_.isCopy(v)) ids.push_back(copyId(v));
  sortUnique(ids);
  return ids;
}

std::vector<std::uint32_t> ShellSurgery::neighboursOf(std::uint32_t copy) const {
  std::vector<VertexId> vertices;
  for (const TriangleId t : uses_.of(mesh_.vertexOf(copy)))
    vertices.insert(vertices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
  auto ids = copiesAmong(vertices);
  std::erase(ids, copy);
  const auto distance = [&](std::uint32_t i) {
    return (mesh_.positions[mesh_.copies[i].base] - mesh_.positions[mesh_.copies[copy].base]).norm();
  };
  std::stable_sort(ids.begin(), ids.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
  return ids;
}

// Groups the triangles that use a dropped copy by the dropped copies that they share.
std::vector<ShellSurgery::Hole> ShellSurgery::holesOf(std::span<const std::uint32_t> dropped) const {
  std::vector<Hole> holes;
  std::unordered_map<std::uint32_t, bool> open;  // dropped copies, and whether no hole has them yet
  for (const std::uint32_t i : dropped) open[i] = true;
  for (const std::uint32_t start : dropped) {
    if (!std::exchange(open[start], false)) continue;
    Hole hole;
    hole.dropped.push_back(start);
    for (std::size_t k = 0; k < hole.dropped.size(); ++k)
      for (const TriangleId t : uses_.of(mesh_.vertexOf(hole.dropped[k]))) {
        hole.removed.push_back(t);
        for (const std::uint32_t i : copiesAmong(mesh_.triangles[t]))
          if (const auto it = open.find(i); it != open.end() && std::exchange(it->second, false))
            hole.dropped.push_back(i);
      }
    sortUnique(hole.dropped);
    sortUnique(hole.removed);
    holes.push_back(std::move(hole));
  }
  return holes;
}

// Finds the loops of a hole, or returns the vertices at which its border touches itself.
std::vector<VertexId> ShellSurgery::findLoops(Hole& hole) const {
  EdgeSet directed;
  for (const TriangleId t : hole.removed)
    for (int k = 0; k < 3; ++k)
      directed.insert(directedKey(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]));
  std::map<VertexId, VertexId> next;
  std::vector<VertexId> nonManifold;
  for (const TriangleId t : hole.removed)
    for (int k = 0; k < 3; ++k) {
      const VertexId a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
      if (!directed.contains(directedKey(b, a)) && !next.emplace(a, b).second) nonManifold.push_back(a);
    }
  hole.loops.clear();
  while (nonManifold.empty() && !next.empty()) {
    Loop loop;
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const VertexId to = at->second;
      next.erase(at);
      at = next.find(to);
    }
    hole.loops.push_back(std::move(loop));
  }
  return nonManifold;
}

// Opens the holes that dropping `copies` leaves. Returns false, with the copies of that hole in `around`, if
// S itself has a non-manifold vertex there.
bool ShellSurgery::open(std::vector<std::uint32_t> copies, std::vector<Hole>& holes,
                        std::vector<std::uint32_t>& around) const {
  for (bool again = true; again;) {
    again = false;
    sortUnique(copies);
    holes = holesOf(copies);
    for (Hole& hole : holes) {
      const auto nonManifold = findLoops(hole);
      if (nonManifold.empty()) continue;
      const auto inTheWay = copiesAmong(nonManifold);
      if (inTheWay.empty()) {
        std::vector<VertexId> border;
        for (const TriangleId t : hole.removed)
          border.insert(border.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
        around = copiesAmong(border);
        return false;
      }
      copies.insert(copies.end(), inTheWay.begin(), inTheWay.end());
      again = true;
    }
  }
  return true;
}

// Outward normals, at S, of the shell triangles that use `v` once `added` stands for the hole.
std::vector<Vec3> ShellSurgery::outwardNormals(VertexId v, const Hole& hole,
                                               std::span<const Triangle> added) const {
  std::vector<Vec3> normals;
  const auto add = [&](const Triangle& t) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) {
      if (!mesh_.isCopy(t[k])) return;  // a wall
      p[k] = mesh_.positions[mesh_.copyOf(t[k]).base];
    }
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    if (n.norm() > 0) normals.push_back(n.normalized());
  };
  for (const TriangleId t : uses_.of(v))
    if (mesh_.region[t] == Region::kShell && !std::binary_search(hole.removed.begin(), hole.removed.end(), t))
      add(mesh_.triangles[t]);
  for (const Triangle& t : added)
    if (uses(t, v)) add(t);
  return normals;
}

// A patch of one copy, that of the dropped copy `at`, from which the whole border is seen.
bool ShellSurgery::centre(const Hole& hole, std::uint32_t at, Patch& patch) const {
  if (hole.loops.size() != 1) return false;
  const Loop& loop = hole.loops.front();
  const VertexId v = mesh_.vertexOf(at);
  patch.triangles = starOf(loop, v);
  patch.aimed.clear();
  const auto aimed = [&](VertexId x, Copy& c) {
    const auto normals = outwardNormals(x, hole, patch.triangles);
    const Vec3 hull = normals.empty() ? Vec3::Zero() : minNormPoint(normals);
    if (hull.norm() < kLeastSafety) return false;
    aim(c, hull, mesh_.thickness.at(c.base));
    return true;
  };
  Copy c = mesh_.copies[at];
  if (!aimed(v, c)) return false;
  c.depth = 1;
  for (const VertexId u : loop)  // no deeper than what it joins
    if (mesh_.isCopy(u))
      c.depth = std::min(c.depth, mesh_.copyOf(u).depth * mesh_.copyOf(u).length / c.length);
  patch.aimed.emplace_back(at, c);
  ShallowTest test(*this, hole);
  test.put(v, c);
  for (const VertexId u : loop) {
    if (!mesh_.isCopy(u) || mesh_.copyOf(u).safety >= kLeastSafety) continue;
    Copy other = mesh_.copyOf(u);
    if (!aimed(u, other)) continue;
    test.put(u, other);
    patch.aimed.emplace_back(copyId(u), other);
  }
  return test.allowsAll(patch.triangles);
}

bool ShellSurgery::triangulate(const Hole& hole, Patch& patch) const {
  ShallowTest test(*this, hole);
  EdgeSet edges;
  for (const Loop& loop : hole.loops)
    for (const VertexId v : loop)
      for (const TriangleId t : uses_.of(v))
        if (!std::binary_search(hole.removed.begin(), hole.removed.end(), t))
          for (int k = 0; k < 3; ++k)
            edges.insert(edgeKey(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]));
  patch = {};
  for (const Loop& loop : hole.loops) {
    const auto triangles = mesh::minimalAreaTriangulation(mesh_.positions, loop, edges,
                                                          [&](const Triangle& t) { return test.allows(t); });
    if (triangles.empty()) return false;
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) edges.insert(edgeKey(t[k], t[(k + 1) % 3]));
    patch.triangles.insert(patch.triangles.end(), triangles.begin(), triangles.end());
  }
  return true;
}

void ShellSurgery::apply(std::span<const Hole> holes, std::span<const Patch> patches) {
  std::vector<std::uint8_t> removed(mesh_.triangles.size(), 0);
  for (const Hole& hole : holes) {
    for (const TriangleId t : hole.removed) removed[t] = 1;
    for (const std::uint32_t i : hole.dropped) mesh_.copies[i].dropped = true;
  }
  mesh_.remove(removed);
  for (const Patch& patch : patches) {
    for (const auto& [i, c] : patch.aimed) {
      mesh_.copies[i] = c;
      mesh_.copies[i].dropped = false;
    }
    for (const Triangle& t : patch.triangles) {
      const bool shell = std::all_of(t.begin(), t.end(), [&](VertexId v) { return mesh_.isCopy(v); });
      mesh_.add(t, shell ? Region::kShell : Region::kWall, mesh::kNone);
    }
  }
  uses_ = vertexTriangles(mesh_.positions.size(), mesh_.triangles);
}

bool ShellSurgery::merge(std::span<const std::uint32_t> copies) {
  std::vector<Hole> holes;
  std::vector<std::uint32_t> around;
  if (!open({copies.begin(), copies.end()}, holes, around) || holes.size() != 1) return false;
  Patch patch;
  for (const std::uint32_t i : copies)
    if (centre(holes[0], i, patch)) {
      apply(holes, std::span(&patch, 1));
      return true;
    }
  return false;
}

std::vector<std::uint32_t> ShellSurgery::drop(std::vector<std::uint32_t> copies) {
  std::vector<Hole> holes;
  std::vector<std::uint32_t> around;
  if (!open(std::move(copies), holes, around)) return around;
  std::vector<Patch> patches(holes.size());
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const bool filled = std::any_of(holes[h].dropped.begin(), holes[h].dropped.end(),
                                    [&](std::uint32_t i) { return centre(holes[h], i, patches[h]); }) ||
                        triangulate(holes[h], patches[h]);
    if (filled) continue;
    std::vector<VertexId> border;
    for (const Loop& loop : holes[h].loops) border.insert(border.end(), loop.begin(), loop.end());
    return copiesAmong(border);
  }
  apply(holes, patches);
  return {};
}

}  // namespace thicken::sweep
