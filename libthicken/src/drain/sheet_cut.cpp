// SPDX-License-Identifier: LGPL-2.1-or-later
#include "drain/sheet_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/edge_key.h"
#include "mesh/float_lattice.h"

namespace thicken::drain {

using mesh::directedKey;

namespace {

// Twice the signed area of a triangle in the first two coordinates.
double doubledArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double flatDistance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// Whether all of `points` are on the right of the line from a to b, by more than `margin`.
template <class Points>
bool allRight(const Vec3& a, const Vec3& b, const Points& points, double margin) {
  const double limit = -margin * flatDistance(a, b);
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return doubledArea(a, b, p) < limit; });
}

}  // namespace

Frame::Frame(const Vec3& at, const Vec3& axis) : origin(at), w(axis.normalized()) {
  int least = 0;
  w.cwiseAbs().minCoeff(&least);
  u = w.cross(Vec3::Unit(least)).normalized();
  v = w.cross(u);
}

SheetCutter::SheetCutter(std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                         const std::vector<std::array<TriangleId, 3>>& across, const Frame& frame,
                         const std::vector<Vec3>& corners, bool upward)
    : positions_(positions),
      triangles_(triangles),
      across_(across),
      frame_(frame),
      corners_(corners),
      mirror_(upward ? 1 : -1) {
  if (!upward) {
    for (Vec3& c : corners_) c[1] = -c[1];
    std::reverse(corners_.begin(), corners_.end());
  }
  double radius = 0, farthest = 0;
  for (const Vec3& c : corners) radius = std::max(radius, std::hypot(c[0], c[1]));
  for (int k = 0; k < 3; ++k) farthest = std::max(farthest, std::abs(frame.origin[k]) + radius);
  // Above what rounding to float moves a vertex by, and below what anybody sees.
  constexpr double kFloatSteps = 16, kFloatStep = 6e-8, kShareOfRadius = 2e-4;
  near_ = std::max(kShareOfRadius * radius, kFloatSteps * kFloatStep * farthest);
}

const Vec3& SheetCutter::at(VertexId v) {
  const auto [entry, fresh] = local_.try_emplace(v);
  if (fresh) {
    entry->second = frame_.local(positions_[v]);
    entry->second[1] *= mirror_;
  }
  return entry->second;
}

double SheetCutter::area(VertexId a, VertexId b, VertexId c) {
  // Copies: a look-up may move what an earlier one returned.
  const Vec3 p = at(a), q = at(b), r = at(c);
  return doubledArea(p, q, r);
}

bool SheetCutter::touchesOutline(const Triangle& t) const {
  std::array<Vec3, 3> corner;
  for (int k = 0; k < 3; ++k) {
    corner[k] = frame_.local(positions_[t[k]]);
    corner[k][1] *= mirror_;
  }
  const double sense = doubledArea(corner[0], corner[1], corner[2]) < 0 ? -1 : 1;
  if (sense < 0) std::swap(corner[1], corner[2]);
  for (int k = 0; k < 3; ++k)
    if (allRight(corner[k], corner[(k + 1) % 3], corners_, 4 * near_)) return false;
  for (std::size_t k = 0; k < corners_.size(); ++k)
    if (allRight(corners_[k], corners_[(k + 1) % corners_.size()], corner, 4 * near_)) return false;
  return true;
}

void SheetCutter::gather(TriangleId start, SheetCut& result) {
  // Steeper triangles than this against the axis would make a slit of the hole's end.
  constexpr double kLeastCosine = 0.1;
  std::unordered_set<TriangleId> seen{start};
  std::vector<TriangleId> waiting{start};
  while (!waiting.empty()) {
    const TriangleId t = waiting.back();
    waiting.pop_back();
    const auto& [a, b, c] = triangles_[t];
    const Vec3 normal = (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]);
    if (mirror_ * normal.dot(frame_.w) <= kLeastCosine * normal.norm())
      throw TooSteep("the surface is too steep there or folds back within the hole");
    result.replaced.push_back(t);
    patch_.push_back(triangles_[t]);
    for (const TriangleId next : across_[t])
      if (next != mesh::kNone && touchesOutline(triangles_[next]) && seen.insert(next).second)
        waiting.push_back(next);
  }
  std::sort(result.replaced.begin(), result.replaced.end());
  patch_.clear();
  for (const TriangleId t : result.replaced) patch_.push_back(triangles_[t]);
}

