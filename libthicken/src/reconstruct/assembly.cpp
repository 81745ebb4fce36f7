// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/assembly.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "exact/predicates.h"
#include "mesh/float_lattice.h"
#include "mesh/minimal_area.h"
#include "parallel/parallel_for.h"

namespace thicken::reconstruct {

using contour::Crossing;
using contour::DualSurface;
using contour::RimWay;
using mesh::roundToFloat;
using parallel::parallelForParts;

namespace {

class Assembler {
 public:
  Assembler(const Carrier& carrier, const DualSurface& dual, const std::vector<Crossing>& crossings,
            const std::vector<RimWay>& ways, int threads)
      : dual_(dual), crossings_(crossings), ways_(ways), threads_(threads) {
    out_.mesh = carrier.mesh;
    out_.region = carrier.region;
    out_.source = carrier.source;
    out_.firstDivided = carrier.firstDivided;
    out_.carrierVertices = carrier.mesh.positions.size();
    out_.carrierTriangles = carrier.mesh.triangles.size();
    out_.dualVertices = dual.vertexCount;
    listCarrierEdges(carrier);
  }

  Assembly run() {
    addFaces();
    for (std::size_t l = 0; l < ways_.size(); ++l) addStrip(l);
    return std::move(out_);
  }

 private:
  [[nodiscard]] VertexId id(VertexId dualVertex) const {
    return static_cast<VertexId>(out_.carrierVertices + dualVertex);
  }
  [[nodiscard]] const Vec3& at(VertexId v) const { return out_.mesh.positions[v]; }

  // A triangle of the strip beside the rim.
  void put(const Triangle& t) {
    out_.mesh.triangles.push_back(t);
    out_.region.push_back(Region::kShell);
    out_.crossing.push_back(Assembly::kStrip);
  }

  // One on every edge of the rim, and one or two beside every passage.
  [[nodiscard]] std::size_t mostStripTriangles() const {
    std::size_t most = 0;
    for (const RimWay& way : ways_)
      for (const contour::RimVisit& visit : way) most += visit.vertices.size() + 2;
    return most;
  }

  // Where the faces of a part of the crossings go: their middle vertices and their triangles.
  struct Place {
    std::size_t middles = 0, triangles = 0;
  };

  void addFaces() {
    constexpr std::size_t kPart = 1 << 12;
    const std::size_t count = crossings_.size();
    std::vector<Place> place((count + kPart - 1) / kPart + 1);
    parallelForParts(count, threads_, RunContext(), kPart,
                     [&](std::size_t part, std::size_t begin, std::size_t end) {
                       for (std::size_t c = begin; c < end; ++c)
                         pass(static_cast<std::uint32_t>(c), place[part + 1]);
                     });
    for (std::size_t part = 0; part + 1 < place.size(); ++part) {
      place[part + 1].middles += place[part].middles;
      place[part + 1].triangles += place[part].triangles;
    }
    const std::size_t triangles = out_.carrierTriangles + place.back().triangles;
    out_.mesh.positions.resize(out_.carrierVertices + dual_.vertexCount + place.back().middles);
    out_.middleOf.resize(place.back().middles);
    // Reserves room for the strips, so that adding them does not copy everything.
    const std::size_t more = mostStripTriangles();
    out_.mesh.triangles.reserve(triangles + more);
    out_.region.reserve(triangles + more);
    out_.crossing.reserve(place.back().triangles + more);
    out_.mesh.triangles.resize(triangles);
    out_.region.resize(triangles);
    out_.crossing.resize(place.back().triangles);
    parallel::parallelFor(dual_.vertexCount, threads_, RunContext(), kPart, [&](std::size_t v) {
      out_.mesh.positions[out_.carrierVertices + v] = roundToFloat(dual_.start[v]);
    });
    parallelForParts(count, threads_, RunContext(), kPart,
                     [&](std::size_t part, std::size_t begin, std::size_t end) {
                       Place at = place[part];
                       for (std::size_t c = begin; c < end; ++c) addFace(static_cast<std::uint32_t>(c), at);
                     });
  }

  // Moves `at` past the vertices and triangles that the face of a crossing takes.
  void pass(std::uint32_t c, Place& at) const {
    const bool isQuad = dual_.isQuad(c);
    at.middles += isQuad ? 0 : 1;
    at.triangles += isQuad ? 2 : dual_.faces[c].size();
  }

  void addFace(std::uint32_t c, Place& at) {
    const Region region = crossings_[c].beyond == field::Standing::kRim ? Region::kWall : Region::kShell;
    std::size_t next = at.triangles;
    const auto set = [&](const Triangle& t) {
      out_.mesh.triangles[out_.carrierTriangles + next] = t;
      out_.region[out_.carrierTriangles + next] = region;
      out_.crossing[next++] = c;
    };
    const std::span<const VertexId> f = dual_.faces[c];
    if (dual_.isQuad(c)) {
      set({id(f[0]), id(f[1]), id(f[2])});
      set({id(f[0]), id(f[2]), id(f[3])});
    } else {
      const std::size_t middle = out_.carrierVertices + dual_.vertexCount + at.middles;
      out_.mesh.positions[middle] = roundToFloat(crossings_[c].at);
      out_.middleOf[at.middles] = c;
      for (std::size_t k = 0; k < f.size(); ++k)
        set({id(f[k]), id(f[(k + 1) % f.size()]), static_cast<VertexId>(middle)});
    }
    pass(c, at);
  }

