// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/window.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "exact/box_tree.h"
#include "measure/measure.h"
#include "measure/offset_error.h"
#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "mesh/topology.h"
#include "mesh/union_find.h"
#include "reconstruct/drop_unused.h"

namespace thicken::reconstruct {

using measure::areaOf;
using mesh::Bounds;
using mesh::kNone;
using mesh::sortUnique;
using sweep::SweepResult;

namespace {

// Cells that a contour's triangles may go beyond what it is to replace, and beyond its vertices.
constexpr double kMargin = 6, kBeyondContour = 2;

Bounds grown(Bounds b, double by) {
  b.low -= Vec3::Constant(by);
  b.high += Vec3::Constant(by);
  return b;
}

// Joins boxes until none overlaps another, in an order that depends on the boxes alone.
void joinOverlapping(std::vector<Bounds>& boxes) {
  for (std::size_t before = boxes.size() + 1; boxes.size() < before;) {
    before = boxes.size();
    std::sort(boxes.begin(), boxes.end(), [](const Bounds& a, const Bounds& b) {
      return std::lexicographical_compare(a.low.begin(), a.low.end(), b.low.begin(), b.low.end());
    });
    mesh::UnionFind same(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = i + 1; j < boxes.size() && boxes[j].low.x() <= boxes[i].high.x(); ++j)
        if (boxes[i].overlaps(boxes[j])) same.join(i, j);
    std::vector<Bounds> joined(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) joined[same.root(i)].add(boxes[i]);
    std::erase_if(joined, [](const Bounds& b) { return b.low.x() > b.high.x(); });
    boxes = std::move(joined);
  }
}

// Boxes that hold whole pieces of what is open and what they are copies of, between which the material is,
// each grown by the margin in cells of `width` mm and clear of the others.
std::vector<Bounds> zonesOf(const Holes& holes, double width, const TooNarrow& narrow, int threads) {
  const TriangleMesh& mesh = holes.carried.mesh;
  std::vector<Triangle> open;
  for (TriangleId t = 0; t < holes.keep.size(); ++t)
    if (!holes.keep[t]) open.push_back(mesh.triangles[t]);
  if (open.empty()) return {};
  const mesh::Components pieces = mesh::componentsOf(mesh.positions.size(), open, threads);
  std::vector<Bounds> zones(pieces.count);
  for (std::size_t t = 0; t < open.size(); ++t)
    for (const VertexId v : open[t]) {
      Bounds& zone = zones[pieces.ofTriangle[t]];
      zone.add(mesh.positions[v]);
      if (const VertexId base = holes.carried.base[v]; base != kNone) zone.add(mesh.positions[base]);
    }
  for (Bounds& zone : zones)
    zone = grown(zone, (mesh::overlapsAny(narrow.zones, zone) ? narrow.times : 1) * kMargin * width);
  joinOverlapping(zones);
  return zones;
}

class WindowMaker {
 public:
  WindowMaker(const TriangleMesh& surface, const Holes& holes, double beyondContour, double reach,
              int threads)
      : surface_(surface),
        holes_(holes),
        mesh_(holes.carried.mesh),
        beyondContour_(beyondContour),
        reach_(reach),
        boxes_(mesh_.positions, mesh_.triangles, threads, {}, holes.carried.order),
        around_(mesh::vertexTriangles(mesh_.positions.size(), mesh_.triangles, threads)),
        number_(mesh_.positions.size(), kNone),
        in_(mesh_.triangles.size(), 0) {}

  Window around(const Bounds& zone) {
    Window window;
    window.zone = zone;
    window.cut.zone = grown(zone, -beyondContour_);
    const Bounds reached = grown(zone, reach_);
    for (const TriangleId t : boxes_.near(reached.low, reached.high)) add(t, window);
    closeFans(window);
    fill(window);
    for (const TriangleId t : window.source) in_[t] = 0;
    for (const VertexId v : window.vertex) number_[v] = kNone;
    return window;
  }

 private:
  // Other zones' holes are not to be closed here.
  void add(TriangleId t, Window& window) {
    if (in_[t]) return;
    if (!holes_.keep[t] && !window.zone.contains(mesh_.positions[mesh_.triangles[t][0]])) return;
    in_[t] = 1;
    window.source.push_back(t);
  }

  [[nodiscard]] bool isOfSurface(VertexId v) const { return v < surface_.positions.size(); }

  [[nodiscard]] Triangle renumbered(const Triangle& t) const {
    return {number_[t[0]], number_[t[1]], number_[t[2]]};
  }

