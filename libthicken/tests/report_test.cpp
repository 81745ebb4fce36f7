// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thicken/report.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

namespace thicken {
namespace {

using nlohmann::json;

Report sampleReport() {
  Report report;
  report.input.triangles = 12;
  report.input.rims = 2;
  report.repair.emplace();
  report.repair->removed = 2;
  report.repair->changes = {{RepairKind::kSelfIntersecting, 2, 0.5, {3, 4}, {Vec3(1, 2, 3)}}};
  report.repair->surface.triangles = 10;
  report.repair->added = {6, 1.5, 1, 2, 1, {Vec3(4, 5, 6)}};
  report.thickness = 2;
  report.thicknessMap = {1, 4, 0.5, 7};
  report.rim = {1, 5, 0.5, 0.25};
  report.side = Side::kBoth;
  report.asked = Method::kAuto;
  report.method = Method::kSweep;
  report.rounds = 2;
  report.parts = 3;
  report.surfaceDeviation = 0.25;
  report.thinnestThrough = 0.5;
  report.thinnestThroughShare = 0.25;
  report.threads = 3;
  report.fieldCells = 70;
  report.fieldNodes = 90;
  report.finestCell = 0.25;
  report.seconds = {{"check", 0.5}, {"sweep", 1}, {"check", 0.25}};
  report.predictedSeconds = 0.5;
  report.predictedMemory = 1000;
  report.enoughMemory = 1500;
  report.triangles = 30;
  report.originalTriangles = 12;
  report.shellTriangles = 14;
  report.wallTriangles = 4;
  report.volume = 2500;
  report.shellError = {0.01, 0.02, 0.04};
  report.shellErrorFullDepth = {0.001, 0.002, 0.004};
  report.shellErrorBound = 0.005;
  report.thinnestWall = 1.5;
  report.thinnestShare = 0.75;
  report.thinnestPlace = Vec3(1, 2, 3);
  report.thinShare = 0.125;
  report.simplify = {100, 30, 0.002, 12};
  report.audit.closed = true;
  report.fallbacks = {{"contour", "triangles meet", {1, 2, 3}, 0.5}};
  report.warnings = {"the solid is thin"};
  return report;
}

/// "a.b.c" for every value in `value`; lists of objects are written "a[].b".
void collectKeys(const json& value, const std::string& prefix, std::set<std::string>& keys) {
  if (value.is_object()) {
    for (const auto& [key, child] : value.items())
      collectKeys(child, prefix.empty() ? key : prefix + "." + key, keys);
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    keys.insert(prefix);
    collectKeys(value.front(), prefix + "[]", keys);
  } else {
    keys.insert(prefix);
  }
}

/// Every word in back quotes in the first columns of the tables of docs/report.md.
std::set<std::string> documentedKeys() {
  std::ifstream file(std::string(THICKEN_SOURCE_DIR) + "/docs/report.md");
  EXPECT_TRUE(file) << "docs/report.md is missing";
  std::set<std::string> keys;
  const std::regex quoted("`([^`]+)`");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() != '|') continue;
    const std::string column = line.substr(1, line.find('|', 1) - 1);
    for (std::sregex_iterator it(column.begin(), column.end(), quoted), end; it != end; ++it)
      keys.insert((*it)[1]);
  }
  return keys;
}

