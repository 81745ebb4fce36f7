// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/corners.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "measure/offset_error.h"
#include "mesh/sort_unique.h"
#include "sweep/corner_surroundings.h"

namespace thicken::sweep {

using mesh::VertexTriangles;

namespace {

// The shell of one side of S, of which corners are divided or cut.
class CornerDivider : private CopiedShell {
 public:
  using CopiedShell::listCopied;

  CornerDivider(SweptMesh& mesh, std::span<const Vec3> faceNormal, std::span<const OffsetPlane> plane,
                const VertexTriangles& around, std::size_t firstCopy, double sign)
      : CopiedShell(mesh, around, firstCopy, sign), mesh_(mesh), normal_(faceNormal), plane_(plane) {}

  void divide(VertexId v) {
    const std::optional<Fan> fan = copiedFan(v);
    if (!fan || !fan->isClosed()) return cut(v);
    const Vec3 single = mesh_.copies[firstCopy_ + v].offset / (sign_ * mesh_.thickness.at(v));
    CornerMaker maker(*fan, plane_, single);
    double before = 0;
    for (const TriangleId s : fan->triangle) before = std::max(before, offFrom(plane_[s], single));
    CornerSurroundings surroundings(*this, mesh_, normal_, around_, v, *fan);
    const auto most = surroundings.meetings(chainsAt(v, *fan));
    if (!most) return;
    constexpr std::size_t kMostTried = 8;
    std::size_t tried = 0;
    for (const PlaneTriangulation* candidate : maker.candidates()) {
      const Corner corner = maker.corner(*candidate);
      if (maker.errorOf(corner) > before / 2) continue;
      const std::size_t copies = mesh_.copies.size();
      const Copy old = mesh_.copies[firstCopy_ + v];
      const auto chains = put(v, *fan, corner);
      const auto meet = surroundings.meetings(chains);
      if (meet && *meet <= *most) {
        take(v, *fan, chains);
        single_.emplace(v, old);
        return;
      }
      takeBack(copies);
      mesh_.copies[firstCopy_ + v] = old;
      if (meet && ++tried == kMostTried) break;
    }
    cut(v);
  }

  // Puts a copy on each edge around `v`, in both its planes: what is off at `v` goes no farther.
  void cut(VertexId v) {
    if (around_.of(v).empty()) return;
    const std::optional<Fan> fan = fanOf(mesh_.triangles, around_.of(v), v);
    const auto own = chainsAt(v, *fan);
    CornerSurroundings surroundings(*this, mesh_, normal_, around_, v, *fan);
    const auto most = surroundings.meetings(own);
    if (!most) return;
    constexpr double kAway[] = {0.5, 1, 2};  // r
    for (const double away : kAway) {
      const std::size_t copies = mesh_.copies.size();
      if (const auto chains = withCuts(v, *fan, own, away)) {
        if (const auto meet = surroundings.meetings(*chains); meet && *meet <= *most) {
          take(v, *fan, *chains);
          return;
        }
      }
      takeBack(copies);
    }
  }

  // Whether what was made at the vertex can be undone.
  [[nodiscard]] bool canUndo(VertexId v) const {
    const auto around = around_.of(v);
    return std::all_of(around.begin(), around.end(),
                       [&](TriangleId s) { return !chains_.contains(s) || isCopied(s); });
  }

  // Puts the copy that was there before in the place of those that a vertex got.
  void undo(VertexId v) {
    const auto own = static_cast<std::uint32_t>(firstCopy_ + v);
    for (const TriangleId s : around_.of(v)) {
      const auto it = chains_.find(s);
      if (it == chains_.end()) continue;
      Chain& chain = it->second[cornerOf(s, v)];
      if (chain.size() == 1 && chain.front() == own) continue;
      for (const std::uint32_t i : chain) mesh_.copies[i].dropped = i != own;
      chain = {own};
      changed_.insert(s);
    }
    if (const auto it = single_.find(v); it != single_.end()) mesh_.copies[own] = it->second;
  }

