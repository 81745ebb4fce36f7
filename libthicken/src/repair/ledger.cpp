// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/ledger.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "check/surface_facts.h"
#include "mesh/sort_unique.h"
#include "thicken/check.h"
#include "thicken/error.h"

namespace thicken::repairing {

using checking::isFinite;

Ledger::Ledger(const RepairFacts& before) {
  for (const RepairChange& change : before.changes) changes_[change.kind] = change;
  largestPlace_ = before.largestPlace;
}

void Ledger::add(RepairKind kind, TriangleId origin, double area, const Vec3& place) {
  addUncounted(kind, origin, area, place);
  addCount(kind, 1);
}

void Ledger::addRemoved(RepairKind kind, TriangleId origin, double area, const Vec3& place) {
  add(kind, origin, area, place);
  if (!removes(kind) || kind == RepairKind::kDuplicate || !(area > largest_) || !isFinite(place)) return;
  largest_ = area;
  largestPlace_ = place;
}

void Ledger::addUncounted(RepairKind kind, TriangleId origin, double area, const Vec3& place) {
  RepairChange& change = changes_[kind];
  change.kind = kind;
  if (std::isfinite(area)) change.area += area;
  if (origin != RepairResult::kAdded) change.triangles.push_back(origin);
  if (change.places.size() < RepairChange::kMaxPlaces && isFinite(place)) change.places.push_back(place);
}

RepairFacts Ledger::facts(double weldDistance) && {
  RepairFacts facts;
  facts.weldDistance = weldDistance;
  facts.largestPlace = largestPlace_;
  for (auto& [kind, change] : changes_) {
    auto& ids = change.triangles;
    mesh::sortUnique(ids);
    if (removes(kind)) {
      facts.removed += change.count;
      if (kind != RepairKind::kDuplicate) facts.removedArea += change.area;
    }
    if (adds(kind)) {
      facts.added.triangles += change.count;
      facts.added.area += change.area;
    }
    facts.changes.push_back(std::move(change));
  }
  return facts;
}

RepairResult packed(const Workpiece& piece, double weldDistance, Ledger ledger) {
  RepairResult result;
  TriangleMesh rest;
  rest.positions = piece.mesh.positions;
  std::vector<TriangleId> order(piece.mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](TriangleId a, TriangleId b) { return piece.origin[a] < piece.origin[b]; });
  for (const TriangleId t : order) {
    if (piece.present[t] == 0) {
      ledger.addRemoved(piece.reason[t], piece.origin[t], piece.area(t), piece.middle(t));
      continue;
    }
    rest.triangles.push_back(piece.mesh.triangles[t]);
    result.origin.push_back(piece.origin[t]);
    const bool isNew = piece.origin[t] == RepairResult::kAdded;
    if (isNew && adds(piece.reason[t]))
      ledger.add(piece.reason[t], piece.origin[t], piece.area(t), piece.middle(t));
    if (piece.turned[t] != 0 && !isNew)
      ledger.add(RepairKind::kTurned, piece.origin[t], piece.area(t), piece.middle(t));
  }
  result.mesh = weld(rest);
  result.facts = std::move(ledger).facts(weldDistance);
  return result;
}

RepairResult proved(RepairResult result, const RunContext& context, int threads) {
  CheckResult proof = check(result.mesh, context, threads);
  if (!proof.valid()) {
    const std::string why = "the repaired surface is not valid: " + proof.defects.front().sentence;
    throw Error(ErrorCode::kInternal, why, std::move(proof.defects));
  }
  result.facts.surface = proof.facts;
  return result;
}

}  // namespace thicken::repairing