TEST(Report, HoldsTheFactsUnderTheirNames) {
  const json report = json::parse(toJson(sampleReport()));
  EXPECT_EQ(report["status"], "ok");
  EXPECT_EQ(report["input"]["triangles"], 12);
  EXPECT_EQ(report["input"]["rims"], 2);
  EXPECT_EQ(report["repair"]["removed_triangles"], 2);
  EXPECT_EQ(report["repair"]["changes"][0]["kind"], "self-intersecting");
  EXPECT_EQ(report["repair"]["changes"][0]["removed"], true);
  EXPECT_EQ(report["repair"]["changes"][0]["added"], false);
  EXPECT_EQ(report["repair"]["added_triangles"], 6);
  EXPECT_EQ(report["repair"]["added_area_mm2"], 1.5);
  EXPECT_EQ(report["repair"]["strips"], 1);
  EXPECT_EQ(report["repair"]["filled_holes"], 2);
  EXPECT_EQ(report["repair"]["left_holes"], 1);
  EXPECT_EQ(report["repair"]["left_hole_places_mm"][0], json({4, 5, 6}));
  EXPECT_EQ(report["repair"]["changes"][0]["triangles"], json({3, 4}));
  EXPECT_EQ(report["repair"]["changes"][0]["places_mm"][0], json({1, 2, 3}));
  EXPECT_EQ(report["repair"]["surface"]["triangles"], 10);
  EXPECT_EQ(report["parameters"]["side"], "both");
  EXPECT_EQ(report["parameters"]["method"], "auto");
  EXPECT_EQ(report["output"]["made_by"], "sweep");
  EXPECT_EQ(report["output"]["sweep_rounds"], 2);
  EXPECT_EQ(report["output"]["contour_attempts"], 0);
  EXPECT_EQ(report["output"]["parts"], 3);
  EXPECT_EQ(report["parameters"]["threads"], 3);
  EXPECT_TRUE(report["parameters"]["cell_mm"].is_null()) << "no field was computed";
  EXPECT_EQ(report["field"]["cells"], 70);
  EXPECT_EQ(report["field"]["nodes"], 90);
  EXPECT_EQ(report["field"]["finest_cell_mm"], 0.25);
  EXPECT_EQ(report["output"]["volume_mm3"], 2500);
  EXPECT_EQ(report["output"]["volume_ml"], 2.5);
  EXPECT_EQ(report["output"]["original_triangles"], 12);
  EXPECT_EQ(report["surface_deviation_mm"], 0.25);
  EXPECT_EQ(report["shell_error"]["p99"], 0.02);
  EXPECT_EQ(report["shell_error_full_depth"]["max"], 0.004);
  EXPECT_EQ(report["shell_error_bound_mm"], 0.005);
  EXPECT_EQ(report["thinnest_wall"]["share_of_thickness"], 0.75);
  EXPECT_EQ(report["thinnest_wall"]["place_mm"], json({1, 2, 3}));
  EXPECT_EQ(report["thinnest_through"]["share_of_thickness"], 0.25);
  EXPECT_EQ(report["parameters"]["thickness_map"],
            json({{"least_mm", 1.0}, {"most_mm", 4.0}, {"steepest", 0.5}, {"lowered_vertices", 7}}));
  EXPECT_EQ(report["thin_share"], 0.125);
  EXPECT_EQ(report["simplify"]["triangles_before"], 100);
  EXPECT_EQ(report["simplify"]["triangles_after"], 30);
  EXPECT_EQ(report["simplify"]["deviation_mm"], 0.002);
  EXPECT_EQ(report["simplify"]["worst_aspect"], 12);
  EXPECT_EQ(report["audit"]["closed"], true);
  EXPECT_EQ(report["audit"]["passed"], false) << "only one of the clauses was set";
  EXPECT_EQ(report["warnings"], json({"the solid is thin"}));
  EXPECT_EQ(report["memory"]["enough_bytes"], 1500);
}

TEST(Report, HoldsTheGapThatWasAskedFor) {
  EXPECT_TRUE(json::parse(toJson(sampleReport()))["gap"].is_null());
  GapFacts gap;
  gap.asked = 2;
  gap.least = 1.5;
  gap.leastPlace = {1, 2, 3};
  gap.shortShare = 0.25;
  gap.error = {0.01, 0.02, 0.03};
  gap.leftOut = 0.5;
  gap.surface.triangles = 40;
  Report report = sampleReport();
  report.gap = gap;
  const json told = json::parse(toJson(report));
  EXPECT_EQ(told["input"]["triangles"], 12);
  EXPECT_EQ(told["gap"]["mm"], 2);
  EXPECT_EQ(told["gap"]["least_mm"], 1.5);
  EXPECT_EQ(told["gap"]["least_place_mm"], json({1, 2, 3}));
  EXPECT_EQ(told["gap"]["short_share"], 0.25);
  EXPECT_EQ(told["gap"]["error"]["p99"], 0.02);
  EXPECT_EQ(told["gap"]["left_out_mm2"], 0.5);
  EXPECT_EQ(told["gap"]["surface"]["triangles"], 40);
}

TEST(Report, HoldsWhatARunOverFilesKnowsAndNullWithout) {
  const json report = json::parse(toJson(sampleReport(), {"0a", "1b"}));
  EXPECT_EQ(report["key"], "0a");
  EXPECT_EQ(report["output"]["sha256"], "1b");
  EXPECT_EQ(json::parse(toJson(Error(ErrorCode::kNoSolid, ""), {"0a", ""}))["key"], "0a");
  EXPECT_TRUE(json::parse(toJson(sampleReport()))["key"].is_null());
}

TEST(Report, OfARefusalTellsWhatWouldBeEnough) {
  Error error(ErrorCode::kMemoryLimit, "it does not fit");
  EXPECT_TRUE(json::parse(toJson(error))["memory"]["enough_bytes"].is_null());
  EXPECT_TRUE(json::parse(toJson(error))["time"]["enough_seconds"].is_null());
  error.setEnoughMemory(2000);
  error.setEnoughSeconds(7.5);
  EXPECT_EQ(json::parse(toJson(error))["memory"]["enough_bytes"], 2000);
  EXPECT_EQ(json::parse(toJson(error))["time"]["enough_seconds"], 7.5);
}