  // Puts the polygons of the divided corners into the mesh, and lists their copies.
  void finish(std::vector<std::uint32_t>& copies) {
    std::vector<TriangleId> changed(changed_.begin(), changed_.end());
    std::sort(changed.begin(), changed.end());
    std::vector<std::uint8_t> removed(mesh_.triangles.size(), 0);
    for (const TriangleId s : changed) {
      std::vector<VertexId> polygon;
      std::vector<Vec3> p;
      for (const auto& chain : chains_.at(s))
        for (const std::uint32_t i : chain) {
          copies.push_back(i);
          polygon.push_back(mesh_.vertexOf(i));
          p.push_back(placeOf(i));
        }
      std::size_t put = 0;
      for (const auto& [a, b, c] : triangulated(p, normal_[s])) {
        Triangle t{polygon[a], polygon[b], polygon[c]};
        if (sign_ < 0) std::swap(t[1], t[2]);
        if (put < copied_[s].size())
          mesh_.triangles[copied_[s][put++]] = t;
        else
          mesh_.add(t, Region::kShell, s);
      }
      for (; put < copied_[s].size(); ++put) removed[copied_[s][put]] = 1;
    }
    if (std::find(removed.begin(), removed.end(), 1) != removed.end()) {
      removed.resize(mesh_.triangles.size(), 0);
      mesh_.remove(removed);
    }
    changed_.clear();
    listCopied();
  }

 private:
  using Chain = std::vector<std::uint32_t>;  // copies
  using Chains = std::array<Chain, 3>;       // at the corners of a triangle of S, in its sense

  std::uint32_t add(VertexId v, const Vec3& offset, double safety) {
    Copy c;
    c.base = v;
    c.offset = offset;
    c.length = offset.norm();
    c.safety = safety;
    c.exact = true;
    mesh_.copies.push_back(c);
    mesh_.positions.push_back(mesh_.positions[v]);
    return static_cast<std::uint32_t>(mesh_.copies.size() - 1);
  }

  void takeBack(std::size_t copies) {
    mesh_.copies.resize(copies);
    mesh_.positions.resize(mesh_.surfaceVertices + copies);
  }

  // Copies for a corner, the first in the place of the single one.
  std::vector<Chain> put(VertexId v, const Fan& fan, const Corner& corner) {
    std::vector<double> safety(corner.m.size(), 1);
    for (std::size_t i = 0; i < fan.triangle.size(); ++i)
      for (const int c : corner.chain[i])
        safety[c] = std::min(safety[c], normal_[fan.triangle[i]].dot(corner.m[c]) / corner.m[c].norm());
    Chain id;
    for (std::size_t c = 0; c < corner.m.size(); ++c)
      id.push_back(add(v, sign_ * mesh_.thickness.at(v) * corner.m[c], safety[c]));
    mesh_.copies[firstCopy_ + v] = mesh_.copies.back();
    takeBack(mesh_.copies.size() - 1);
    id.back() = static_cast<std::uint32_t>(firstCopy_ + v);
    std::vector<Chain> chains(fan.triangle.size());
    for (std::size_t i = 0; i < chains.size(); ++i)
      for (const int c : corner.chain[i]) chains[i].push_back(id[c]);
    return chains;
  }

  // The chains with another copy at either end, `away` · r along the edges or more where the copies of `v`
  // are as far along. Nothing where all edges are too short for that.
  std::optional<std::vector<Chain>> withCuts(VertexId v, const Fan& fan, std::vector<Chain> chains,
                                             double away) {
    constexpr double kMostShare = 0.45;  // of an edge, which may be cut from its other end, too
    constexpr double kBeyond = 1.25;     // of what the copies of v are along
    const std::size_t n = fan.triangle.size();
    const double r = mesh_.thickness.at(v);
    bool any = false;
    for (std::size_t i = fan.isClosed() ? 0 : 1; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      if (!isCopied(fan.triangle[before]) || !isCopied(fan.triangle[i])) continue;
      const OffsetPlane &one = plane_[fan.triangle[before]], &other = plane_[fan.triangle[i]];
      const Vec3 &a = one.normal, &b = other.normal;
      const Vec3 m = (one.way + other.way) / 2 * (a + b) / (1 + a.dot(b));
      const Vec3 edge = mesh_.positions[fan.ring[i]] - mesh_.positions[v];
      const double length = edge.norm();
      double at = away * r;
      for (const std::uint32_t c : chains[i])
        at = std::max(at, kBeyond * (placeOf(c) - mesh_.positions[v]).dot(edge) / length);
      if (!(m.norm() <= measure::kMitreLimit) || at > kMostShare * length) continue;
      any = true;
      const double there = r + at / length * (mesh_.thickness.at(fan.ring[i]) - r);
      const Vec3 offset = sign_ * there * m + (at / length) * edge;
      const std::uint32_t id = add(v, offset, there / offset.norm());
      chains[i].push_back(id);
      chains[before].insert(chains[before].begin(), id);
    }
    if (!any) return std::nullopt;
    return chains;
  }

  void take(VertexId v, const Fan& fan, const std::vector<Chain>& chains) {
    for (std::size_t i = 0; i < fan.triangle.size(); ++i) {
      const TriangleId s = fan.triangle[i];
      if (!isCopied(s)) continue;
      Chains all = chainsOf(s);
      all[cornerOf(s, v)] = chains[i];
      chains_[s] = std::move(all);
      changed_.insert(s);
    }
  }

