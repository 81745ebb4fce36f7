// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a run returns: the proved solid and the facts about it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "thicken/mesh.h"
#include "thicken/options.h"
#include "thicken/repair.h"
#include "thicken/surface_facts.h"

namespace thicken {

/// The part of the boundary of the solid that a triangle belongs to (paper §4.2, Figure 7).
enum class Region : std::uint8_t {
  kOriginal,  ///< S itself
  kShell,     ///< inner shell: closest point on S is not on its rim (Definition 5b)
  kWall,      ///< cross-section: closest point on S is on its rim (Definition 5a)
};

/// Distribution of a relative error over the shell's area.
struct ErrorFacts {
  double mean = 0, p99 = 0, max = 0;  ///< |distance to S − r| / r
};

/// Verdicts of the exact audit; every one of them is true in a result that is returned.
struct AuditFacts {
  bool closed = false;
  bool edgeManifold = false;
  bool vertexManifold = false;
  bool oriented = false;       ///< consistently, and outward (cavities inward)
  bool nonDegenerate = false;  ///< no zero-area and no duplicate triangle
  bool intersectionFree = false;
  bool positiveVolume = false;
  bool surfaceKept = false;  ///< every triangle of S bit for bit; on Side::kBoth: its rim
  [[nodiscard]] bool passed() const noexcept {
    return closed && edgeManifold && vertexManifold && oriented && nonDegenerate && intersectionFree &&
           positiveVolume && surfaceKept;
  }
};

/// A place where the contour was to make the shell and did not: the sweep's own shell is there, which is
/// valid and may be thinner than asked.
struct Fallback {
  std::string stage;   ///< "contour": could not be joined there; "audit": did not pass; "memory": no room;
                       ///< "internal": a rule of the library's own was broken
  std::string reason;  ///< a complete sentence
  Vec3 place = Vec3::Zero();     ///< mm, in the middle of it
  double area = 0;               ///< mm² of the shell
  std::size_t enoughMemory = 0;  ///< bytes, with "memory": there would have been room; 0: not known
};

/// What was made coarser (Options::simplify).
struct SimplifyFacts {
  std::size_t before = 0, after = 0;  ///< triangles of the solid
  double deviation = 0;    ///< mm, largest that was added: from where the shell is to be, or a wall was
  double worstAspect = 0;  ///< longest edge by least height, of the worst triangle of shell and walls
};

/// The surface that a solid with Options::gap begins at.
struct GapFacts {
  double asked = 0;                ///< mm
  double least = 0;                ///< mm, from a corner of the solid to S
  Vec3 leastPlace = Vec3::Zero();  ///< mm, where that is
  double shortShare = 0;           ///< share of the area of S with room for less than 0.9 of it
  ErrorFacts error;                ///< |distance to S − gap| / gap over the gap surface, away from the rim
  double leftOut = 0;              ///< mm² of shreds that it was made without
  SurfaceFacts surface;            ///< of the gap surface
};

/// The profile of the rim (Options::rimThickness, rimRound).
struct RimFacts {
  std::optional<double> thickness, width, round;  ///< mm, as asked
  /// mm: the median distance of the vertices next to the rim, which no part of a profile can be finer than;
  /// nothing where there is no rim
  std::optional<double> row;
};

/// A thickness that varies (Options::thicknessMap, rimThickness, rimRound), as the solid has it.
struct ThicknessFacts {
  double least = 0, most = 0;  ///< mm
  double steepest = 0;         ///< mm per mm along the surface, as the map asked for
  std::size_t lowered = 0;     ///< vertices where it was made less, since it was steeper than 1
};

struct Report {
  SurfaceFacts input;                 ///< as it was given, before any repair
  NearRims nearRims;                  ///< of the surface that was thickened
  std::optional<RepairFacts> repair;  ///< with Options::repair: what was done to it
  std::optional<GapFacts> gap;        ///< with Options::gap; what follows is about the gap surface, not S
  double thickness = 0;               ///< mm
  std::optional<ThicknessFacts> thicknessMap;  ///< where it varies
  Side side = Side::kNegative;
  Join join = Join::kMitre;                    ///< that was made
  Method asked = Method::kAuto;                ///< as it was asked for
  Method method = Method::kAuto;               ///< what made it; kAuto: the sweep and the contour together
  double cell = 0;                             ///< mm; 0 where no field was computed
  double finestCell = 0;                       ///< mm; less than that where places took finer cells
  std::size_t fieldCells = 0, fieldNodes = 0;  ///< of the grid, that the field was needed at
  int threads = 0;
  std::vector<std::pair<std::string, double>> seconds;  ///< stage, seconds; in order
  double predictedSeconds = 0;                          ///< of one processor: forecast()
  std::size_t predictedMemory = 0;                      ///< bytes
  std::size_t peakMemory = 0;                           ///< bytes, of the process
  std::size_t enoughMemory = 0;                         ///< bytes of a limit that changes nothing

  std::size_t triangles = 0, vertices = 0;
  std::size_t originalTriangles = 0, shellTriangles = 0, wallTriangles = 0;
  std::size_t components = 0;      ///< connected components of the boundary of the solid
  std::size_t parts = 0;           ///< of them, those that enclose material: separate bodies
  std::size_t crumbs = 0;          ///< of these, those of less than crumbVolume
  double crumbVolume = 0;          ///< mm³: r³, or a thousandth of the largest part if that is less
  double volume = 0;               ///< mm³
  double area = 0;                 ///< mm²
  double surfaceDeviation = 0;     ///< mm, measured: farthest from a corner of S to a corner of the solid
  ErrorFacts shellError;           ///< over the whole shell
  ErrorFacts shellErrorFullDepth;  ///< where the depth reached is full
  std::optional<double> shellErrorBound;  ///< mm; with Options::tolerance: proved for all of the shell
  /// mm, distance from the shell's vertex that has the least share of the thickness there to S; where most of
  /// the shell is gone, thinnestThrough counts, too
  double thinnestWall = 0;
  double thinnestShare = 0;           ///< of the thickness there
  Vec3 thinnestPlace = Vec3::Zero();  ///< mm, where that is
  double thinnestThrough = 0;       ///< mm, least way straight through the part from S; 0: none found. Where
                                    ///< the thickness varies: the least share of it
  double thinnestThroughShare = 0;  ///< of the thickness there
  Vec3 thinnestThroughPlace = Vec3::Zero();  ///< mm, where that is
  double thinShare = 0;                      ///< share of the area of S with a depth below 0.9 r
  std::size_t droppedCopies = 0;             ///< vertices of S without a copy on the shell
  std::size_t rounds = 0;    ///< rounds of retests that the sweep took; 0 where there was none
  std::size_t attempts = 0;  ///< attempts after the first that the contour took; 0 where there was none
  std::vector<Fallback> fallbacks;  ///< where the sweep was left instead of a contour
  SimplifyFacts simplify;
  AuditFacts audit;
  std::vector<std::string> warnings;  ///< complete sentences
  std::optional<RimFacts> rim;        ///< where the rim has a profile
};

struct Solid {
  TriangleMesh mesh;                     ///< new vertices hold float values; S comes first, in its own order
  std::vector<Region> region;            ///< per triangle
  std::vector<double> depth;             ///< mm per vertex of S: how deep the solid is below it
  std::optional<TriangleMesh> repaired;  ///< with Options::repair: S, the surface that was thickened
  std::optional<TriangleMesh> gapSurface;  ///< with Options::gap: what was thickened in place of S
  Report report;
};

}  // namespace thicken
