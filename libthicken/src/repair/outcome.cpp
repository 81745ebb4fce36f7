// SPDX-License-Identifier: LGPL-2.1-or-later
#include "repair/outcome.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "mesh/place_text.h"

namespace thicken::repairing {

using mesh::text;

namespace {

constexpr double kMostLost = 0.05;  // share of the area
constexpr double kMostThin = 0.05;
constexpr double kThin = 0.5;  // of the thickness

// Share of the area of S below which the solid is thinner than half of what was asked. A triangle is as deep
// as the mean of its corners.
double thinShare(const Solid& solid) {
  double thin = 0, all = 0;
  const auto& p = solid.mesh.positions;
  for (TriangleId t = 0; t < solid.mesh.triangles.size(); ++t) {
    const Triangle& c = solid.mesh.triangles[t];
    const VertexId last = std::max({c[0], c[1], c[2]});
    if (solid.region[t] != Region::kOriginal || last >= solid.depth.size()) continue;
    const double area = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]).norm() / 2;
    const double depth = (solid.depth[c[0]] + solid.depth[c[1]] + solid.depth[c[2]]) / 3;
    all += area;
    if (depth < kThin * solid.report.thickness) thin += area;
  }
  return all > 0 ? thin / all : 0;
}

}  // namespace

std::optional<std::string> shortcoming(const Solid& solid) {
  const Report& report = solid.report;
  if (!report.repair || report.repair->changes.empty()) return std::nullopt;
  const double lost = report.input.area > 0 ? report.repair->removedArea / report.input.area : 0;
  const double thin = thinShare(solid);
  if (lost <= kMostLost && thin <= kMostThin) return std::nullopt;
  std::string sentence = "the solid is not the surface that was given: ";
  if (lost > kMostLost)
    sentence += fmt::format("the repair removed {:.3g} % of its area, the largest piece at {}", 100 * lost,
                            text(report.repair->largestPlace));
  if (thin > kMostThin)
    sentence += fmt::format("{}{:.3g} % of what is left is thinner than half the thickness, the least at {}",
                            lost > kMostLost ? ", and " : "", 100 * thin, text(report.thinnestPlace));
  return sentence;
}

std::vector<std::string> additions(const RepairFacts& facts) {
  const AddedFacts& added = facts.added;
  std::vector<std::string> told;
  if (added.triangles > 0)
    told.push_back(
        fmt::format("{} triangles were added to the surface: {} strips between rims, {} holes filled",
                    added.triangles, added.strips, added.holes));
  if (added.left > 0)
    told.push_back(
        fmt::format("{} holes that are short enough stay open, as no patch fits into them without meeting "
                    "the surface; the "
                    "first is at {}",
                    added.left, text(added.leftPlaces.front())));
  if (facts.seams.left > 0)
    told.push_back(fmt::format("{} corners near another rim could not be joined to it; the first is at {}",
                               facts.seams.left, text(facts.seams.leftPlaces.front())));
  return told;
}

}  // namespace thicken::repairing
