// SPDX-License-Identifier: LGPL-2.1-or-later
#include "trim/parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "thicken/check.h"
#include "trim/trim_line_error.h"

namespace thicken::trimming {

using mesh::kNone;

Parts::Parts(const DividedSurface& surface, const PathMarks& marks,
             const std::vector<std::vector<VertexId>>& paths)
    : surface_(surface), partOf_(surface.triangles().size(), kNone) {
  for (TriangleId t = 0; t < partOf_.size(); ++t) {
    if (partOf_[t] != kNone) continue;
    area_.push_back(0);
    rim_.push_back(0);
    fill(t, static_cast<std::uint32_t>(area_.size() - 1), marks);
  }
  for (const std::vector<VertexId>& path : paths) {
    left_.emplace_back();
    right_.emplace_back();
    place_.push_back(surface.at(path.front()));
    for (std::size_t i = 0; i < path.size(); ++i) {
      const VertexId a = path[i], b = path[(i + 1) % path.size()];
      const EdgeOf edge = surface.edgeBetween(a, b);
      const TriangleId one = edge.triangle, other = surface.across(edge);
      const bool forward = surface.from(edge) == a;
      if (one != kNone) (forward ? left_ : right_).back().insert(partOf_[one]);
      if (other != kNone) (forward ? right_ : left_).back().insert(partOf_[other]);
    }
  }
}

void Parts::fill(TriangleId start, std::uint32_t part, const PathMarks& marks) {
  std::vector<TriangleId> waiting{start};
  partOf_[start] = part;
  while (!waiting.empty()) {
    const TriangleId t = waiting.back();
    waiting.pop_back();
    const auto& [a, b, c] = surface_.triangles()[t];
    area_[part] += (surface_.at(b) - surface_.at(a)).cross(surface_.at(c) - surface_.at(a)).norm() / 2;
    for (int k = 0; k < 3; ++k) {
      const EdgeOf edge{t, k};
      const TriangleId next = surface_.across(edge);
      if (next == kNone)
        rim_[part] += (surface_.at(surface_.from(edge)) - surface_.at(surface_.to(edge))).norm();
      if (next == kNone || partOf_[next] != kNone || marks.hasEdge(surface_.from(edge), surface_.to(edge)))
        continue;
      partOf_[next] = part;
      waiting.push_back(next);
    }
  }
}

std::uint32_t Parts::inside() const {
  std::optional<std::uint32_t> best;
  for (std::uint32_t part = 0; part < area_.size(); ++part)
    if (loopsAwayFrom(part).empty() &&
        (!best || std::pair(rim_[part], area_[part]) < std::pair(rim_[*best], area_[*best])))
      best = part;
  if (!best)
    throw trimLineError(
        "no part of the surface lies beside all of the loops; say which one stays, by a point of it",
        place_.front());
  return *best;
}

std::vector<std::size_t> Parts::loopsWithin(std::uint32_t part) const {
  std::vector<std::size_t> loops;
  for (std::size_t i = 0; i < left_.size(); ++i)
    if (left_[i].count(part) != 0 && right_[i].count(part) != 0) loops.push_back(i);
  return loops;
}

std::vector<std::size_t> Parts::loopsAwayFrom(std::uint32_t part) const {
  std::vector<std::size_t> loops;
  for (std::size_t i = 0; i < left_.size(); ++i)
    if (left_[i].count(part) == 0 && right_[i].count(part) == 0) loops.push_back(i);
  return loops;
}

void Parts::extract(std::uint32_t part, TrimmedSurface& result) const {
  TriangleMesh piece;
  piece.positions = surface_.positions();
  for (const bool divided : {false, true}) {
    for (TriangleId t = 0; t < partOf_.size(); ++t) {
      if (partOf_[t] != part || surface_.isDivided(surface_.originOf(t)) != divided) continue;
      piece.triangles.push_back(surface_.triangles()[t]);
      result.origin.push_back(surface_.originOf(t));
    }
    if (!divided) result.facts.untouched = piece.triangles.size();
  }
  result.facts.divided = piece.triangles.size() - result.facts.untouched;
  result.mesh = weld(piece);
}

}  // namespace thicken::trimming
