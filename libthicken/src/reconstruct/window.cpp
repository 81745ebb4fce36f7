// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/window.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "exact/box_tree.h"
#include "measure/measure.h"
#include "mesh/half_edges.h"
#include "mesh/sort_unique.h"
#include "mesh/topology.h"
#include "reconstruct/carrier.h"
#include "reconstruct/drop_unused.h"

namespace thicken {

namespace {

// Cells that a contour's triangles may go beyond what it is to replace, where that is enough and where it is
// not, and that they may go beyond its vertices.
constexpr double kMargin = 20, kWideMargin = 100, kBeyondContour = 4;
// Holes of more pieces are closed in one window.
constexpr std::size_t kMostPieces = 512;

Bounds grown(Bounds b, double by) {
  b.low -= Vec3::Constant(by);
  b.high += Vec3::Constant(by);
  return b;
}

// Boxes that hold whole pieces of what is open, each grown by the margin in cells of `width` mm and clear of
// the others.
std::vector<Bounds> zonesOf(const Holes& holes, double width, std::span<const Bounds> tooNarrow,
                            int threads) {
  const TriangleMesh& mesh = holes.carried.mesh;
  std::vector<Triangle> open;
  for (TriangleId t = 0; t < holes.keep.size(); ++t)
    if (!holes.keep[t]) open.push_back(mesh.triangles[t]);
  if (open.empty()) return {};
  const Components pieces = componentsOf(mesh.positions.size(), open, threads);
  const bool asOne = pieces.count > kMostPieces;
  std::vector<Bounds> zones(asOne ? 1 : pieces.count);
  for (std::size_t t = 0; t < open.size(); ++t)
    for (const VertexId v : open[t]) zones[asOne ? 0 : pieces.ofTriangle[t]].add(mesh.positions[v]);
  for (Bounds& zone : zones) {
    zone = grown(zone, (overlapsAny(tooNarrow, zone) ? kWideMargin : kMargin) * width);
  }
  for (std::size_t i = 0; i < zones.size();) {
    const auto other = std::find_if(zones.begin() + static_cast<std::ptrdiff_t>(i) + 1, zones.end(),
                                    [&](const Bounds& zone) { return zone.overlaps(zones[i]); });
    if (other == zones.end()) {
      ++i;
      continue;
    }
    zones[i].add(*other);
    zones.erase(other);
    i = 0;
  }
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
        boxes_(mesh_.positions, mesh_.triangles, threads),
        around_(vertexTriangles(mesh_.positions.size(), mesh_.triangles, threads)),
        number_(mesh_.positions.size(), kNone),
        in_(mesh_.triangles.size(), 0) {}

  Window around(const Bounds& zone) {
    Window window;
    window.zone = zone;
    window.cut.zone = grown(zone, -beyondContour_);
    const Bounds reached = grown(zone, reach_);
    for (const TriangleId t : boxes_.near(reached.low, reached.high)) add(t, window);
    closeFans(window);
    std::sort(window.source.begin(), window.source.end());
    fill(window);
    for (const TriangleId t : window.source) in_[t] = 0;
    for (const VertexId v : window.vertex) number_[v] = kNone;
    return window;
  }

 private:
  // Other zones' holes are not to be closed here.
  void add(TriangleId t, Window& window) {
    if (t < surface_.triangles.size() || in_[t]) return;
    if (!holes_.keep[t] && !window.zone.contains(mesh_.positions[mesh_.triangles[t][0]])) return;
    in_[t] = 1;
    window.source.push_back(t);
  }

  void listVertices(Window& window) {
    for (const VertexId v : window.vertex) number_[v] = kNone;
    window.vertex.resize(surface_.positions.size());
    std::iota(window.vertex.begin(), window.vertex.end(), VertexId{0});
    for (const TriangleId t : window.source)
      for (const VertexId v : mesh_.triangles[t])
        if (v >= surface_.positions.size()) window.vertex.push_back(v);
    sortUnique(window.vertex);
    for (VertexId i = 0; i < window.vertex.size(); ++i) number_[window.vertex[i]] = i;
  }

  [[nodiscard]] Triangle renumbered(const Triangle& t) const {
    return {number_[t[0]], number_[t[1]], number_[t[2]]};
  }

  // At no vertex may the edge of the window leave parts that hang together by the vertex alone.
  void closeFans(Window& window) {
    for (std::size_t before = 0; before != window.source.size();) {
      before = window.source.size();
      listVertices(window);
      TriangleMesh kept;
      kept.positions.resize(window.vertex.size());
      kept.triangles = surface_.triangles;
      for (const TriangleId t : window.source)
        if (holes_.keep[t]) kept.triangles.push_back(renumbered(mesh_.triangles[t]));
      for (const VertexId v : pinchedVertices(kept, {}))
        for (const TriangleId t : around_.of(window.vertex[v])) add(t, window);
    }
  }

  void fill(Window& window) const {
    SweepResult& part = window.part.carried;
    const SweepResult& whole = holes_.carried;
    for (const VertexId v : window.vertex) {
      part.mesh.positions.push_back(mesh_.positions[v]);
      part.base.push_back(whole.base[v]);
      part.distance.push_back(whole.distance[v]);
      part.up.push_back(whole.up[v]);
    }
    const auto put = [&](TriangleId t) {
      part.mesh.triangles.push_back(renumbered(mesh_.triangles[t]));
      part.region.push_back(whole.region[t]);
      window.part.keep.push_back(holes_.keep[t]);
      window.part.openable.push_back(holes_.openable[t]);
      window.part.left.push_back(holes_.left[t]);
      if (!holes_.keep[t]) window.area += areaOf(mesh_.positions, mesh_.triangles[t]);
    };
    for (TriangleId t = 0; t < surface_.triangles.size(); ++t) put(t);
    for (const TriangleId t : window.source) put(t);
    fixEdge(window);
  }

  // What lies at the edge of the window stays as it is.
  static void fixEdge(Window& window) {
    SweepResult& part = window.part.carried;
    const std::vector<Triangle>& triangles = part.mesh.triangles;
    window.fixed.assign(part.mesh.positions.size(), 0);
    const HalfEdges edges(part.mesh.positions.size(), triangles);
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
  VertexTriangles around_;
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
std::vector<std::uint8_t> stillThere(const TriangleMesh& surface, const TriangleMesh& boundary,
                                     const Window& window, const Reconstruction& made) {
  const Sources sources(boundary, window);
  std::vector<std::uint8_t> is(window.source.size(), 0);
  for (std::size_t t = surface.triangles.size(); t < made.mesh.triangles.size(); ++t)
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
    for (std::size_t t = surface_.triangles.size(); t < made.region.size(); ++t) {
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

std::vector<Window> windowsOf(const TriangleMesh& surface, const Holes& holes, double r, double width,
                              int threads, std::span<const Bounds> tooNarrow) {
  const std::vector<Bounds> zones = zonesOf(holes, width, tooNarrow, threads);
  std::vector<Window> windows;
  if (zones.empty()) return windows;
  // What is near a triangle of S whose copy, or whose wall, is near the zone.
  WindowMaker maker(surface, holes, kBeyondContour * width, 2 * r + kMargin * width, threads);
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

std::optional<Reconstruction> withWindows(const TriangleMesh& surface, const Holes& holes,
                                          std::span<const Window> windows,
                                          std::span<const std::optional<Reconstruction>> made) {
  std::vector<std::uint8_t> gone(holes.keep.size(), 0);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (!made[i]) continue;
    const auto is = stillThere(surface, holes.carried.mesh, windows[i], *made[i]);
    for (std::size_t k = 0; k < is.size(); ++k) {
      if (is[k]) continue;
      // A long triangle may reach from one zone to another.
      if (std::exchange(gone[windows[i].source[k]], std::uint8_t{1})) return std::nullopt;
    }
  }
  Joiner joiner(surface, holes);
  joiner.addBoundary(gone);
  for (std::size_t i = 0; i < windows.size(); ++i)
    if (made[i]) joiner.add(windows[i], *made[i]);
  return joiner.take();
}

}  // namespace thicken
