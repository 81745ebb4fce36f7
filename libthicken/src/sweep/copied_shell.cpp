// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/copied_shell.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

namespace thicken::sweep {

bool CopiedShell::isOfThisShell(const Triangle& t) const {
  return of_.shells == 1 ||
         (of_.copyOf(t[0]).offset.dot(of_.copies[firstCopy_ + of_.copyOf(t[0]).base].offset) > 0);
}

Vec3 CopiedShell::placeOf(std::size_t copy) const {
  const Copy& c = of_.copies[copy];
  return of_.positions[c.base] + c.depth * c.offset;
}

CopiedShell::Chains CopiedShell::chainsOf(TriangleId s) const {
  if (const auto it = chains_.find(s); it != chains_.end()) return it->second;
  Chains chains;
  for (int k = 0; k < 3; ++k) chains[k] = {static_cast<std::uint32_t>(firstCopy_ + of_.triangles[s][k])};
  return chains;
}

bool CopiedShell::isCopied(TriangleId s) const {
  if (changed_.contains(s)) return true;
  const Chains chains = chainsOf(s);
  Chain all;
  for (const Chain& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
  if (copied_[s].size() + 2 != all.size()) return false;
  return std::all_of(copied_[s].begin(), copied_[s].end(), [&](TriangleId t) {
    return std::all_of(of_.triangles[t].begin(), of_.triangles[t].end(), [&](VertexId x) {
      return std::find(all.begin(), all.end(), x - of_.surfaceVertices) != all.end();
    });
  });
}

std::optional<Fan> CopiedShell::copiedFan(VertexId v) const {
  const auto around = around_.of(v);
  if (around.empty() || !std::all_of(around.begin(), around.end(), [&](TriangleId s) { return isCopied(s); }))
    return std::nullopt;
  Fan fan = fanOf(of_.triangles, around, v);
  if (fan.triangle.size() != around.size()) return std::nullopt;
  return fan;
}

int CopiedShell::cornerOf(TriangleId s, VertexId v) const {
  const Triangle& t = of_.triangles[s];
  return t[0] == v ? 0 : t[1] == v ? 1 : 2;
}

std::vector<CopiedShell::Chain> CopiedShell::chainsAt(VertexId v, const Fan& fan) const {
  std::vector<Chain> chains;
  for (const TriangleId s : fan.triangle) chains.push_back(chainsOf(s)[cornerOf(s, v)]);
  return chains;
}

void CopiedShell::listCopied() {
  copied_.assign(of_.surfaceTriangles, {});
  for (std::size_t t = of_.surfaceTriangles; t < of_.triangles.size(); ++t)
    if (const TriangleId s = of_.above[t]; s != mesh::kNone && isOfThisShell(of_.triangles[t]))
      copied_[s].push_back(static_cast<TriangleId>(t));
}

std::vector<std::array<int, 3>> triangulated(const std::vector<Vec3>& p, const Vec3& normal) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr double kThinnest = 1e-6;  // altitude over longest edge
  const int n = static_cast<int>(p.size());
  std::vector<double> cost(n * n, 0);
  std::vector<int> apex(n * n, -1);
  const auto faces = [&](int a, int b, int c) {
    const Vec3 &x = p[a], &y = p[b], &z = p[c];
    const double longest = std::max({(y - x).squaredNorm(), (z - y).squaredNorm(), (x - z).squaredNorm()});
    return (y - x).cross(z - x).dot(normal) > kThinnest * longest;
  };
  for (int length = 2; length < n; ++length)
    for (int i = 0; i + length < n; ++i) {
      const int j = i + length;
      double& best = cost[i * n + j];
      best = kInfinite;
      for (int k = i + 1; k < j; ++k) {
        const double sum = cost[i * n + k] + cost[k * n + j];
        if (sum < best && faces(i, k, j)) {
          best = sum;
          apex[i * n + j] = k;
        }
      }
      best += (p[i] - p[j]).norm();
    }
  std::vector<std::array<int, 3>> triangles;
  if (!(cost[n - 1] < kInfinite)) return triangles;
  std::vector<std::pair<int, int>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const int k = apex[i * n + j];
    if (k < 0) continue;
    triangles.push_back({i, k, j});
    open.emplace_back(i, k);
    open.emplace_back(k, j);
  }
  return triangles;
}

}  // namespace thicken::sweep
