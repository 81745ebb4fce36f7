// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Makes a valid surface of a defective one, gently: near-equal corners of rims become one vertex,
// triangles without area and repeated ones are dropped, neighbours are given one sense, and where
// triangles meet, share an edge with two others or touch in a point only, as few as possible are removed.
//
// Guarantee: the result is empty of every defect that check() knows. No corner moves but those that
// are welded to another. Every triangle of the result is one of the input, in either sense and with welded
// corners, or a part of one, or, where that is asked for, one that was added between rims. Parts are divided
// at corners of other rims, or cut off beside sheets or where triangles met, at new, rounded corners.
// A valid surface comes back as it was, bit for bit, unless rims of it are joined, bridged or filled.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/run_context.h"
#include "thicken/surface_facts.h"

namespace thicken {

enum class RepairKind {
  kWelded,             ///< corners moved onto a corner nearby
  kNotFinite,          ///< triangles removed: a corner is no number
  kDegenerate,         ///< triangles removed: no area
  kDuplicate,          ///< triangles removed: there twice
  kDivided,            ///< triangles divided at corners that lie on one of their edges, shape unchanged
  kTurned,             ///< triangles turned over
  kNonManifoldEdge,    ///< triangles removed: more than two at an edge
  kOneSided,           ///< triangles removed: a strip across a one-sided part
  kSelfIntersecting,   ///< triangles removed: they meet others
  kNonManifoldVertex,  ///< triangles removed: parts touched in a point only
  kOverlapping,        ///< triangles removed: a sheet that lay on a larger one and ran through it all over
  kCrumb,              ///< triangles removed: too small a part that came off
  kFolded,    ///< triangles removed by thicken(): no wall fits below so sharp a fold, so narrow a gap
  kSmoothed,  ///< triangles removed: teeth in the border of what else was removed
  kBridged,   ///< triangles added: a strip between two rims
  kFilled,    ///< triangles added: a hole was closed
};

/// The kind as it is printed and documented: "welded", "self-intersecting", …
[[nodiscard]] std::string_view name(RepairKind kind) noexcept;
/// Whether the triangles of a change of this kind are gone.
[[nodiscard]] bool removes(RepairKind kind) noexcept;
/// Whether the triangles of a change of this kind are new.
[[nodiscard]] bool adds(RepairKind kind) noexcept;

/// Everything of one kind that was changed.
struct RepairChange {
  static constexpr std::size_t kMaxPlaces = 1000;

  RepairKind kind = RepairKind::kWelded;
  std::size_t count = 0;  ///< triangles, or parts of divided ones; kWelded: corners
  double area = 0;        ///< mm², of these triangles
  std::vector<TriangleId>
      triangles;             ///< their ids in the input, ascending; kWelded: those with such a corner
  std::vector<Vec3> places;  ///< mm, a point in each of the first kMaxPlaces of them
};

/// What joining rims did (RepairOptions::weldDistance).
struct SeamFacts {
  static constexpr std::size_t kMaxPlaces = 1000;

  std::size_t joinedEdges = 0;  ///< rim edges, or parts of divided ones, that two rims share now
  std::size_t left = 0;  ///< corners within the distance of another rim that could not be joined to it:
                         ///< triangles would turn over, or the order of the corners is not clear
  std::vector<Vec3> leftPlaces;  ///< mm, the first kMaxPlaces of them
};

/// What was added between rims (RepairOptions::bridgeDistance, RepairOptions::longestHole).
struct AddedFacts {
  static constexpr std::size_t kMaxPlaces = 1000;

  std::size_t triangles = 0;
  double area = 0;               ///< mm²
  std::size_t strips = 0;        ///< between rims
  std::size_t holes = 0;         ///< filled
  std::size_t left = 0;          ///< holes that are short enough and still open: any patch would meet the
                                 ///< surface, or the rim has too many corners
  std::vector<Vec3> leftPlaces;  ///< mm, a corner of each of the first kMaxPlaces of them
};

/// Rims that run beside each other at a distance that is small against their edges.
struct NearRims {
  std::size_t corners = 0;  ///< corners that are so near another rim
  double distance = 0;      ///< mm, the farthest that one of them is from it: to weld over
};

struct RepairFacts {
  double weldDistance = 0;  ///< mm, the farthest that corners were welded over
  SeamFacts seams;
  AddedFacts added;
  std::size_t removed = 0;           ///< triangles, or parts of divided ones, that are gone
  double removedArea = 0;            ///< mm², without that of duplicates, which stay once
  Vec3 largestPlace = Vec3::Zero();  ///< mm, the middle of the largest triangle that is gone
  std::vector<RepairChange>
      changes;           ///< in the order of RepairKind, one entry a kind; empty: nothing to mend
  SurfaceFacts surface;  ///< what came of it
};

struct RepairOptions {
  /// mm, 0 or more: rims that are at most so far apart are joined, whatever their corners: corners become
  /// one, or divide an edge of the other rim. Unset: only corners that are at most a millionth of the
  /// bounding box's diagonal apart, and not farther than half the shortest edge at either, become one.
  std::optional<double> weldDistance;
  /// mm, above 0: rims that run beside each other for three times their gap or more and are at most so far
  /// apart are joined by a strip of triangles. Unset: no strips.
  std::optional<double> bridgeDistance;
  /// mm, above 0: rims that are shorter get a patch. Unset: all stay open.
  std::optional<double> longestHole;
};

struct RepairResult {
  static constexpr TriangleId kAdded = 0xffffffffu;

  TriangleMesh mesh;
  std::vector<TriangleId>
      origin;  ///< per triangle of `mesh`: the triangle of the input that it is (a part) of, or kAdded
  RepairFacts facts;
};

/// Looks for rims within a quarter of the mean rim edge of each other. Corners with equal coordinates have to
/// be one vertex already. Throws kCancelled. Cost: O(n log n).
[[nodiscard]] NearRims nearRims(const TriangleMesh& surface, const RunContext& context = {}, int threads = 0);

/// Repairs `surface`, whose corners with equal coordinates have to be one vertex already (weld()).
/// A valid surface is not looked into when no distance is given.
/// Throws Error: the code of the first defect when nothing remains; kInvalidArgument; kCancelled;
/// kMemoryLimit. Cost: O((n + k) log n) for k pairs of triangles that meet.
[[nodiscard]] RepairResult repair(const TriangleMesh& surface, const RepairOptions& options = {},
                                  RunContext context = {}, int threads = 0);

}  // namespace thicken
