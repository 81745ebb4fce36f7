// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Edge collapse by quadrics, each proved: an edge goes only where the mesh stays manifold, no triangle turns
// over or becomes a needle, no two triangles meet (exactly), and the triangles that change stay within the
// error that is allowed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bvh/triangle_distance.h"
#include "exact/box_tree.h"
#include "mesh/bounds.h"
#include "mesh/linked_mesh.h"
#include "simplify/edge_queue.h"
#include "simplify/shell_targets.h"
#include "thicken/closest_point.h"
#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/result.h"
#include "thicken/run_context.h"

namespace thicken::simplify {

/// Longest edge by least height from which on a triangle counts as a needle.
inline constexpr double kNeedle = 30;

/// Longest edge by least height; 1.15 of an equilateral triangle, infinite without area.
[[nodiscard]] double aspectOf(const Vec3& a, const Vec3& b, const Vec3& c);

/// What a collapse may do.
struct Limits {
  double error = 0;              ///< mm, farthest from a target, and error of the places that are looked at
  std::optional<double> proved;  ///< mm, error of whole triangles (shellBeyond())
};

class Collapse {
 public:
  /// `mesh` is closed and manifold; its first vertices are those of S and stay as they are. All must outlive
  /// this.
  Collapse(const job::Job& job, TriangleMesh& mesh, mesh::LinkedMesh& links, std::span<const Region> region,
           const ShellDefinition& definition, ShellTargets& targets, const Vec3& center,
           const Limits& limits);

  /// Collapses what it can, cheapest edges first.
  void run();

  [[nodiscard]] double largestDeviation() const { return largest_; }  ///< mm, from a target

 private:
  struct Changed {
    TriangleId id = 0;
    Triangle corners{};  // after the collapse
    Vec3 normal;         // before it, of the length of twice the area
    bool isLoose = false;
  };

  void countCreases();
  void collapseAmong(std::span<const TriangleId> triangles);
  void pushAround(VertexId v);
  void push(VertexId a, VertexId b, TriangleId left, TriangleId right);
  [[nodiscard]] bool isRemovable(VertexId v, bool alongCrease) const;
  bool tryEdge(VertexId a, VertexId b);
  [[nodiscard]] double volumeBelow(std::uint32_t part, const Triangle& t) const;
  bool tryAt(VertexId keep, VertexId go, const Vec3& place, bool isNew);
  void gatherNone();
  void gather(TriangleId t, bool goes);
  [[nodiscard]] bool areRight(VertexId keep, bool isNew);
  [[nodiscard]] bool areWellShaped() const;
  [[nodiscard]] bool keepsVolume();
  [[nodiscard]] bool coverTargets();
  [[nodiscard]] bool followDefinition(VertexId keep, bool isNew);
  [[nodiscard]] bool areClear(VertexId keep);
  [[nodiscard]] bool areProved() const;
  void apply(VertexId keep, VertexId go);
  void take();
  void turnCaps();
  void turnEdge(TriangleId t);

  [[nodiscard]] double costOf(double quadric, double length2) const;
  [[nodiscard]] std::array<Vec3, 3> cornersOf(const Triangle& t) const {
    return {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]};
  }

  const job::Job& job_;
  RunContext silent_;  // what single collapses take is counted by their edges
  job::Job alone_;     // for them
  TriangleMesh& mesh_;
  mesh::LinkedMesh& links_;
  std::span<const Region> region_;
  std::size_t fixed_;
  const ShellDefinition& definition_;
  ShellTargets& targets_;
  Vec3 center_;
  Limits limits_;
  exact::BoxTree boxes_;
  std::vector<std::uint8_t> creases_;  // per vertex: edges between two regions, up to 3
  std::vector<std::uint32_t> age_;     // per vertex: changes
  std::vector<std::uint32_t> block_;   // per vertex: edges within one are collapsed
  EdgeQueue queue_;
  double largest_ = 0;
  std::vector<std::uint32_t> part_;           // per triangle: the part of the boundary that it belongs to
  std::vector<double> volume_, leastVolume_;  // per part: six times its signed volume, mm³
  std::vector<Vec3> apex_;                    // per part: a place on it, from where volumes are measured
  // Of the collapse, or the turn of an edge, that is tried:
  std::array<VertexId, 2> edge_{};
  std::vector<TriangleId> starA_, starB_;
  std::vector<TriangleId> gone_;  // of both stars: those that go with the edge
  std::vector<Changed> changed_;
  std::array<Vec3, 2> facing_;  // sum of the normals of the shell's triangles, and of the wall's
  double oldAspect_ = 0;
  double volumeBefore_ = 0, change_ = 0;
  bool anyLoose_ = false, allLoose_ = false;
  struct Move {
    std::uint32_t target, to;
  };
  std::vector<Move> moves_;
  std::vector<bvh::PreparedTriangle> prepared_;  // changed_, and their bounds
  std::vector<mesh::Bounds> bounds_;
  std::vector<Triangle> fan_;
  std::vector<TriangleId> near_;
  double farthest_ = 0;
};

}  // namespace thicken::simplify
