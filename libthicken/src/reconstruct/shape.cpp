// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reconstruct/shape.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "parallel/parallel_for.h"

namespace thicken::reconstruct {

using contour::Crossing;
using contour::DualSurface;
using field::Standing;
using mesh::kNone;
using parallel::parallelFor;

namespace {

constexpr double kAlpha = 0.25;  // the paper's blending factor
// Weight of the mean against one plane: decides only in the directions that no plane decides.
constexpr double kPull = 0.02;

class Shaper {
 public:
  Shaper(const Assembly& assembly, const DualSurface& dual, std::vector<Crossing>& crossings, double cell,
         const RunContext& context, int threads)
      : dual_(dual),
        crossings_(crossings),
        cell_(cell),
        context_(context),
        threads_(threads),
        at_(assembly.mesh.positions.begin() + static_cast<std::ptrdiff_t>(assembly.carrierVertices),
            assembly.mesh.positions.end()) {
    std::vector<std::uint32_t> number(dual.vertexCount, kNone);  // among the wall's vertices
    for (std::uint32_t c = 0; c < crossings.size(); ++c) {
      if (crossings[c].beyond != Standing::kRim) continue;
      wall_.push_back({c, static_cast<std::uint32_t>(wallCorners_.size())});
      for (const VertexId v : dual.faces[c]) {
        if (number[v] == kNone) {
          number[v] = static_cast<std::uint32_t>(wallVertices_.size());
          wallVertices_.push_back(v);
        }
        wallCorners_.push_back(number[v]);
      }
    }
    onWall_.resize(dual.vertexCount);
    for (VertexId v = 0; v < dual.vertexCount; ++v) onWall_[v] = number[v] != kNone;
  }

  // The shell's normals do not change, so that all rounds of a vertex away from the wall are one step.
  void run(int rounds) {
    const double left = std::pow(1 - kAlpha, rounds);
    parallelFor(dual_.vertexCount, threads_, context_, 512, [&](std::size_t i) {
      const auto v = static_cast<VertexId>(i);
      if (onWall_[v]) return;
      const Vec3 goal = optimum(v);
      at_[v] = goal + left * (at_[v] - goal);
    });
    std::vector<Vec3> next(wallVertices_.size());
    for (int i = 0; i < rounds; ++i) {
      smoothWallNormals();
      parallelFor(wallVertices_.size(), threads_, context_, 512, [&](std::size_t k) {
        const VertexId v = wallVertices_[k];
        next[k] = (1 - kAlpha) * at_[v] + kAlpha * optimum(v);
      });
      for (std::size_t k = 0; k < next.size(); ++k) at_[wallVertices_[k]] = next[k];
    }
  }

  [[nodiscard]] bool onShell(VertexId v) const {
    bool any = false;
    for (const std::uint32_t c : crossingsOf(v)) {
      if (crossings_[c].beyond != Standing::kFar) return false;
      any = true;
    }
    return any;
  }

  std::vector<Vec3>& positions() { return at_; }

 private:
  [[nodiscard]] std::span<const std::uint32_t> crossingsOf(VertexId v) const {
    return std::span(dual_.crossingsOf)
        .subspan(dual_.crossingOffset[v], dual_.crossingOffset[v + 1] - dual_.crossingOffset[v]);
  }

  // The point that is nearest to the tangent planes of the vertex' crossings, kept near its start.
  [[nodiscard]] Vec3 optimum(VertexId v) const {
    const Vec3& start = dual_.start[v];
    Eigen::Matrix3d a = kPull * Eigen::Matrix3d::Identity();
    Vec3 b = Vec3::Zero();
    for (const std::uint32_t c : crossingsOf(v)) {
      const Vec3& n = crossings_[c].normal;
      a += n * n.transpose();
      b += n * n.dot(crossings_[c].at - start);
    }
    Vec3 step = a.ldlt().solve(b);
    const double most = step.cwiseAbs().maxCoeff();
    if (!(most <= cell_)) step *= most > 0 ? cell_ / most : 0;
    return start + step;
  }

  // The wall has no normal of its own (q − c lies in it): that of its faces, smoothed.
  void smoothWallNormals() {
    normalSum_.assign(wallVertices_.size(), Vec3::Zero());
    for (const WallFace& face : wall_) {
      const auto& f = dual_.faces[face.crossing];
      Vec3 n = Vec3::Zero();
      for (std::size_t k = 1; k + 1 < f.size(); ++k)
        n += (at_[f[k]] - at_[f[0]]).cross(at_[f[k + 1]] - at_[f[0]]);
      n.stableNormalize();
      for (const std::uint32_t k : cornersOf(face)) normalSum_[k] += n;
    }
    for (const WallFace& face : wall_) {
      Vec3 n = Vec3::Zero();
      for (const std::uint32_t k : cornersOf(face)) n += normalSum_[k];
      crossings_[face.crossing].normal = n.stableNormalized();
    }
  }

  struct WallFace {
    std::uint32_t crossing;
    std::uint32_t first;  ///< of its corners
  };
  // As numbers among the wall's vertices, in the face's order.
  [[nodiscard]] std::span<const std::uint32_t> cornersOf(const WallFace& face) const {
    return std::span(wallCorners_).subspan(face.first, dual_.faces[face.crossing].size());
  }

  const DualSurface& dual_;
  std::vector<Crossing>& crossings_;
  double cell_;
  const RunContext& context_;
  int threads_;
  std::vector<Vec3> at_;
  std::vector<std::uint8_t> onWall_;  ///< per vertex
  std::vector<WallFace> wall_;
  std::vector<std::uint32_t> wallCorners_;  ///< of the wall's faces
  std::vector<VertexId> wallVertices_;
  std::vector<Vec3> normalSum_;  ///< per vertex of the wall
};

}  // namespace

std::vector<Vec3> shapedPositions(const Assembly& assembly, const DualSurface& dual,
                                  std::vector<Crossing>& crossings, const field::Membership& membership,
                                  double cell, int rounds, const RunContext& context, int threads) {
  Shaper shaper(assembly, dual, crossings, cell, context, threads);
  shaper.run(rounds);
  std::vector<Vec3> at = std::move(shaper.positions());
  if (rounds == 0) return at;
  // Tangent planes of a ball meet outside it, chords between its points are inside: half-way between the two,
  // vertices stand out as far as the faces between them stand in. Not by more than half a cell's cap of the
  // ball.
  parallelFor(dual.vertexCount, threads, context, 128, [&](std::size_t v) {
    if (!shaper.onShell(static_cast<VertexId>(v))) return;
    const auto c = membership.surface().closest(at[v]);
    const double r = membership.thickness().at(*c), most = cell * cell / (8 * r);
    if (c->onRim || c->distance < r / 2 || std::abs(c->distance - r) > cell / 2) return;
    const double off = std::clamp((c->distance - r) / 2, -most, most);
    at[v] = c->point + ((r + off) / c->distance) * (at[v] - c->point);
  });
  return at;
}

}  // namespace thicken::reconstruct
