// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure/warnings.h"

#include <fmt/format.h>

#include "mesh/place_text.h"

namespace thicken::measure {

using mesh::text;

namespace {

// A wall is thin below this share of the thickness.
constexpr double kThin = 0.9;

}  // namespace

std::optional<std::string> repairWarning(const Report& report) {
  if (!report.repair || report.repair->changes.empty()) return std::nullopt;
  const RepairFacts& facts = *report.repair;
  std::string changes;
  for (const RepairChange& change : facts.changes)
    changes += fmt::format("{}{} {}", changes.empty() ? "" : ", ", change.count, name(change.kind));
  const double share = report.input.area > 0 ? facts.removedArea / report.input.area : 0;
  const std::string removed =
      facts.removed == 0
          ? "nothing of it was removed"
          : fmt::format("{} triangles with {} of its area were removed", facts.removed, percentText(share));
  return fmt::format("the surface was repaired ({}): {}", changes, removed);
}

namespace {

void addThinPlaces(Report& report) {
  constexpr double kMuch = 1e-3;  // of the area; a smaller share is told only with a thin wall
  const bool thinWall = report.thinnestShare < kThin;
  if (!thinWall && report.thinShare < kMuch) return;
  // Depths are known below the corners of the surface; a thin place between them has no share.
  const std::string share =
      report.thinShare > 0
          ? percentText(report.thinShare) + " of the surface has less than 0.9 of the thickness below it"
          : "below every corner of the surface there is 0.9 of the thickness at least";
  report.warnings.push_back(
      fmt::format("the solid is thinner than asked in places: the thinnest wall is {:.4g} mm at {}, and {}",
                  report.thinnestWall, text(report.thinnestPlace), share));
}

// Two sides of the surface itself may be nearer to each other than any wall is thick: at a sharp edge.
void addThinThrough(Report& report) {
  constexpr double kMuchThinner = 0.5;
  if (!(report.thinnestThrough > 0 && report.thinnestThroughShare < kMuchThinner &&
        report.thinnestThroughShare < kMuchThinner * report.thinnestShare))
    return;
  report.warnings.push_back(
      fmt::format("straight through the part it is only {:.4g} mm at {}: sharp edges and sheets that the "
                  "surface itself has "
                  "near each other are thinner than any wall below it",
                  report.thinnestThrough, text(report.thinnestThroughPlace)));
}

void addSteepness(Report& report) {
  if (!report.thicknessMap || report.thicknessMap->lowered == 0) return;
  report.warnings.push_back(fmt::format(
      "the thickness changes by up to {:.3g} mm per mm along the surface, faster than 1, where the "
      "shell would fold: it was made less below {} vertices",
      report.thicknessMap->steepest, report.thicknessMap->lowered));
}

// A profile of the rim is as fine as the triangles of the surface there.
void addRim(Report& report) {
  if (!report.rim) return;
  const RimFacts& rim = *report.rim;
  if (!rim.row) {
    report.warnings.emplace_back("the surface has no rim, and what was asked for the rim changes nothing");
    return;
  }
  // Two chords stay within 0.13 of the radius of a quarter circle; one has 0.29.
  constexpr double kChord = 0.5;
  std::string coarse;
  if (rim.round && *rim.row > kChord * *rim.round)
    coarse = fmt::format("a rounding of {:.4g} mm takes some at {:.4g} mm", *rim.round, kChord * *rim.round);
  if (rim.width && *rim.row > *rim.width)
    coarse +=
        fmt::format("{}a taper of {:.4g} mm takes some at that", coarse.empty() ? "" : " and ", *rim.width);
  if (!coarse.empty())
    report.warnings.push_back(fmt::format(
        "the profile of the rim is coarser than asked: the corners of the surface next to its rim "
        "are {:.4g} mm from it in the median, and {}; divide the triangles there, or ask for more",
        *rim.row, coarse));
}

void addViolations(Report& report) {
  for (const Fallback& f : report.fallbacks)
    if (f.stage == "internal")
      report.warnings.push_back(fmt::format(
          "the solid is the sweep's, since a rule that the program relies on was broken ({}); please "
          "report this with the surface",
          f.reason));
}

void addParts(Report& report) {
  if (report.parts < 2) return;
  std::string crumbs;
  if (report.crumbs > 0)
    crumbs = fmt::format(", {} of them crumbs of less than {:.3g} mm³", report.crumbs, report.crumbVolume);
  report.warnings.push_back(
      fmt::format("the solid is {} separate parts that nothing joins{}", report.parts, crumbs));
}

// A surface read in metres or inches is small against a thickness in millimetres, and one in micrometres
// large.
void addUnits(Report& report) {
  constexpr double kFarLarger = 1e5, kSmall = 1;  // mm
  constexpr double kThick = 0.25;                 // of the diagonal: hardly a wall any more
  const double across = report.input.diagonal;
  if (!(across > 0)) return;
  if (report.thickness >= across)
    report.warnings.push_back(fmt::format(
        "the thickness of {:.4g} mm exceeds the surface itself, which is {:.4g} mm across; lengths are "
        "millimetres: scale a surface in metres by 1000, one in inches by 25.4",
        report.thickness, across));
  else if (across < kSmall || report.thickness > kThick * across)
    report.warnings.push_back(fmt::format(
        "the surface is only {:.4g} mm across, {:.2g} times the thickness of {:.4g} mm; lengths are "
        "millimetres: scale a surface in metres by 1000, one in inches by 25.4",
        across, across / report.thickness, report.thickness));
  else if (across > kFarLarger * report.thickness)
    report.warnings.push_back(fmt::format(
        "the surface is {:.4g} mm across, {:.2g} times the thickness of {:.4g} mm; lengths are millimetres: "
        "scale a surface in micrometres by 0.001",
        across, across / report.thickness, report.thickness));
}

}  // namespace

std::string percentText(double share) {
  constexpr double kLeast = 1e-4, kMost = 0.999;
  if (share > 0 && share < kLeast) return "less than 0.01 %";
  if (share > kMost && share < 1) return "more than 99.9 %";
  return fmt::format("{:.3g} %", 100 * share);
}

void addWarnings(Report& report) {
  if (auto repaired = repairWarning(report)) report.warnings.push_back(*std::move(repaired));
  addUnits(report);
  addSteepness(report);
  addRim(report);
  addThinPlaces(report);
  addThinThrough(report);
  addParts(report);
  addViolations(report);
}

}  // namespace thicken::measure
