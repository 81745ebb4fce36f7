// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/carrier.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/measure.h"
#include "mesh/float_lattice.h"
#include "mesh/half_edges.h"
#include "mesh/normals.h"
#include "thicken/error.h"

namespace thicken::reconstruct {

using mesh::Rim;
using mesh::RimEdge;
using mesh::vertexTriangles;

namespace {

std::vector<Triangle> keptTriangles(const TriangleMesh& mesh, std::span<const std::uint8_t> keep) {
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (keep[t]) kept.push_back(mesh.triangles[t]);
  return kept;
}

// The rim without the loops at the edge of a window.
Rim withoutCut(const Rim& rim, const Cut* cut) {
  if (cut == nullptr) return rim;
  Rim own;
  own.loopStart.push_back(0);
  for (std::size_t l = 0; l < rim.loops(); ++l) {
    const auto loop = std::span(rim.edges).subspan(rim.loopStart[l], rim.loopStart[l + 1] - rim.loopStart[l]);
    const auto cuts = std::count_if(loop.begin(), loop.end(), [&](const RimEdge& e) {
      return std::binary_search(cut->edges.begin(), cut->edges.end(), Cut::Edge{e.from, e.to});
    });
    if (cuts == static_cast<std::ptrdiff_t>(loop.size())) continue;
    if (cuts > 0) throw Error(ErrorCode::kNoSolid, "a hole reaches the edge of its window");
    own.edges.insert(own.edges.end(), loop.begin(), loop.end());
    own.loopStart.push_back(static_cast<std::uint32_t>(own.edges.size()));
  }
  return own;
}

// Replaces a triangle by the fans that the points on its edges call for.
class RimDivider {
 public:
  RimDivider(Carrier& carrier, double longest) : carrier_(carrier), longest_(longest) {}

  void divide(TriangleId t, std::array<bool, 3> onRim) {
    std::array<std::vector<VertexId>, 3> points;
    const Triangle corners = carrier_.mesh.triangles[t];
    bool any = false;
    for (int k = 0; k < 3; ++k) {
      if (onRim[k]) points[k] = pointsBetween(corners[k], corners[(k + 1) % 3]);
      any |= !points[k].empty();
    }
    if (!any) return;
    first_ = true;
    place_ = t;
    emit(corners, points);
  }

 private:
  std::vector<VertexId> pointsBetween(VertexId a, VertexId b) {
    const Vec3 from = carrier_.mesh.positions[a], to = carrier_.mesh.positions[b];
    const int parts = static_cast<int>(std::ceil((to - from).norm() / longest_));
    std::vector<VertexId> ids;
    Vec3 last = from;
    for (int i = 1; i < parts; ++i) {
      const Vec3 p = mesh::roundToFloat(from + (double(i) / parts) * (to - from));
      if (p == last || p == to) continue;
      last = p;
      ids.push_back(static_cast<VertexId>(carrier_.mesh.positions.size()));
      carrier_.mesh.positions.push_back(p);
      carrier_.up.push_back(upBetween(a, b, double(i) / parts));
    }
    return ids;
  }

  [[nodiscard]] Vec3 upBetween(VertexId a, VertexId b, double share) const {
    const Vec3 &from = carrier_.up[a], &to = carrier_.up[b];
    return from.isZero(0) || to.isZero(0) ? Vec3(Vec3::Zero()) : Vec3(from + share * (to - from));
  }

  // Fans out one divided edge; the two outer triangles hold what else is divided.
  void emit(const Triangle& t, const std::array<std::vector<VertexId>, 3>& points) {
    for (int k = 0; k < 3; ++k) {
      if (points[k].empty()) continue;
      const VertexId a = t[k], b = t[(k + 1) % 3], apex = t[(k + 2) % 3];
      const std::vector<VertexId>& p = points[k];
      emit({a, p.front(), apex}, {{{}, {}, points[(k + 2) % 3]}});
      for (std::size_t i = 0; i + 1 < p.size(); ++i) put({p[i], p[i + 1], apex});
      emit({p.back(), b, apex}, {{{}, points[(k + 1) % 3], {}}});
      return;
    }
    put(t);
  }

  void put(const Triangle& t) {
    if (first_) {
      carrier_.mesh.triangles[place_] = t;
      first_ = false;
      return;
    }
    carrier_.mesh.triangles.push_back(t);
    carrier_.region.push_back(carrier_.region[place_]);
    carrier_.source.push_back(carrier_.source[place_]);
  }

