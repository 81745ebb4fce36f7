// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/holes.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "exact/predicates.h"
#include "mesh/float_lattice.h"
#include "mesh/minimal_area.h"
#include "repair/open_rims.h"
#include "repair/patch_shape.h"

namespace thicken::repairing {
namespace {

// A patch of a short rim with very small edges beside it is not divided further than this.
constexpr std::size_t kMostTriangles = 100'000;

class Filling {
 public:
  Filling(Workpiece& piece, AddedFacts& facts, int threads)
      : piece_(piece),
        facts_(facts),
        rim_(openRimsOf(piece, threads)),
        additions_(piece, threads),
        around_(mesh::vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles)),
        lattice_(piece.mesh.positions) {}

  void run(double longest, const RunContext& context) {
    for (std::size_t i = 0; i < rim_.loops(); ++i) {
      context.throwIfCancelled();
      // against the direction of the surface's triangles, which is that of the patch
      std::vector<VertexId> loop;
      double length = 0;
      for (std::uint32_t e = rim_.loopStart[i + 1]; e-- > rim_.loopStart[i];) {
        loop.push_back(rim_.edges[e].to);
        length += (at()[rim_.edges[e].from] - at()[rim_.edges[e].to]).norm();
      }
      if (length >= longest) continue;
      if (fill(loop)) {
        ++facts_.holes;
        continue;
      }
      ++facts_.left;
      if (facts_.leftPlaces.size() < AddedFacts::kMaxPlaces) facts_.leftPlaces.push_back(at()[loop.front()]);
    }
  }

 private:
  [[nodiscard]] std::vector<Vec3>& at() { return piece_.mesh.positions; }

  bool fill(const std::vector<VertexId>& loop) {
    surroundings(loop);
    mesh::EdgeSet taken;
    for (const auto& [v, others] : beside_)
      for (const VertexId w : others) taken.insert(mesh::edgeKey(v, w));
    const auto hasArea = [&](const Triangle& t) {
      return !exact::collinear(at()[t[0]], at()[t[1]], at()[t[2]]);
    };
    const std::vector<Triangle> plain = mesh::minimalAreaTriangulation(at(), loop, taken, hasArea);
    if (plain.empty()) return false;
    const std::size_t before = at().size();
    for (const bool fair : {true, false}) {
      PatchShape shape(at(), plain, size_, taken);
      shape.refine(kMostTriangles);
      if (fair) shape.fair(beside_);
      for (std::size_t v = before; v < at().size(); ++v) at()[v] = lattice_.nearest(at()[v]);
      if (additions_.fits(shape.triangles())) {
        additions_.add(shape.triangles(), RepairKind::kFilled);
        return true;
      }
      at().resize(before);
    }
    if (!additions_.fits(plain)) return false;
    additions_.add(plain, RepairKind::kFilled);
    return true;
  }

  // Around each corner of the loop: what it shares edges with, and how long these are.
  void surroundings(const std::vector<VertexId>& loop) {
    beside_.clear();
    size_.clear();
    for (const VertexId v : loop) {
      auto& others = beside_[v];
      for (const TriangleId t : around_.of(v))
        if (piece_.present[t] != 0)
          for (const VertexId w : piece_.mesh.triangles[t])
            if (w != v && std::find(others.begin(), others.end(), w) == others.end()) others.push_back(w);
      double sum = 0;
      for (const VertexId w : others) sum += (at()[v] - at()[w]).norm();
      size_[v] = sum / static_cast<double>(others.size());
    }
  }

  Workpiece& piece_;
  AddedFacts& facts_;
  mesh::Rim rim_;
  Additions additions_;
  mesh::VertexTriangles around_;  // of what was there before
  mesh::Lattice lattice_;
  std::unordered_map<VertexId, std::vector<VertexId>> beside_;
  std::unordered_map<VertexId, double> size_;  // mm
};

}  // namespace

void fillHoles(Workpiece& piece, double longest, AddedFacts& facts, const RunContext& context, int threads) {
  Filling(piece, facts, threads).run(longest, context);
}

}  // namespace thicken::repairing