  // One rim edge from v to w and the contour's border beside it, from the vertex of v's visit to that
  // of w's: a fan at v, one triangle on the edge, a fan at w.
  void fill(VertexId v, VertexId w, const std::vector<VertexId>& chain) {
    const std::size_t n = chain.size();
    const auto area = [&](VertexId a, VertexId b, VertexId c) {
      return (at(b) - at(a)).cross(at(c) - at(a)).norm();
    };
    double behind = 0;
    for (std::size_t j = 0; j + 1 < n; ++j) behind += area(w, chain[j], chain[j + 1]);
    double least = std::numeric_limits<double>::infinity(), before = 0;
    std::size_t best = 0;
    for (std::size_t s = 0; s < n; ++s) {
      const double sum = before + area(w, v, chain[s]) + behind;
      if (sum < least) {
        least = sum;
        best = s;
      }
      if (s + 1 == n) break;
      before += area(v, chain[s], chain[s + 1]);
      behind -= area(w, chain[s], chain[s + 1]);
    }
    for (std::size_t j = 0; j < best; ++j) put({v, chain[j], chain[j + 1]});
    put({w, v, chain[best]});
    for (std::size_t j = best; j + 1 < n; ++j) put({w, chain[j], chain[j + 1]});
  }

  // Whether a fan around `own` does not turn over.
  [[nodiscard]] bool isStar(std::span<const std::pair<VertexId, std::size_t>> rim, VertexId own) const {
    std::vector<Vec3> normals;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      normals.push_back((at(rim[i].first) - at(own)).cross(at(rim[i + 1].first) - at(own)));
      sum += normals.back();
    }
    return std::all_of(normals.begin(), normals.end(), [&](const Vec3& n) { return n.dot(sum) > 0; });
  }

  // The rim's vertices in one cell and the cell's own vertex. Where the rim zigzags within the cell no fan
  // of triangles is clear of itself, but the triangulation of least area cuts the zigzags off.
  bool fan(std::span<const std::pair<VertexId, std::size_t>> rim, VertexId own) {
    constexpr std::size_t kLongest = 48;
    if (rim.size() > kLongest || isStar(rim, own)) return false;
    std::vector<VertexId> loop{own};
    for (std::size_t i = rim.size(); i-- > 0;) loop.push_back(rim[i].first);
    const auto triangles = mesh::minimalAreaTriangulation(
        out_.mesh.positions, loop, carrierEdges_,
        [&](const Triangle& t) { return !exact::collinear(at(t[0]), at(t[1]), at(t[2])); });
    for (const Triangle& t : triangles) put(t);
    return !triangles.empty();
  }

  // Chords that the triangulation must not use a second time.
  void listCarrierEdges(const Carrier& carrier) {
    std::vector<std::uint8_t> onRim(carrier.mesh.positions.size(), 0);
    for (const mesh::RimEdge& e : carrier.rim.edges) onRim[e.from] = 1;
    for (const Triangle& t : carrier.mesh.triangles)
      for (int k = 0; k < 3; ++k) {
        const VertexId a = t[k], b = t[(k + 1) % 3];
        if (onRim[a] && onRim[b]) carrierEdges_.insert(mesh::edgeKey(a, b));
      }
  }

  void addStrip(std::size_t l) {
    const RimWay& way = ways_[l];
    const auto& stops = dual_.stops[l];
    std::vector<std::pair<VertexId, std::size_t>> rim;  // vertex, its visit
    for (std::size_t i = 0; i < way.size(); ++i)
      for (const VertexId v : way[i].vertices) rim.emplace_back(v, i);
    for (std::size_t e = 0; e < rim.size(); ++e) {
      std::size_t end = e;
      while (end + 1 < rim.size() && rim[end + 1].second == rim[e].second) ++end;
      if (end > e + 1 && fan(std::span(rim).subspan(e, end - e + 1), id(stops[rim[e].second].vertex)))
        e = end;
      const auto& [v, from] = rim[e];
      const bool last = e + 1 == rim.size();
      const auto& [w, visit] = rim[last ? 0 : e + 1];
      std::size_t to = visit;
      if (last && way.size() > 1) to += way.size();
      std::vector<VertexId> chain{id(stops[from].vertex)};
      for (std::size_t i = from; i < to; ++i) {
        const auto& stop = stops[i % way.size()];
        if (stop.onExit != mesh::kNone) chain.push_back(id(stop.onExit));
        chain.push_back(id(stops[(i + 1) % way.size()].vertex));
      }
      fill(v, w, chain);
    }
  }

  const DualSurface& dual_;
  const std::vector<Crossing>& crossings_;
  const std::vector<RimWay>& ways_;
  int threads_;
  mesh::EdgeSet carrierEdges_;
  Assembly out_;
};

}  // namespace

Assembly assemble(const Carrier& carrier, const DualSurface& dual, const std::vector<Crossing>& crossings,
                  const std::vector<RimWay>& ways, int threads) {
  return Assembler(carrier, dual, crossings, ways, threads).run();
}

}  // namespace thicken::reconstruct