  SweptMesh& mesh_;
  std::span<const Vec3> normal_;
  std::span<const OffsetPlane> plane_;
  std::unordered_map<VertexId, Copy> single_;  // that a corner took the place of
};

}  // namespace

// Whether an edge at `v` is longer than `length`.
bool hasLongEdge(const SweptMesh& mesh, std::span<const TriangleId> around, VertexId v, double length) {
  return std::any_of(around.begin(), around.end(), [&](TriangleId t) {
    return std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), [&](VertexId u) {
      return (mesh.positions[u] - mesh.positions[v]).squaredNorm() > length * length;
    });
  });
}

// Around shorter edges, in r, the triangles that are off are small anyway.
constexpr double kLong = 2;

struct Corners::Impl {
  SweptMesh& mesh;
  std::span<const std::vector<OffsetPlane>> plane;
  const VertexTriangles& around;
  std::vector<CornerDivider> shells;
  std::vector<std::uint8_t> cut;       ///< per copy that is single: whether it was
  std::vector<std::uint32_t> changed;  ///< copies
};

Corners::Corners(SweptMesh& mesh, std::span<const Vec3> faceNormal,
                 std::span<const std::vector<OffsetPlane>> plane, const VertexTriangles& around)
    : impl_(std::make_unique<Impl>(Impl{mesh, plane, around, {}, {}, {}})) {
  for (std::size_t shell = 0; shell < mesh.shells; ++shell)
    impl_->shells.emplace_back(mesh, faceNormal, plane[shell], around, shell * mesh.surfaceVertices,
                               shell == 0 ? -1 : 1);
  impl_->cut.assign(mesh.shells * mesh.surfaceVertices, 0);
}

Corners::~Corners() = default;

void Corners::divide(double tolerance, std::span<const std::uint8_t> single) {
  SweptMesh& mesh = impl_->mesh;
  for (std::size_t shell = 0; shell < mesh.shells; ++shell) {
    CornerDivider& divider = impl_->shells[shell];
    for (VertexId v = 0; v < mesh.surfaceVertices; ++v) {
      const Copy& c = mesh.copies[shell * mesh.surfaceVertices + v];
      if (single[v] || c.dropped || c.safety < kLeastSafety) continue;
      const double r = mesh.thickness.at(v);
      const Vec3 m = c.offset / ((shell == 0 ? -1 : 1) * r);
      const auto fan = impl_->around.of(v);
      if (std::none_of(fan.begin(), fan.end(),
                       [&](TriangleId s) { return offFrom(impl_->plane[shell][s], m) > tolerance; }))
        continue;
      if (!hasLongEdge(mesh, fan, v, kLong * r)) continue;
      divider.divide(v);
      impl_->cut[shell * mesh.surfaceVertices + v] = 1;
    }
    divider.finish(impl_->changed);
  }
}

bool Corners::undo(std::span<const VertexId> vertices) {
  for (CornerDivider& divider : impl_->shells) {
    divider.listCopied();
    if (!std::all_of(vertices.begin(), vertices.end(), [&](VertexId v) { return divider.canUndo(v); }))
      return false;
  }
  for (CornerDivider& divider : impl_->shells) {
    divider.listCopied();
    for (const VertexId v : vertices) divider.undo(v);
    divider.finish(impl_->changed);
  }
  return true;
}

std::vector<std::uint32_t> Corners::takeChanged() {
  mesh::sortUnique(impl_->changed);
  std::erase_if(impl_->changed, [&](std::uint32_t i) { return impl_->mesh.copies[i].dropped; });
  return std::exchange(impl_->changed, {});
}

void Corners::cutShort(std::span<const double> depth) {
  constexpr double kShort = 0.9;  // of the depth that was free
  SweptMesh& mesh = impl_->mesh;
  for (std::size_t shell = 0; shell < mesh.shells; ++shell) {
    CornerDivider& divider = impl_->shells[shell];
    divider.listCopied();
    for (VertexId v = 0; v < mesh.surfaceVertices; ++v) {
      const std::size_t i = shell * mesh.surfaceVertices + v;
      if (mesh.copies[i].dropped || mesh.copies[i].depth >= kShort * depth[i] ||
          std::exchange(impl_->cut[i], std::uint8_t{1}) ||
          !hasLongEdge(mesh, impl_->around.of(v), v, kLong * mesh.thickness.at(v)))
        continue;
      divider.cut(v);
    }
    divider.finish(impl_->changed);
  }
}

}  // namespace thicken::sweep