  [[nodiscard]] bool isKeptWithin(TriangleId t) const { return in_[t] && holes_.keep[t]; }

  // Whether a triangle that is kept in the window has the edge from `a` to `b`, which are around `a`.
  [[nodiscard]] bool hasEdge(VertexId a, VertexId b) const {
    const auto around = around_.of(a);
    return std::any_of(around.begin(), around.end(), [&](TriangleId t) {
      const Triangle& c = mesh_.triangles[t];
      return isKeptWithin(t) &&
             ((c[0] == a && c[1] == b) || (c[1] == a && c[2] == b) || (c[2] == a && c[0] == b));
    });
  }

  // Whether what is kept in the window has more than one fan at a vertex.
  [[nodiscard]] bool isNonManifold(VertexId v) const {
    int fans = 0;
    for (const TriangleId t : around_.of(v)) {
      if (!isKeptWithin(t)) continue;
      const Triangle& c = mesh_.triangles[t];
      const VertexId next = c[0] == v ? c[1] : c[1] == v ? c[2] : c[0];
      fans += hasEdge(next, v) ? 0 : 1;
    }
    return fans > 1;
  }

  [[nodiscard]] bool lacksSurface(VertexId v) const {
    const auto around = around_.of(v);
    return isOfSurface(v) && std::none_of(around.begin(), around.end(), [&](TriangleId t) {
             return t < surface_.triangles.size() && in_[t];
           });
  }

  // No vertex of S without triangles of S, and at no vertex may the edge of the window leave parts that hang
  // together by the vertex alone: all triangles around such vertices are added, until there are none.
  void closeFans(Window& window) {
    std::vector<VertexId> open;
    std::size_t listed = 0;
    const auto listNew = [&] {
      for (; listed < window.source.size(); ++listed)
        for (const VertexId v : mesh_.triangles[window.source[listed]]) open.push_back(v);
    };
    for (listNew(); !open.empty(); listNew()) {
      sortUnique(open);
      for (const VertexId v : std::exchange(open, {}))
        if (lacksSurface(v) || isNonManifold(v))
          for (const TriangleId t : around_.of(v)) add(t, window);
    }
    std::sort(window.source.begin(), window.source.end());
    for (const TriangleId t : window.source)
      for (const VertexId v : mesh_.triangles[t]) window.vertex.push_back(v);
    sortUnique(window.vertex);
    for (VertexId i = 0; i < window.vertex.size(); ++i) number_[window.vertex[i]] = i;
  }

  // A vertex of S that is not in the window is no base there.
  [[nodiscard]] VertexId baseOf(VertexId v) const {
    const VertexId base = holes_.carried.base[v];
    return base == kNone ? kNone : number_[base];
  }

  void fill(Window& window) const {
    SweepResult& part = window.part.carried;
    const SweepResult& whole = holes_.carried;
    for (const VertexId v : window.vertex) {
      part.mesh.positions.push_back(mesh_.positions[v]);
      part.base.push_back(baseOf(v));
      part.distance.push_back(whole.distance[v]);
      part.up.push_back(whole.up.empty() ? Vec3(Vec3::Zero()) : whole.up[v]);
      if (isOfSurface(v)) window.surface.positions.push_back(mesh_.positions[v]);
    }
    for (const TriangleId t : window.source) {
      const Triangle corners = renumbered(mesh_.triangles[t]);
      part.mesh.triangles.push_back(corners);
      part.region.push_back(whole.region[t]);
      window.part.keep.push_back(holes_.keep[t]);
      window.part.openable.push_back(holes_.openable[t]);
      window.part.left.push_back(holes_.left[t]);
      if (!holes_.keep[t]) window.area += areaOf(mesh_.positions, mesh_.triangles[t]);
      if (t < surface_.triangles.size()) window.surface.triangles.push_back(corners);
    }
    fixEdge(window);
  }

  // What lies at the edge of the window stays as it is.
  static void fixEdge(Window& window) {
    SweepResult& part = window.part.carried;
    const std::vector<Triangle>& triangles = part.mesh.triangles;
    window.fixed.assign(part.mesh.positions.size(), 0);
    const mesh::HalfEdges edges(part.mesh.positions.size(), triangles);
    for (TriangleId t = 0; t < triangles.size(); ++t) {
      if (!window.part.keep[t]) continue;
      for (int k = 0; k < 3; ++k) {
        const VertexId a = triangles[t][k], b = triangles[t][(k + 1) % 3];
        if (!edges.uses(b, a).empty()) continue;
        window.cut.edges.push_back({a, b});
        window.fixed[a] = window.fixed[b] = 1;
      }
    }
    std::sort(window.cut.edges.begin(), window.cut.edges.end());
    for (VertexId v = 0; v < window.fixed.size(); ++v) {
      if (!window.fixed[v]) continue;
      part.up[v] = Vec3::Zero();
      if (part.base[v] != v) part.base[v] = kNone;
    }
    for (TriangleId t = 0; t < triangles.size(); ++t)
      if (std::any_of(triangles[t].begin(), triangles[t].end(),
                      [&](VertexId v) { return window.fixed[v] != 0; }))
        window.part.openable[t] = 0;
  }

