// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/patch_shape.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "mesh/topology.h"

namespace thicken::repairing {

using mesh::edgeKey;
using mesh::kNone;

namespace {

constexpr int kMostRounds = 32;
constexpr double kReach = 1.4142135623730951;  // Liepa's density factor

VertexId cornerBeside(const Triangle& t, VertexId a, VertexId b) {
  for (const VertexId v : t)
    if (v != a && v != b) return v;
  return kNone;
}

Vec3 normalOf(const std::vector<Vec3>& at, const Triangle& t) {
  return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]);
}

double angleAt(const Vec3& apex, const Vec3& p, const Vec3& q) {
  const Vec3 u = p - apex, v = q - apex;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

PatchShape::PatchShape(std::vector<Vec3>& positions, std::vector<Triangle> triangles,
                       const std::unordered_map<VertexId, double>& size, const mesh::EdgeSet& taken)
    : at_(positions),
      triangles_(std::move(triangles)),
      size_(size),
      taken_(taken),
      firstOwn_(static_cast<VertexId>(positions.size())) {}

void PatchShape::mapEdges() {
  edges_.clear();
  for (TriangleId t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [it, fresh] =
          edges_.try_emplace(edgeKey(triangles_[t][k], triangles_[t][(k + 1) % 3]), std::array{t, kNone});
      if (!fresh) it->second[1] = t;
    }
}

void PatchShape::refine(std::size_t most) {
  for (int round = 0; round < kMostRounds; ++round) {
    turnEdges();
    if (!divideLarge(most)) return;
  }
}

bool PatchShape::divideLarge(std::size_t most) {
  bool any = false;
  const std::size_t count = triangles_.size();
  for (std::size_t t = 0; t < count && triangles_.size() + 2 <= most; ++t) {
    const Triangle c = triangles_[t];
    const Vec3 middle = (at_[c[0]] + at_[c[1]] + at_[c[2]]) / 3;
    const double size = (size_.at(c[0]) + size_.at(c[1]) + size_.at(c[2])) / 3;
    const bool isLarge = std::all_of(c.begin(), c.end(), [&](VertexId v) {
      return kReach * (middle - at_[v]).norm() > std::max(size, size_.at(v));
    });
    if (!isLarge) continue;
    const auto v = static_cast<VertexId>(at_.size());
    at_.push_back(middle);
    size_[v] = size;
    triangles_[t] = {c[0], c[1], v};
    triangles_.push_back({c[1], c[2], v});
    triangles_.push_back({c[2], c[0], v});
    any = true;
  }
  return any;
}

void PatchShape::turnEdges() {
  for (int round = 0; round < kMostRounds; ++round) {
    mapEdges();
    std::vector<std::pair<std::uint64_t, std::array<TriangleId, 2>>> inner;
    for (const auto& edge : edges_)
      if (edge.second[1] != kNone) inner.push_back(edge);
    std::sort(inner.begin(), inner.end());
    std::set<TriangleId> changed;
    for (const auto& [edge, sides] : inner) {
      if (changed.count(sides[0]) + changed.count(sides[1]) > 0) continue;
      const auto a = static_cast<VertexId>(edge >> 32), b = static_cast<VertexId>(edge & 0xffffffffu);
      if (turn(a, b, sides[0], sides[1])) changed.insert(sides.begin(), sides.end());
    }
    if (changed.empty()) return;
  }
}

bool PatchShape::turn(VertexId a, VertexId b, TriangleId t, TriangleId u) {
  const VertexId c = cornerBeside(triangles_[t], a, b), d = cornerBeside(triangles_[u], a, b);
  constexpr double kHalfTurn = 3.141592653589793, kRounding = 1e-9;
  if (c == d || angleAt(at_[c], at_[a], at_[b]) + angleAt(at_[d], at_[a], at_[b]) < kHalfTurn + kRounding)
    return false;
  if (edges_.count(edgeKey(c, d)) + taken_.count(edgeKey(c, d)) > 0) return false;
  const Triangle& old = triangles_[t];
  for (int k = 0; k < 3; ++k)
    if (old[k] == b && old[(k + 1) % 3] == a) std::swap(a, b);  // t runs from a to b
  const Triangle first{a, d, c}, second{d, b, c};
  const Vec3 normal = normalOf(at_, triangles_[t]) + normalOf(at_, triangles_[u]);
  if (normalOf(at_, first).dot(normal) <= 0 || normalOf(at_, second).dot(normal) <= 0) return false;
  edges_.erase(edgeKey(a, b));
  edges_[edgeKey(c, d)] = {t, u};
  triangles_[t] = first;
  triangles_[u] = second;
  return true;
}

void PatchShape::fair(const std::unordered_map<VertexId, std::vector<VertexId>>& beside) {
  const auto own = static_cast<Eigen::Index>(at_.size() - firstOwn_);
  if (own == 0) return;
  std::unordered_map<VertexId, std::set<VertexId>> around;
  for (const Triangle& t : triangles_)
    for (int k = 0; k < 3; ++k) {
      around[t[k]].insert(t[(k + 1) % 3]);
      around[t[(k + 1) % 3]].insert(t[k]);
    }
  for (const auto& [v, others] : beside) around[v].insert(others.begin(), others.end());
  std::vector<VertexId> rows;
  for (const auto& entry : around) rows.push_back(entry.first);
  std::sort(rows.begin(), rows.end());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d known = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto put = [&](VertexId v, double weight) {
      if (isOwn(v))
        entries.emplace_back(row, static_cast<Eigen::Index>(v - firstOwn_), weight);
      else
        known.row(row) -= weight * at_[v].transpose();
    };
    const auto& others = around[rows[i]];
    put(rows[i], 1);
    for (const VertexId v : others) put(v, -1 / static_cast<double>(others.size()));
  }
  Eigen::SparseMatrix<double> bend(static_cast<Eigen::Index>(rows.size()), own);
  bend.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(bend.transpose() * bend);
  if (solver.info() != Eigen::Success) return;
  const Eigen::MatrixX3d solved = solver.solve(bend.transpose() * known);
  if (!solved.allFinite()) return;
  for (Eigen::Index v = 0; v < own; ++v) at_[firstOwn_ + static_cast<VertexId>(v)] = solved.row(v);
}

}  // namespace thicken::repairing
