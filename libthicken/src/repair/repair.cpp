// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/repair.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "check/surface_facts.h"
#include "repair/bad_triangles.h"
#include "repair/borders.h"
#include "repair/bridges.h"
#include "repair/cover.h"
#include "repair/crumbs.h"
#include "repair/fans.h"
#include "repair/holes.h"
#include "repair/ledger.h"
#include "repair/meetings.h"
#include "repair/near_corners.h"
#include "repair/non_manifold_edges.h"
#include "repair/notches.h"
#include "repair/overlaps.h"
#include "repair/put_back.h"
#include "repair/seams.h"
#include "repair/sense.h"
#include "repair/workpiece.h"
#include "thicken/check.h"

namespace thicken {

using repairing::dropBadTriangles;
using repairing::dropCrumbs;
using repairing::findMeetings;

std::string_view name(RepairKind kind) noexcept {
  switch (kind) {
    case RepairKind::kWelded:
      return "welded";
    case RepairKind::kNotFinite:
      return "not-finite";
    case RepairKind::kDegenerate:
      return "degenerate";
    case RepairKind::kDuplicate:
      return "duplicate";
    case RepairKind::kDivided:
      return "divided";
    case RepairKind::kTurned:
      return "turned";
    case RepairKind::kNonManifoldEdge:
      return "non-manifold-edge";
    case RepairKind::kOneSided:
      return "one-sided";
    case RepairKind::kSelfIntersecting:
      return "self-intersecting";
    case RepairKind::kNonManifoldVertex:
      return "non-manifold-vertex";
    case RepairKind::kOverlapping:
      return "overlapping";
    case RepairKind::kCrumb:
      return "crumb";
    case RepairKind::kFolded:
      return "folded";
    case RepairKind::kSmoothed:
      return "smoothed";
    case RepairKind::kBridged:
      return "bridged";
    case RepairKind::kFilled:
      return "filled";
  }
  return "";
}

bool removes(RepairKind kind) noexcept {
  return kind != RepairKind::kWelded && kind != RepairKind::kDivided && kind != RepairKind::kTurned &&
         !adds(kind);
}

bool adds(RepairKind kind) noexcept {
  return kind == RepairKind::kBridged || kind == RepairKind::kFilled;
}

namespace {

using repairing::Workpiece;

// How far apart rounding may have taken what was one corner, mm.
double roundingOf(const TriangleMesh& surface) {
  constexpr double kShareOfDiagonal = 1e-6;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : surface.positions)
    if (checking::isFinite(p)) box.extend(p);
  return box.isEmpty() ? 0 : kShareOfDiagonal * box.diagonal().norm();
}

double distanceToWeld(const TriangleMesh& surface, const RepairOptions& options) {
  if (options.weldDistance) {
    if (!(*options.weldDistance >= 0) || !std::isfinite(*options.weldDistance))
      throw Error(
          ErrorCode::kInvalidArgument,
          fmt::format("the distance to weld corners over must be 0 or a positive number of millimetres, "
                      "not {}",
                      *options.weldDistance));
    return *options.weldDistance;
  }
  return roundingOf(surface);
}

// mm; 0 where it is not asked for.
double lengthOf(const std::optional<double>& asked, const char* what) {
  if (!asked) return 0;
  if (!(*asked > 0) || !std::isfinite(*asked))
    throw Error(ErrorCode::kInvalidArgument,
                fmt::format("{} must be a positive number of millimetres, not {}", what, *asked));
  return *asked;
}

// Whether no two triangles have a vertex in common. Such a mesh has no sheets whose rims could be joined in
// order: corners that are near each other are one.
bool isLoose(const TriangleMesh& surface) {
  std::vector<std::uint8_t> used(surface.positions.size(), 0);
  for (const Triangle& t : surface.triangles)
    for (const VertexId v : t)
      if (std::exchange(used[v], std::uint8_t{1}) != 0) return false;
  return true;
}

// Moves corners onto near ones and notes the triangles at them.
void weldNearCorners(Workpiece& piece, double distance, repairing::Ledger& ledger) {
  const repairing::NearCorners near = repairing::nearCorners(piece.mesh, distance);
  if (near.moved == 0) return;
  for (TriangleId t = 0; t < piece.mesh.triangles.size(); ++t) {
    Triangle& c = piece.mesh.triangles[t];
    const Triangle before = c;
    for (VertexId& v : c) v = near.onto[v];
    if (c != before) ledger.addUncounted(RepairKind::kWelded, t, piece.area(t), piece.middle(t));
  }
  ledger.addCount(RepairKind::kWelded, near.moved);
}

// Removes as little as it takes that no two triangles meet, and no vertex joins several fans.
// Triangles that were there when `mayReturn` was taken may come back.
void separate(Workpiece& piece, const repairing::KnownMeetings& known,
              std::span<const std::uint8_t> mayReturn) {
  const std::size_t count = piece.mesh.triangles.size();
  const repairing::MeetingGraph graph(count, known.pairs);
  // By area, but a triangle is a loss of its own, too: many slivers are not better than one triangle.
  std::vector<double> weight(count);
  for (TriangleId t = 0; t < count; ++t) weight[t] = piece.area(t);
  const double mean = std::accumulate(weight.begin(), weight.end(), 0.0) / static_cast<double>(count);
  for (double& w : weight) w = (std::isfinite(w) ? w : 0) + mean;
  for (const TriangleId t : repairing::smallCover(graph, piece.present, weight))
    piece.remove(t, RepairKind::kSelfIntersecting);
  const mesh::VertexTriangles around =
      mesh::vertexTriangles(piece.mesh.positions.size(), piece.mesh.triangles);
  repairing::openNonManifoldVertices(piece, around);
  std::vector<std::uint8_t> candidate(count, 0);
  for (TriangleId t = 0; t < count; ++t) {
    candidate[t] = piece.present[t] == 0 && mayReturn[t] != 0 && known.goneForGood[t] == 0;
  }
  repairing::putBack(piece, around, graph, candidate);
}

// Parts that come off beside an overlap and are smaller than this many mean triangles are dropped.
constexpr double kCrumbTriangles = 8;

double meanArea(const Workpiece& piece) {
  double sum = 0;
  std::size_t count = 0;
  for (TriangleId t = 0; t < piece.present.size(); ++t)
    if (piece.present[t] != 0) {
      sum += piece.area(t);
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

// Mends all that is defective, and joins seams.
SeamFacts mend(Workpiece& piece, const RepairOptions& options, repairing::Ledger& ledger,
               const RunContext& context, int threads) {
  SeamFacts seams;
  if (options.weldDistance) seams = repairing::joinSeams(piece, *options.weldDistance, ledger);
  repairing::KnownMeetings known = findMeetings(piece, context, threads);
  const std::vector<std::uint32_t> before = repairing::partsOfPiece(piece);
  const double fin = meanArea(piece);
  // All three are done, in this order.
  const bool overlapping = repairing::removeOverlaps(piece, known.pairs, threads);
  const bool ended = repairing::endSheetsAtEdges(piece);
  const bool cut = repairing::cutNonManifoldVertices(piece);
  if (overlapping || ended || cut) {
    dropCrumbs(piece, before, fin);
    known = findMeetings(piece, context, threads);
  }
  const std::vector<std::uint8_t> mayReturn = piece.present;
  repairing::makeSenseConsistent(piece);
  context.throwIfCancelled();
  separate(piece, known, mayReturn);
  // Straight borders cost no area, but for the one of an overlap, which has to be clean.
  const double regained = repairing::fillNotches(piece, threads);
  repairing::smoothBorders(piece, overlapping ? std::numeric_limits<double>::infinity() : regained);
  if (overlapping) {
    // Elsewhere what comes off may be somebody's button: it stays.
    dropCrumbs(piece, before, kCrumbTriangles * fin);
  }
  return seams;
}

RepairResult unchanged(const TriangleMesh& surface, const SurfaceFacts& facts) {
  RepairResult result;
  result.facts.surface = facts;
  result.mesh = surface;
  result.origin.resize(surface.triangles.size());
  std::iota(result.origin.begin(), result.origin.end(), 0u);
  return result;
}

[[noreturn]] void refuseAll(const CheckResult& given) {
  const Defect& first = given.defects.front();
  if (first.code == ErrorCode::kEmpty) throw Error(first.code, first.sentence, given.defects);
  throw Error(first.code, "nothing remains of the surface once its defects are removed: " + first.sentence,
              given.defects);
}

}  // namespace

NearRims nearRims(const TriangleMesh& surface, const RunContext& context, int threads) {
  Workpiece piece(surface);
  dropBadTriangles(piece, context, threads);
  return repairing::nearRims(piece);
}

RepairResult repair(const TriangleMesh& surface, const RepairOptions& options, RunContext context,
                    int threads) {
  const double distance = distanceToWeld(surface, options);
  const double bridge = lengthOf(options.bridgeDistance, "the width of gaps to bridge");
  const double longest = lengthOf(options.longestHole, "the length of the rims of holes to fill");
  const CheckResult given = check(surface, context, threads);
  const bool joins = options.weldDistance && distance > 0;
  if (given.valid() && !joins && bridge == 0 && longest == 0) return unchanged(surface, given.facts);

  repairing::Ledger ledger;
  Workpiece piece(surface);
  SeamFacts seams;
  if (!given.valid() || joins) {
    weldNearCorners(piece, isLoose(surface) ? distance : std::min(distance, roundingOf(surface)), ledger);
    dropBadTriangles(piece, context, threads);
    seams = mend(piece, options, ledger, context, threads);
  }
  AddedFacts added;
  if (bridge > 0) repairing::bridgeGaps(piece, bridge, added, context, threads);
  if (longest > 0) repairing::fillHoles(piece, longest, added, context, threads);
  RepairResult result = repairing::packed(piece, distance, std::move(ledger));
  if (result.mesh.triangles.empty()) refuseAll(given);
  result.facts.seams = std::move(seams);
  added.triangles = result.facts.added.triangles;
  added.area = result.facts.added.area;
  result.facts.added = std::move(added);
  return repairing::proved(std::move(result), context, threads);
}

}  // namespace thicken
