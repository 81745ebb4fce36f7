// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Where the shell is to be: points of its definition, spread over the triangles that are there before it is
// simplified. Each of them stays near some triangle that took the place of its own.
//
// A point of the shell that is off its definition by no more than the tolerance has the definition's nearest
// point for a target; one that is farther off (halfway to another sheet, or where there is no room for the
// thickness), and any of a wall, itself. Outside of a mitred edge of S, where both the round and the mitred
// shell are right (OffsetError), there are no targets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "measure/offset_error.h"
#include "mesh/topology.h"
#include "simplify/quadric.h"
#include "thicken/result.h"

namespace thicken::simplify {

/// What the shell's error is measured by.
class ShellDefinition {
 public:
  /// `job` must outlive this. `most`: mm, error of a point that follows its definition.
  ShellDefinition(const job::Job& job, double most);

  struct Place {
    Vec3 target = Vec3::Zero(), normal = Vec3::Zero();  ///< of the definition, which goes through `target`
    double error = 0;                                   ///< mm, how far off it is
    bool isLoose = false;  ///< the definition is elsewhere: the point is its own target
    bool isWall = false;   ///< loose, and of the cross-section
    bool isFree = false;   ///< any shell between the round and the mitred one is right
    double area = 0;       ///< mm², of the triangle of S that is nearest
  };
  [[nodiscard]] Place at(const Vec3& p) const;

 private:
  const job::Job& job_;
  std::vector<Vec3> normal_;
  mesh::VertexTriangles around_;
  measure::OffsetError error_;
  double most_;
};

/// Whether the error of a triangle is looked at, in its middle: its corners do not tell all about it.
[[nodiscard]] bool isLookedAt(const std::array<Vec3, 3>& corner, double r);

struct ShellTargets {
  static constexpr std::uint32_t kEnd = 0xffffffffu;
  struct Target {
    Vec3 at;
    float most;  ///< mm, farthest that triangles may be
    std::uint32_t next;
  };
  std::vector<Target> targets;
  std::vector<std::uint32_t> first;   ///< per triangle: its first target
  std::vector<std::uint8_t> isLoose;  ///< per triangle
  std::vector<std::uint8_t> isDense;  ///< per triangle: one to do without
  std::vector<Quadric> quadric;       ///< per vertex

  void add(TriangleId t, const Vec3& at, double most) {
    targets.push_back({at, static_cast<float>(most), first[t]});
    first[t] = static_cast<std::uint32_t>(targets.size() - 1);
  }
};

/// The targets of all triangles around dense ones: of walls, and of those of the shell that are smaller than
/// the triangles of S that they are nearest to, or with `copies` all. `error`: mm, how far off the shell may
/// be; `center`: from where quadrics measure.
[[nodiscard]] ShellTargets shellTargets(const job::Job& job, const TriangleMesh& solid,
                                        std::span<const Region> region, const ShellDefinition& definition,
                                        double error, bool copies, const Vec3& center);

}  // namespace thicken::simplify