  const TriangleMesh& surface_;
  const Holes& holes_;
  const TriangleMesh& mesh_;
  double beyondContour_, reach_;
  exact::BoxTree boxes_;
  mesh::VertexTriangles around_;
  std::vector<VertexId> number_;
  std::vector<std::uint8_t> in_;
};

// The boundary's triangles in a window, by their corners.
class Sources {
 public:
  Sources(const TriangleMesh& boundary, const Window& window) : mesh_(boundary), ids_(window.source) {
    std::sort(ids_.begin(), ids_.end(),
              [this](TriangleId a, TriangleId b) { return mesh_.triangles[a] < mesh_.triangles[b]; });
  }

  // The one with these corners, or kNone.
  [[nodiscard]] TriangleId find(const Triangle& corners) const {
    const auto at =
        std::lower_bound(ids_.begin(), ids_.end(), corners,
                         [this](TriangleId t, const Triangle& c) { return mesh_.triangles[t] < c; });
    return at != ids_.end() && mesh_.triangles[*at] == corners ? *at : kNone;
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<TriangleId> ids_;
};

// In terms of the boundary's vertices; with a kNone where one is new.
Triangle inBoundary(const Window& window, const Reconstruction& made, const Triangle& t) {
  Triangle corners{};
  for (int k = 0; k < 3; ++k) {
    const VertexId own = made.origin[t[k]];
    corners[k] = own == kNone ? kNone : window.vertex[own];
  }
  return corners;
}

// Per source triangle of a window, whether what was made there still has it.
std::vector<std::uint8_t> stillThere(const TriangleMesh& boundary, const Window& window,
                                     const Reconstruction& made) {
  const Sources sources(boundary, window);
  const std::size_t ofSurface = window.surface.triangles.size();
  std::vector<std::uint8_t> is(window.source.size(), 0);
  std::fill_n(is.begin(), ofSurface, std::uint8_t{1});
  for (std::size_t t = ofSurface; t < made.mesh.triangles.size(); ++t)
    if (const TriangleId s = sources.find(inBoundary(window, made, made.mesh.triangles[t])); s != kNone)
      is[std::lower_bound(window.source.begin(), window.source.end(), s) - window.source.begin()] = 1;
  return is;
}

// Puts the parts of a boundary together.
class Joiner {
 public:
  Joiner(const TriangleMesh& surface, const Holes& holes) : holes_(holes), surface_(surface) {
    const SweepResult& whole = holes.carried;
    out_.mesh.positions = whole.mesh.positions;
    out_.base = whole.base;
    up_ = whole.up;
    up_.resize(whole.mesh.positions.size(), Vec3::Zero());
    origin_.resize(whole.mesh.positions.size());
    std::iota(origin_.begin(), origin_.end(), VertexId{0});
  }

  void addBoundary(std::span<const std::uint8_t> gone) {
    const SweepResult& whole = holes_.carried;
    for (TriangleId t = 0; t < gone.size(); ++t)
      if (!gone[t]) put(whole.mesh.triangles[t], whole.region[t], holes_.openable[t], holes_.left[t]);
  }

  // What is new in a window.
  void add(const Window& window, const Reconstruction& made) {
    const std::vector<VertexId> to = place(window, made);
    const Sources sources(holes_.carried.mesh, window);
    for (std::size_t t = window.surface.triangles.size(); t < made.region.size(); ++t) {
      const Triangle& corners = made.mesh.triangles[t];
      if (sources.find(inBoundary(window, made, corners)) == kNone)
        put({to[corners[0]], to[corners[1]], to[corners[2]]}, made.region[t], made.openable[t],
            t < made.left.size() ? made.left[t] : std::uint8_t{0});
    }
    out_.rounds += made.rounds;
    out_.cells += made.cells;
    out_.nodes += made.nodes;
    out_.predicted = std::max(out_.predicted, made.predicted);
    out_.finest = out_.finest == 0 ? made.finest : std::min(out_.finest, made.finest);
  }

