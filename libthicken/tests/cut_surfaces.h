// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Random surfaces cut into panels along random curves. The two rims of a cut have different corners, and all
// of these are moved at random.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "plain_shapes.h"
#include "thicken/mesh.h"

namespace thicken::shapes {

struct CutSurface {
  TriangleMesh mesh;
  double meanEdge = 0;         ///< mm
  std::size_t components = 0;  ///< before the cut
  std::size_t rims = 0;        ///< before the cut
};

/// Panels side by side over the unit square, put on a wavy sheet or rolled up. `jitter`: how far a corner on
/// a cut may be from it, in mean edges.
class SurfaceCutter {
 public:
  SurfaceCutter(unsigned seed, double jitter) : random_(seed), jitter_(jitter) {}

  CutSurface make() {
    bumps_ = {0.05 + 0.15 * unit(), 2 + 3 * unit(), 2 + 3 * unit(), 6 * unit()};
    rolled_ = unit() < 0.3;
    const int kind = static_cast<int>(3 * unit());
    edge_ = 1 / (14 + std::floor(20 * unit()));
    const Curve curve = wave();
    if (kind == 0) {
      addPanel(constant(0), curve, 0, 1, false, true);
      addPanel(curve, constant(1), 0, 1, true, false);
    } else if (kind == 1) {  // three panels that meet in a point of a cut
      const double knee = 0.3 + 0.4 * unit();
      addPanel(constant(0), curve, 0, 1, false, true);
      addPanel(curve, constant(1), 0, knee, true, false, 2);
      addPanel(curve, constant(1), knee, 1, true, false, 1);
    } else {
      addDisc();
    }
    return {shuffled(), edge_, 1, kind == 2 ? 1u : 1u};
  }

 private:
  using Curve = std::function<double(double)>;
  struct Bumps {
    double height, a, b, phase;
  };

  double unit() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  static Curve constant(double x) {
    return [x](double) { return x; };
  }
  Curve wave() {
    const double middle = 0.35 + 0.3 * unit(), swing = 0.08 * unit(), times = 2 + 3 * unit(),
                 phase = 6 * unit();
    return [=](double s) { return middle + swing * std::sin(times * s + phase); };
  }
  [[nodiscard]] Vec3 onSurface(double u, double v) const {
    const double z = bumps_.height * std::sin(bumps_.a * u + bumps_.phase) * std::cos(bumps_.b * v);
    if (!rolled_) return {u, v, z};
    const double radius = 0.4 + 0.3 * z, turn = 2.2 * u;
    return {radius * std::cos(turn), radius * std::sin(turn), v};
  }
  Vec3 jittered(const Vec3& p) {
    Vec3 d;
    do d = Vec3(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1);
    while (d.norm() > 1);
    return p + jitter_ * edge_ * d;
  }

  // Numbers from `from` to `to`, some `edge_` apart, unevenly.
  std::vector<double> steps(double from, double to, double spacing) {
    const int n = std::max(2, static_cast<int>(std::round((to - from) / spacing)));
    std::vector<double> all;
    for (int i = 0; i <= n; ++i)
      all.push_back(from + (to - from) * (i + (i == 0 || i == n ? 0 : 0.5 * (unit() - 0.5))) / n);
    return all;
  }

  // Between two curves over v from `low` to `high`. `cutEnds`: 1 where the side at `low` is cut, 2 at `high`.
  void addPanel(const Curve& left, const Curve& right, double low, double high, bool cutLeft, bool cutRight,
                int cutEnds = 0) {
    TriangleMesh panel;
    const auto rows = steps(low, high, edge_ * (0.6 + 0.9 * unit()));
    const double width = right(0.5) - left(0.5);
    const int columns = std::max(2, static_cast<int>(std::round(width / edge_)));
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (int i = 0; i <= columns; ++i) {
        const double u = left(rows[j]) + (right(rows[j]) - left(rows[j])) * i / columns;
        const bool cut = (i == 0 && cutLeft) || (i == columns && cutRight) || (j == 0 && (cutEnds & 1)) ||
                         (j + 1 == rows.size() && (cutEnds & 2));
        const Vec3 p = onSurface(u, rows[j]);
        panel.positions.push_back(cut ? jittered(p) : p);
      }
    addCells(panel, rows.size() - 1, columns, false);
  }

  void addCells(TriangleMesh& panel, std::size_t rows, int columns, bool closed) {
    const std::size_t stride = columns + (closed ? 0 : 1);
    for (std::size_t j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const auto a = static_cast<VertexId>(j * stride + i), c = static_cast<VertexId>(a + stride);
        const auto b = static_cast<VertexId>(j * stride + (i + 1) % stride);
        const auto d = static_cast<VertexId>(b + stride);
        panel.triangles.push_back({a, b, d});
        panel.triangles.push_back({a, d, c});
      }
    if (unit() < 0.3) panel = reversed(panel);
    mesh_ = together(mesh_, panel);
  }

  // A round patch in a round sheet.
  void addDisc() {
    const double radius = 0.2 + 0.1 * unit(), swing = 0.15 * unit();
    const double lobes = 2 + std::floor(2 * unit()), phase = 6 * unit();
    const auto cut = [=](double t) { return radius * (1 + swing * std::sin(lobes * t + phase)); };
    const auto ring = [&](double inner, bool inside) {
      TriangleMesh panel;
      const int rings = std::max(2, static_cast<int>(std::round((inside ? radius : 0.5 - radius) / edge_)));
      auto turns = steps(0, 2 * 3.14159265358979, edge_ / radius * (0.6 + 0.9 * unit()));
      turns.pop_back();
      for (int k = 0; k <= rings; ++k)
        for (const double t : turns) {
          const double share = static_cast<double>(k) / rings;
          const double r = inside ? cut(t) * (inner + (1 - inner) * share) : cut(t) + (0.5 - cut(t)) * share;
          const Vec3 p = onSurface(0.5 + r * std::cos(t), 0.5 + r * std::sin(t));
          panel.positions.push_back((inside ? k == rings : k == 0) ? jittered(p) : p);
        }
      const std::size_t n = turns.size();
      if (inside) {
        panel.positions.push_back(onSurface(0.5, 0.5));
        const auto middle = static_cast<VertexId>(panel.positions.size() - 1);
        for (VertexId i = 0; i < n; ++i)
          panel.triangles.push_back({static_cast<VertexId>((i + 1) % n), i, middle});
      }
      addCells(panel, rings, static_cast<int>(n), true);
    };
    ring(0.3, true);
    ring(0, false);
  }

  // Which corner comes first in the list must not matter.
  TriangleMesh shuffled() {
    std::vector<VertexId> id(mesh_.positions.size());
    for (VertexId v = 0; v < id.size(); ++v) id[v] = v;
    std::shuffle(id.begin(), id.end(), random_);
    TriangleMesh result = mesh_;
    for (VertexId v = 0; v < id.size(); ++v) result.positions[id[v]] = mesh_.positions[v];
    for (Triangle& t : result.triangles)
      for (VertexId& v : t) v = id[v];
    return result;
  }

  std::mt19937 random_;
  double jitter_;
  Bumps bumps_{};
  bool rolled_ = false;
  double edge_ = 0;
  TriangleMesh mesh_;
};

}  // namespace thicken::shapes
