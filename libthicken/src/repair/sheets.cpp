// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "mesh/half_edges.h"
#include "mesh/union_find.h"

namespace thicken::repairing {

using mesh::HalfEdge;
using mesh::UnionFind;

namespace {

constexpr double kSameBend = 15.0 / 180 * 3.14159265358979323846;
constexpr double kRightAngle = 0.5 * 3.14159265358979323846;

using SlotPair = std::array<std::uint32_t, 2>;

class SheetFinder {
 public:
  explicit SheetFinder(const Workpiece& piece) : piece_(piece), patches_(piece.mesh.triangles.size()) {}

  Sheets run() {
    findEdges();
    const std::vector<double> patchArea = areasOf(patches_);
    sumBends();
    UnionFind sheets = patches_;
    std::vector<std::vector<SlotPair>> pairs;
    for (const NonManifoldEdge& edge : result_.edges) {
      pairs.push_back(pairedUp(edge, patchArea));
      for (const SlotPair& p : pairs.back())
        if (bendOf(p) < kRightAngle) sheets.join(p[0] / 3, p[1] / 3);
    }
    const std::vector<double> sheetArea = areasOf(sheets);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      result_.edges[i].through =
          *std::max_element(pairs[i].begin(), pairs[i].end(), [&](const SlotPair& a, const SlotPair& b) {
            return sizeOf(a, sheets, sheetArea) < sizeOf(b, sheets, sheetArea);
          });
    result_.areaAt.resize(piece_.mesh.triangles.size());
    result_.sheetOf = sheets.roots(1);
    for (TriangleId t = 0; t < result_.areaAt.size(); ++t) result_.areaAt[t] = sheetArea[sheets.root(t)];
    return std::move(result_);
  }

 private:
  void findEdges() {
    const mesh::HalfEdges edges(piece_.mesh.positions.size(), piece_.mesh.triangles, piece_.present);
    edges.forEachEdge(
        [&](VertexId, VertexId, std::span<const HalfEdge> uses, std::span<const HalfEdge> back) {
          if (uses.size() + back.size() < 2) return;
          NonManifoldEdge edge;
          for (const auto& list : {uses, back})
            for (const HalfEdge& e : list) edge.slots.push_back(e.slot);
          if (edge.slots.size() == 2)
            patches_.join(edge.slots[0] / 3, edge.slots[1] / 3);
          else
            result_.edges.push_back(std::move(edge));
        });
  }

  [[nodiscard]] std::vector<double> areasOf(UnionFind& groups) const {
    std::vector<double> area(piece_.mesh.triangles.size(), 0);
    for (TriangleId t = 0; t < area.size(); ++t)
      if (piece_.present[t] != 0) area[groups.root(t)] += piece_.area(t);
    return area;
  }

  // From the edge into the triangle, at right angles to the edge.
  [[nodiscard]] Vec3 inwardOf(std::uint32_t slot) const {
    const Triangle& c = piece_.mesh.triangles[slot / 3];
    const auto& p = piece_.mesh.positions;
    const Vec3& a = p[c[slot % 3]];
    const Vec3 along = (p[c[(slot % 3 + 1) % 3]] - a).normalized(), up = p[c[(slot % 3 + 2) % 3]] - a;
    return (up - up.dot(along) * along).normalized();
  }
  [[nodiscard]] double lengthOf(std::uint32_t slot) const {
    const Triangle& c = piece_.mesh.triangles[slot / 3];
    return (piece_.mesh.positions[c[slot % 3]] - piece_.mesh.positions[c[(slot % 3 + 1) % 3]]).norm();
  }

  [[nodiscard]] VertexId startOf(std::uint32_t slot) const {
    return piece_.mesh.triangles[slot / 3][slot % 3];
  }

  using PatchPair = std::pair<std::uint32_t, std::uint32_t>;
  [[nodiscard]] PatchPair patchesOf(const SlotPair& p) {
    return std::minmax(patches_.root(p[0] / 3), patches_.root(p[1] / 3));
  }

  template <class Visit>
  static void forEachPair(const NonManifoldEdge& edge, Visit visit) {
    for (std::size_t i = 0; i < edge.slots.size(); ++i)
      for (std::size_t k = i + 1; k < edge.slots.size(); ++k) visit(SlotPair{edge.slots[i], edge.slots[k]});
  }

  // The mean angle between the patches' planes over the edges that they share, by length.
  void sumBends() {
    for (const NonManifoldEdge& edge : result_.edges) {
      const double length = lengthOf(edge.slots[0]);
      forEachPair(edge, [&](const SlotPair& p) {
        const double cosine = std::clamp(-inwardOf(p[0]).dot(inwardOf(p[1])), -1.0, 1.0);
        auto& [sum, lengths] = bends_[patchesOf(p)];
        sum += length * std::acos(cosine);
        lengths += length;
      });
    }
  }
  [[nodiscard]] double bendOf(const SlotPair& p) {
    const auto& [sum, lengths] = bends_.at(patchesOf(p));
    return lengths > 0 ? sum / lengths : 0;
  }

  [[nodiscard]] double sizeOf(const SlotPair& p, UnionFind& groups, const std::vector<double>& area) const {
    return std::max(area[groups.root(p[0] / 3)], area[groups.root(p[1] / 3)]);
  }

  std::vector<SlotPair> pairedUp(const NonManifoldEdge& edge, const std::vector<double>& patchArea) {
    std::vector<std::tuple<double, bool, double, SlotPair>> open;  // bend, one sense, area of both, who
    forEachPair(edge, [&](const SlotPair& p) {
      const double area = patchArea[patches_.root(p[0] / 3)] + patchArea[patches_.root(p[1] / 3)];
      open.emplace_back(bendOf(p), startOf(p[0]) != startOf(p[1]), area, p);
    });
    std::vector<SlotPair> pairs;
    while (!open.empty()) {
      const double least = std::get<0>(*std::min_element(open.begin(), open.end()));
      const auto worse = [&](const auto& a, const auto& b) {
        const bool aFar = std::get<0>(a) > least + kSameBend, bFar = std::get<0>(b) > least + kSameBend;
        if (aFar != bFar) return aFar;
        return std::pair(std::get<1>(a), std::get<2>(a)) < std::pair(std::get<1>(b), std::get<2>(b));
      };
      const SlotPair best = std::get<3>(*std::max_element(open.begin(), open.end(), worse));
      pairs.push_back(best);
      std::erase_if(open, [&](const auto& entry) {
        const SlotPair& p = std::get<3>(entry);
        return p[0] == best[0] || p[0] == best[1] || p[1] == best[0] || p[1] == best[1];
      });
    }
    return pairs;
  }

  const Workpiece& piece_;
  UnionFind patches_;  // triangles joined across edges of exactly two
  std::map<PatchPair, std::pair<double, double>> bends_;
  Sheets result_;
};

}  // namespace

Sheets sheetsOf(const Workpiece& piece) {
  return SheetFinder(piece).run();
}

}  // namespace thicken::repairing