VertexId SheetCutter::addVertex(const Vec3& local) {
  const auto id = static_cast<VertexId>(positions_.size());
  positions_.push_back(mesh::roundToFloat(frame_.global({local[0], mirror_ * local[1], local[2]})));
  return id;
}

void SheetCutter::requirePositive(const Triangle& t) {
  if (!(area(t[0], t[1], t[2]) > 0))
    throw CannotCut("the triangles are too small or too narrow there for the precision of the file");
}

void SheetCutter::replace(std::size_t index, const Triangle& t) {
  requirePositive(t);
  patch_[index] = t;
}

void SheetCutter::append(const Triangle& t) {
  requirePositive(t);
  patch_.push_back(t);
}

void SheetCutter::splitTriangle(std::size_t index, VertexId v) {
  const Triangle t = patch_[index];
  replace(index, {t[0], t[1], v});
  append({t[1], t[2], v});
  append({t[2], t[0], v});
}

void SheetCutter::splitEdge(VertexId a, VertexId b, VertexId v) {
  int found = 0;
  const std::size_t count = patch_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = patch_[i];
    for (int k = 0; k < 3; ++k) {
      const VertexId from = t[k], to = t[(k + 1) % 3], third = t[(k + 2) % 3];
      if (!((from == a && to == b) || (from == b && to == a))) continue;
      replace(i, {from, v, third});
      append({v, to, third});
      ++found;
    }
  }
  if (found != 2) throw CannotCut("the surface ends within the hole");
}

VertexId SheetCutter::insertCorner(const Vec3& corner) {
  for (std::size_t i = 0; i < patch_.size(); ++i) {
    const Triangle t = patch_[i];
    const std::array<Vec3, 3> p{at(t[0]), at(t[1]), at(t[2])};
    std::array<double, 3> part{};  // doubled areas opposite to the corners
    for (int k = 0; k < 3; ++k) part[k] = doubledArea(p[(k + 1) % 3], p[(k + 2) % 3], corner);
    if (part[0] < 0 || part[1] < 0 || part[2] < 0) continue;
    for (int k = 0; k < 3; ++k)
      if (flatDistance(p[k], corner) < near_) return t[k];
    const double total = part[0] + part[1] + part[2];
    Vec3 q = corner;
    q[2] = (part[0] * p[0][2] + part[1] * p[1][2] + part[2] * p[2][2]) / total;
    for (int k = 0; k < 3; ++k) {
      const Vec3 &from = p[(k + 1) % 3], &to = p[(k + 2) % 3];
      const double length = flatDistance(from, to);
      if (part[k] >= near_ * length) continue;
      const double share =
          std::clamp(((q - from).head<2>().dot((to - from).head<2>())) / (length * length), 0., 1.);
      const VertexId v = addVertex(from + share * (to - from));
      splitEdge(t[(k + 1) % 3], t[(k + 2) % 3], v);
      return v;
    }
    const VertexId v = addVertex(q);
    splitTriangle(i, v);
    return v;
  }
  throw CannotCut("the surface ends within the hole");
}

bool SheetCutter::hasEdge(VertexId a, VertexId b) const {
  return std::any_of(patch_.begin(), patch_.end(), [&](const Triangle& t) {
    return std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
  });
}

