// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sweep/corner_surroundings.h"

#include <algorithm>

#include "exact/triangle_pair.h"
#include "mesh/sort_unique.h"

namespace thicken::sweep {

namespace {

constexpr std::size_t kMost = 128;  // triangles of S

}  // namespace

CornerSurroundings::CornerSurroundings(const CopiedShell& shell, const SweptMesh& mesh,
                                       std::span<const Vec3> faceNormal, const mesh::VertexTriangles& around,
                                       VertexId v, const Fan& fan)
    : shell_(shell), normal_(faceNormal), v_(v), fan_(fan) {
  std::vector<TriangleId> near;
  for (const VertexId u : fan.ring) near.insert(near.end(), around.of(u).begin(), around.of(u).end());
  mesh::sortUnique(near);
  tooMany_ = near.size() > kMost;
  if (tooMany_) return;
  constexpr std::uint64_t kOfSurface = std::uint64_t{1} << 32;
  for (const TriangleId s : near) {
    Triangle t{};
    for (int k = 0; k < 3; ++k) {
      const VertexId x = mesh.triangles[s][k];
      t[k] = vertex(kOfSurface + x, mesh.positions[x]);
    }
    triangles_.push_back(t);
    if (std::find(fan.triangle.begin(), fan.triangle.end(), s) == fan.triangle.end() && shell.isCopied(s))
      addCopy(s, shell.chainsOf(s));
  }
  for (const Triangle& t : triangles_) boxes_.push_back(boxOf(t));
  fresh_.clear();
}

std::optional<std::size_t> CornerSurroundings::meetings(const std::vector<CopiedShell::Chain>& chains) {
  if (tooMany_) return std::nullopt;
  const std::size_t near = triangles_.size();
  bool folded = false;
  for (std::size_t i = 0; i < fan_.triangle.size() && !folded; ++i) {
    const TriangleId s = fan_.triangle[i];
    if (!shell_.isCopied(s)) continue;
    CopiedShell::Chains all = shell_.chainsOf(s);
    all[shell_.cornerOf(s, v_)] = chains[i];
    folded = !addCopy(s, all);
  }
  std::size_t count = 0;
  for (std::size_t i = near; i < triangles_.size() && !folded; ++i) {
    const Box box = boxOf(triangles_[i]);
    for (std::size_t j = 0; j < i; ++j)
      if (box.intersects(boxes_[j]) && exact::meet(at_, triangles_[i], triangles_[j])) ++count;
    boxes_.push_back(box);
  }
  triangles_.resize(near);
  boxes_.resize(near);
  for (const std::uint64_t key : fresh_) number_.erase(key);
  fresh_.clear();
  if (folded) return std::nullopt;
  return count;
}

CornerSurroundings::Box CornerSurroundings::boxOf(const Triangle& t) const {
  Box box(at_[t[0]]);
  return box.extend(at_[t[1]]).extend(at_[t[2]]);
}

VertexId CornerSurroundings::vertex(std::uint64_t key, const Vec3& p) {
  const auto [it, isNew] = number_.emplace(key, static_cast<VertexId>(at_.size()));
  if (isNew) {
    at_.push_back(p);
    fresh_.push_back(key);
  }
  return it->second;
}

bool CornerSurroundings::addCopy(TriangleId s, const CopiedShell::Chains& chains) {
  std::vector<VertexId> polygon;
  std::vector<Vec3> p;
  for (const CopiedShell::Chain& chain : chains)
    for (const std::uint32_t c : chain) {
      p.push_back(shell_.placeOf(c));
      polygon.push_back(vertex(c, p.back()));
    }
  const auto triangles = triangulated(p, normal_[s]);
  for (const auto& [a, b, c] : triangles) triangles_.push_back({polygon[a], polygon[b], polygon[c]});
  return !triangles.empty();
}

}  // namespace thicken::sweep