  Reconstruction take() {
    std::vector<std::uint8_t> used(out_.mesh.positions.size(), 0);
    for (const Triangle& t : out_.mesh.triangles)
      for (const VertexId v : t) used[v] = 1;
    for (VertexId v = 0; v < up_.size(); ++v)
      if (used[v] && !up_[v].isZero(0)) out_.ends.push_back({v, up_[v]});
    out_.origin = std::move(origin_);
    out_.leftArea = 0;
    for (std::size_t t = 0; t < out_.left.size(); ++t)
      if (out_.left[t]) out_.leftArea += areaOf(out_.mesh.positions, out_.mesh.triangles[t]);
    if (!(out_.leftArea > 0)) {
      out_.left.clear();
      out_.base.clear();
    }
    dropUnused(out_, surface_.positions.size());
    return std::move(out_);
  }

 private:
  // Where the vertices of what was made are among those of the boundary.
  std::vector<VertexId> place(const Window& window, const Reconstruction& made) {
    std::vector<VertexId> to(made.mesh.positions.size());
    std::vector<std::uint8_t> moved(to.size(), 1);
    for (VertexId v = 0; v < to.size(); ++v) {
      const VertexId own = made.origin[v];
      if (own == kNone) {
        to[v] = static_cast<VertexId>(out_.mesh.positions.size());
        out_.mesh.positions.push_back(made.mesh.positions[v]);
        out_.base.push_back(kNone);
        up_.push_back(Vec3::Zero());
        origin_.push_back(kNone);
        continue;
      }
      to[v] = window.vertex[own];
      // Other windows may have moved what this one left where it was.
      moved[v] = made.mesh.positions[v] != window.part.carried.mesh.positions[own];
      if (moved[v]) out_.mesh.positions[to[v]] = made.mesh.positions[v];
    }
    for (const WallEnd& end : made.ends)
      if (moved[end.vertex]) up_[to[end.vertex]] = end.up;
    return to;
  }

  void put(const Triangle& t, Region region, std::uint8_t openable, std::uint8_t left) {
    out_.mesh.triangles.push_back(t);
    out_.region.push_back(region);
    out_.openable.push_back(openable);
    out_.left.push_back(left);
  }

  const Holes& holes_;
  const TriangleMesh& surface_;
  Reconstruction out_;
  std::vector<Vec3> up_;
  std::vector<VertexId> origin_;
};

}  // namespace

std::vector<Window> windowsOf(const job::Job& job, const Holes& holes, double width,
                              const TooNarrow& narrow) {
  const std::vector<Bounds> zones = zonesOf(holes, width, narrow, job.threads);
  std::vector<Window> windows;
  if (zones.empty()) return windows;
  // S where it is in reach of the field, and there its copies, which a mitre may put twice as far away.
  const double reach = (1 + measure::kMitreLimit) * job.thickness.most() + kBeyondContour * width;
  WindowMaker maker(job.surface, holes, kBeyondContour * width, reach, job.threads);
  for (const Bounds& zone : zones) windows.push_back(maker.around(zone));
  return windows;
}

bool staysWithin(const Window& window, const Reconstruction& made) {
  const TriangleMesh& part = window.part.carried.mesh;
  for (VertexId v = 0; v < made.mesh.positions.size(); ++v) {
    const VertexId own = made.origin[v];
    if (own != kNone && made.mesh.positions[v] == part.positions[own]) continue;
    if ((own != kNone && window.fixed[own]) || !window.zone.contains(made.mesh.positions[v])) return false;
  }
  return true;
}

Reconstruction withWindows(const TriangleMesh& surface, const Holes& holes, std::span<const Window> windows,
                           std::span<std::optional<Reconstruction>> made) {
  std::vector<std::uint8_t> gone(holes.keep.size(), 0);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (!made[i]) continue;
    const auto is = stillThere(holes.carried.mesh, windows[i], *made[i]);
    std::vector<TriangleId> replaced;
    for (std::size_t k = 0; k < is.size(); ++k)
      if (!is[k]) replaced.push_back(windows[i].source[k]);
    // A long triangle may reach from one zone to another.
    if (std::any_of(replaced.begin(), replaced.end(), [&](TriangleId t) { return gone[t] != 0; }))
      made[i].reset();
    else
      for (const TriangleId t : replaced) gone[t] = 1;
  }
  Joiner joiner(surface, holes);
  joiner.addBoundary(gone);
  for (std::size_t i = 0; i < windows.size(); ++i)
    if (made[i]) joiner.add(windows[i], *made[i]);
  return joiner.take();
}

}  // namespace thicken::reconstruct