// From `from` towards `to` to the next vertex: one that the line passes, or a new one on an edge that it
// crosses.
VertexId SheetCutter::step(VertexId from, VertexId to) {
  const Vec3 a = at(from), b = at(to);
  const double length = flatDistance(a, b);
  const auto ahead = [&](const Vec3& p) { return (p - a).head<2>().dot((b - a).head<2>()) > 0; };
  for (std::size_t i = 0; i < patch_.size(); ++i) {
    const Triangle t = patch_[i];
    const auto corner = std::find(t.begin(), t.end(), from);
    if (corner == t.end()) continue;
    const auto k = static_cast<std::size_t>(corner - t.begin());
    const VertexId right = t[(k + 1) % 3], left = t[(k + 2) % 3];
    const Vec3 r = at(right), l = at(left);
    const double below = doubledArea(a, b, r), above = doubledArea(a, b, l);
    if (std::abs(below) < near_ * length && ahead(r)) return right;
    if (std::abs(above) < near_ * length && ahead(l)) return left;
    if (!(below < 0 && above > 0)) continue;
    const double share = below / (below - above);
    const Vec3 x = r + share * (l - r);
    if (!ahead(x)) continue;
    if (flatDistance(x, r) < near_) return right;
    if (flatDistance(x, l) < near_) return left;
    const VertexId v = addVertex(x);
    splitEdge(right, left, v);
    return v;
  }
  throw CannotCut("the surface ends within the hole");
}

std::vector<VertexId> SheetCutter::walk(VertexId from, VertexId to) {
  std::vector<VertexId> way{from};
  const std::size_t longest = 4 * patch_.size() + 16;
  while (way.back() != to) {
    way.push_back(hasEdge(way.back(), to) ? to : step(way.back(), to));
    if (way.size() > longest) throw CannotCut("the triangles are too narrow there");
  }
  return way;
}

void SheetCutter::removeInside(const std::vector<VertexId>& loop, SheetCut& result) {
  mesh::EdgeSet border;
  for (std::size_t i = 0; i < loop.size(); ++i)
    border.insert(directedKey(loop[i], loop[(i + 1) % loop.size()]));
  std::unordered_map<std::uint64_t, std::size_t> byEdge;
  for (std::size_t i = 0; i < patch_.size(); ++i)
    for (int k = 0; k < 3; ++k) byEdge[directedKey(patch_[i][k], patch_[i][(k + 1) % 3])] = i;
  std::vector<std::uint8_t> inside(patch_.size(), 0);
  std::vector<std::size_t> waiting;
  for (const std::uint64_t edge : border) {
    const auto found = byEdge.find(edge);
    if (found == byEdge.end()) throw CannotCut("the surface ends within the hole");
    waiting.push_back(found->second);
  }
  while (!waiting.empty()) {
    const std::size_t i = waiting.back();
    waiting.pop_back();
    if (inside[i] != 0) continue;
    inside[i] = 1;
    for (int k = 0; k < 3; ++k) {
      const VertexId a = patch_[i][k], b = patch_[i][(k + 1) % 3];
      if (border.count(directedKey(a, b)) != 0) continue;
      const auto next = byEdge.find(directedKey(b, a));
      if (next == byEdge.end()) throw CannotCut("the surface ends within the hole");
      waiting.push_back(next->second);
    }
  }
  for (std::size_t i = 0; i < patch_.size(); ++i)
    if (inside[i] == 0) result.around.push_back(patch_[i]);
}

SheetCut SheetCutter::cut(TriangleId start) {
  SheetCut result;
  gather(start, result);
  std::vector<VertexId> corner;
  for (const Vec3& c : corners_) corner.push_back(insertCorner(c));
  std::vector<VertexId> loop;
  const std::size_t n = corner.size();
  for (std::size_t k = 0; k < n; ++k) {
    result.sides.push_back(walk(corner[k], corner[(k + 1) % n]));
    loop.insert(loop.end(), result.sides.back().begin(), result.sides.back().end() - 1);
  }
  if (std::set<VertexId>(loop.begin(), loop.end()).size() != loop.size())
    throw CannotCut("the triangles are too narrow there");
  removeInside(loop, result);
  result.lowest = result.highest = at(loop[0])[2];
  for (const VertexId v : loop) {
    result.lowest = std::min(result.lowest, at(v)[2]);
    result.highest = std::max(result.highest, at(v)[2]);
  }
  if (mirror_ < 0) {  // back to the order of the outline as it was given
    for (auto& side : result.sides) std::reverse(side.begin(), side.end());
    std::reverse(result.sides.begin(), result.sides.end());
    std::rotate(result.sides.begin(), result.sides.begin() + 1, result.sides.end());
  }
  return result;
}

}  // namespace thicken::drain
