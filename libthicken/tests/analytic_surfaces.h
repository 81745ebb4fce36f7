// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Surfaces whose thickened volume is known in closed form.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "thicken/mesh.h"

namespace thicken::shapes {

inline constexpr double kPi = std::numbers::pi;

/// The surface point(u, v) over [0, 1]² as a grid of nu × nv cells; normals point along ∂u × ∂v.
inline TriangleMesh parametric(VertexId nu, VertexId nv, const std::function<Vec3(double, double)>& point) {
  TriangleMesh mesh;
  for (VertexId j = 0; j <= nv; ++j)
    for (VertexId i = 0; i <= nu; ++i) mesh.positions.push_back(point(double(i) / nu, double(j) / nv));
  for (VertexId j = 0; j < nv; ++j)
    for (VertexId i = 0; i < nu; ++i) {
      const VertexId a = j * (nu + 1) + i, b = a + 1, c = a + nu + 1, d = c + 1;
      // alternating diagonals favour no direction
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      }
    }
  return mesh;
}

inline TriangleMesh plane(VertexId n, double size) {
  return parametric(n, n, [=](double u, double v) { return Vec3(size * u, size * v, 0); });
}

/// Part of a cylinder about z: `angle` radians, normals outward.
inline TriangleMesh cylinderPatch(VertexId n, double radius, double angle, double height) {
  return parametric(n, n / 4, [=](double u, double v) {
    return Vec3(radius * std::cos(angle * u), radius * std::sin(angle * u), height * v);
  });
}

/// Helicoid of pitch 2πc: a minimal surface, so that both sides have the same volume.
inline TriangleMesh helicoid(VertexId n, double radius, double c, double turn) {
  return parametric(n, n, [=](double u, double v) {
    const double s = radius * (2 * u - 1), t = turn * v;
    return Vec3(s * std::cos(t), s * std::sin(t), c * t);
  });
}

/// z = height·sin over `waves` whole waves of length 1 each.
inline TriangleMesh corrugation(VertexId n, double height, int waves) {
  return parametric(
      n, 8, [=](double u, double v) { return Vec3(waves * u, v, height * std::sin(2 * kPi * waves * u)); });
}

/// A spiral of `turns` turns whose sheets are `gap` apart, as a sheet of width 1; normals outward.
inline TriangleMesh roll(VertexId n, double inner, double gap, double turns) {
  return parametric(n, 4, [=](double u, double v) {
    const double t = 2 * kPi * turns * u, radius = inner + gap * turns * u;
    return Vec3(radius * std::cos(t), radius * std::sin(t), v);
  });
}

/// Icosahedron divided `levels` times and put on a sphere about the origin; triangles that `keep`
/// accepts (by their middle), normals outward.
inline TriangleMesh sphere(
    int levels, double radius,
    const std::function<bool(const Vec3&)>& keep = [](const Vec3&) { return true; }) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<VertexId, VertexId>, VertexId> middle;
    const auto middleOf = [&](VertexId a, VertexId b) {
      const auto [it, fresh] =
          middle.emplace(std::minmax(a, b), static_cast<VertexId>(mesh.positions.size()));
      if (fresh) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const VertexId ab = middleOf(a, b), bc = middleOf(b, c), ca = middleOf(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& p : mesh.positions) p = radius * p.normalized();
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return !keep((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3);
  });
  return mesh;
}

/// A random height field: smooth bumps and noise of a share of the cell's width.
inline TriangleMesh heightField(VertexId n, std::mt19937& random, double bump, double noise) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double a = 2 + 4 * unit(random), b = 2 + 4 * unit(random), phase = 6 * unit(random);
  TriangleMesh mesh = parametric(
      n, n, [&](double u, double v) { return Vec3(u, v, bump * std::sin(a * u + phase) * std::cos(b * v)); });
  for (Vec3& p : mesh.positions)
    p += noise / n * Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
  return mesh;
}

}  // namespace thicken::shapes