TEST(Report, HasNoErrorBoundUnlessOneWasAskedFor) {
  Report report = sampleReport();
  report.shellErrorBound.reset();
  EXPECT_FALSE(json::parse(toJson(report)).contains("shell_error_bound_mm"));
}

TEST(Report, AddsUpTheTimesOfAStage) {
  const json seconds = json::parse(toJson(sampleReport()))["seconds"];
  EXPECT_EQ(seconds["check"], 0.75);
  EXPECT_EQ(seconds["sweep"], 1);
  EXPECT_EQ(seconds["total"], 1.75);
}

TEST(Report, WritesNullForWhatIsNotFinite) {
  Report report = sampleReport();
  report.volume = std::numeric_limits<double>::quiet_NaN();
  report.thinnestShare = std::numeric_limits<double>::quiet_NaN();
  const json parsed = json::parse(toJson(report));
  EXPECT_TRUE(parsed["output"]["volume_mm3"].is_null());
  EXPECT_TRUE(parsed["thinnest_wall"]["share_of_thickness"].is_null());
}

Defect sampleDefect() {
  Defect defect;
  defect.code = ErrorCode::kNotManifold;
  defect.sentence = "edge 1-2 has three triangles";
  defect.count = 5;
  defect.edges = {{1, 2}};
  defect.triangles = {7, 8, 9};
  defect.place = Vec3(0.5, 0, 0);
  return defect;
}

TEST(Report, OfARefusalListsTheDefects) {
  const Error error(ErrorCode::kNotManifold, "edge 1-2 has three triangles", {sampleDefect()});
  const json report = json::parse(toJson(error));
  EXPECT_EQ(report["status"], "refused");
  EXPECT_EQ(report["code"], "not-manifold");
  EXPECT_EQ(report["exit_status"], 3);
  EXPECT_EQ(report["sentence"], "edge 1-2 has three triangles");
  ASSERT_EQ(report["defects"].size(), 1u);
  EXPECT_EQ(report["defects"][0]["count"], 5);
  EXPECT_EQ(report["defects"][0]["edges"], json::parse("[[1,2]]"));
  EXPECT_EQ(report["defects"][0]["triangles"], json({7, 8, 9}));
  EXPECT_EQ(report["defects"][0]["place_mm"][0], 0.5);
}

TEST(Report, OfARefusalHoldsWhatIsKnownOfTheSurface) {
  Error error(ErrorCode::kNoSolid, "it does not fit");
  EXPECT_TRUE(json::parse(toJson(error))["input"].is_null());
  EXPECT_TRUE(json::parse(toJson(error))["repair"].is_null());
  SurfaceFacts facts;
  facts.triangles = 7;
  error.setInput(facts);
  error.setRepair({});
  EXPECT_EQ(json::parse(toJson(error))["input"]["triangles"], 7);
  EXPECT_EQ(json::parse(toJson(error))["repair"]["removed_triangles"], 0);
}

TEST(Report, QuotesFileNamesThatAreNoUtf8) {
  const Error error(ErrorCode::kUnreadable, "the file \"\xff\xfe.stl\" is not there");
  EXPECT_EQ(json::parse(toJson(error))["code"], "unreadable");
}

TEST(Report, OfACheckHoldsFactsAndFirstDefect) {
  CheckResult result;
  result.facts.triangles = 4;
  EXPECT_EQ(json::parse(toJson(result))["status"], "ok");
  result.defects = {sampleDefect()};
  const json report = json::parse(toJson(result));
  EXPECT_EQ(report["status"], "refused");
  EXPECT_EQ(report["code"], "not-manifold");
  EXPECT_EQ(report["input"]["triangles"], 4);
}

TEST(Report, EveryKeyIsDocumentedAndEveryDocumentedKeyIsThere) {
  std::set<std::string> keys;
  collectKeys(json::parse(toJson(sampleReport())), "", keys);
  collectKeys(json::parse(toJson(Error(ErrorCode::kNotManifold, "", {sampleDefect()}))), "", keys);
  Report atGap = sampleReport();
  atGap.gap.emplace();
  collectKeys(json::parse(toJson(atGap)), "", keys);
  TrimFacts trimmed;
  trimmed.loops.emplace_back();
  collectKeys(json::parse(toJson(trimmed)), "", keys);
  keys.erase("seconds.check");
  keys.erase("seconds.sweep");
  keys.insert("seconds.<stage>");
  std::set<std::string> documented = documentedKeys();
  documented.erase("ok");
  documented.erase("refused");
  EXPECT_EQ(keys, documented);
}

}  // namespace
}  // namespace thicken
