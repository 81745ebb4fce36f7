// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What a user asks for. Lengths are millimetres.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace thicken {

/// The side of S that the material lies on; normals point to the positive side. On `kBoth` the
/// solid reaches r to either side, so that S is its middle surface and no part of its boundary;
/// the rim of S stays on the wall.
enum class Side { kNegative, kPositive, kBoth };

enum class Method {
  kAuto,         ///< the best that the library has
  kSweep,        ///< S, its copy at varying depth, walls below the rim
  kReconstruct,  ///< the paper's field and partial reconstruction (§2 to §4)
};

/// What the shell is like outside of edges and corners of S that are convex on its side.
enum class Join {
  kMitre,  ///< planes at r, up to 2 r from S
  kRound,  ///< r from S everywhere (Definition 2)
};

/// Which of the triangles that a run adds to S are merged into fewer, within the tolerance.
enum class Simplify {
  kOff,    ///< none
  kAuto,   ///< of walls and of the shell, those that are smaller than the triangles of S near them
  kShell,  ///< all, also where the shell is a copy of S
};

/// The precision that the result will be stored in. STL and FreeCAD's mesh kernel hold floats: new
/// vertices are rounded to float in either case, S itself only where it has to be.
enum class Precision {
  kSingle,  ///< S is rounded to float first; the check and the audit see the rounded coordinates
  kDouble,  ///< S keeps its doubles
};

struct Options {
  double thickness = 0;  ///< r > 0, finite
  /// mm: the solid begins so far from S, in place of at S. The surface there is Solid::gapSurface, and what
  /// is kept bit for bit. 0: none.
  double gap = 0;
  /// Factors of it, > 0, one for each vertex of the surface, linear over its triangles; empty: 1 everywhere.
  /// A point of the solid is as deep as its closest point on the surface asks for, r(c(p)).
  std::vector<double> thicknessMap = {};
  Side side = Side::kNegative;
  Method method = Method::kAuto;
  Precision precision = Precision::kDouble;
  std::optional<double> cell;       ///< cell width w of the field, < r/2 (Remark 1)
  std::optional<int> resolution;    ///< cells along the longest side of the box grown by r; 4 to 65536
  std::optional<Join> join;         ///< round for kReconstruct and where there is a tolerance, else mitred
  std::optional<double> tolerance;  ///< farthest that the shell may be from its definition
  std::optional<int> smooth;        ///< rounds of shape optimisation (§4.3); 0 to 100
  bool repair = false;              ///< mend a defective input first and report every change (repair.h)
  std::optional<double> weld;       ///< with repair: mm, RepairOptions::weldDistance
  std::optional<double> bridge;     ///< with repair: mm, RepairOptions::bridgeDistance
  std::optional<double> fillHoles;  ///< with repair: mm, RepairOptions::longestHole
  bool strict = false;  ///< refuse a solid that lost too much or is mostly too thin (docs/repair.md)
  Simplify simplify = Simplify::kAuto;
  int threads = 0;  ///< 0: all that the machine has
  /// mm, > 0, given together: the thickness is rimThickness at the rim and changes to what it is elsewhere
  /// over rimWidth along the surface.
  std::optional<double> rimThickness, rimWidth;
  /// mm, > 0, less than the thickness at the rim: radius of the quarter circle between shell and wall.
  std::optional<double> rimRound;
};

[[nodiscard]] std::string_view name(Side side) noexcept;
[[nodiscard]] std::string_view name(Method method) noexcept;
[[nodiscard]] std::string_view name(Join join) noexcept;
[[nodiscard]] std::string_view name(Simplify simplify) noexcept;

}  // namespace thicken