  Carrier& carrier_;
  double longest_;
  bool first_ = true;
  TriangleId place_ = 0;
};

}  // namespace

std::vector<VertexId> nonManifoldVertices(const TriangleMesh& mesh, std::span<const std::uint8_t> keep) {
  const mesh::HalfEdges edges(mesh.positions.size(), mesh.triangles, keep);
  std::vector<std::uint8_t> rimEdges(mesh.positions.size(), 0);
  std::vector<VertexId> nonManifold;
  edges.forEachEdge([&](VertexId a, VertexId b, auto forth, auto back) {
    if (forth.size() + back.size() != 1) return;
    const VertexId from = forth.empty() ? b : a;
    if (rimEdges[from] < 2 && ++rimEdges[from] == 2) nonManifold.push_back(from);
  });
  return nonManifold;
}

void closeFans(const TriangleMesh& swept, std::vector<std::uint8_t>& keep) {
  const auto around = vertexTriangles(swept.positions.size(), swept.triangles);
  for (bool grown = true; grown;) {
    grown = false;
    for (const VertexId v : nonManifoldVertices(swept, keep))
      for (const TriangleId t : around.of(v)) {
        grown |= keep[t] == 0;
        keep[t] = 1;
      }
  }
}

void openFans(const TriangleMesh& swept, std::span<const std::uint8_t> openable,
              std::vector<std::uint8_t>& keep) {
  const auto around = vertexTriangles(swept.positions.size(), swept.triangles);
  for (bool shrunk = true; shrunk;) {
    shrunk = false;
    for (const VertexId v : nonManifoldVertices(swept, keep))
      for (const TriangleId t : around.of(v)) {
        if (!keep[t] || !openable[t]) continue;
        shrunk = true;
        keep[t] = 0;
      }
  }
}

void trimSpikes(const TriangleMesh& swept, std::span<const std::uint8_t> openable, double largest,
                std::vector<std::uint8_t>& keep) {
  constexpr int kRounds = 3;
  constexpr double kSharp = 2;  // radians
  const auto around = vertexTriangles(swept.positions.size(), swept.triangles);
  const auto angleAt = [&](const Triangle& t, VertexId v) {
    return mesh::cornerAngle(swept.positions, t, t[0] == v ? 0 : t[1] == v ? 1 : 2);
  };
  for (int round = 0; round < kRounds; ++round) {
    std::vector<TriangleId> spikes;
    for (VertexId v = 0; v < swept.positions.size(); ++v) {
      double angle = 0;
      bool anyKept = false, anyGone = false, isFree = true;
      for (const TriangleId t : around.of(v)) {
        isFree &= openable[t] != 0;
        if (!keep[t]) {
          anyGone = true;
          continue;
        }
        anyKept = true;
        isFree &= measure::areaOf(swept.positions, swept.triangles[t]) <= largest;
        angle += angleAt(swept.triangles[t], v);
      }
      if (!isFree || !anyKept || !anyGone || angle > kSharp) continue;
      for (const TriangleId t : around.of(v))
        if (keep[t]) spikes.push_back(t);
    }
    if (spikes.empty()) return;
    for (const TriangleId t : spikes) keep[t] = 0;
  }
}

Carrier makeCarrier(const sweep::SweepResult& swept, std::span<const Vec3> positions, std::vector<Vec3> up,
                    std::size_t surfaceTriangles, std::span<const std::uint8_t> keep, double longest,
                    const Cut* cut, int threads) {
  Carrier carrier;
  carrier.up = std::move(up);
  carrier.firstDivided = static_cast<VertexId>(positions.size());
  carrier.mesh.positions.assign(positions.begin(), positions.end());
  carrier.mesh.triangles = keptTriangles(swept.mesh, keep);
  for (TriangleId t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    carrier.region.push_back(swept.region[t]);
    carrier.source.push_back(t);
  }
  const auto rimNow = [&] {
    return withoutCut(mesh::rimOf(carrier.mesh.positions.size(), carrier.mesh.triangles, threads), cut);
  };
  const Rim rim = rimNow();
  std::vector<std::array<bool, 3>> onRim(carrier.mesh.triangles.size(), {false, false, false});
  for (const RimEdge& e : rim.edges)
    for (int k = 0; k < 3; ++k)
      if (carrier.mesh.triangles[e.triangle][k] == e.from) onRim[e.triangle][k] = true;
  RimDivider divider(carrier, longest);
  for (std::size_t t = surfaceTriangles; t < onRim.size(); ++t)
    divider.divide(static_cast<TriangleId>(t), onRim[t]);
  carrier.rim = rimNow();
  return carrier;
}

}  // namespace thicken::reconstruct
