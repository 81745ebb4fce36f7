// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The fields are documented in docs/report.md; a test compares the two.
#include "thicken/report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "thicken/version.h"

namespace thicken {
namespace {

// Keeps the order in which fields are added: a report is read by people too.
using Json = nlohmann::ordered_json;

constexpr double kCubicMillimetresPerMillilitre = 1000;

Json toPlace(const Vec3& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

Json surfaceFacts(const SurfaceFacts& facts) {
  return {{"triangles", facts.triangles},   {"vertices", facts.vertices},    {"rims", facts.rims},
          {"components", facts.components}, {"closed", facts.closed},        {"area_mm2", facts.area},
          {"diagonal_mm", facts.diagonal},  {"mean_edge_mm", facts.meanEdge}};
}

Json orNull(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json parameters(const Report& report) {
  Json json{{"thickness_mm", report.thickness},
            {"side", name(report.side)},
            {"method", name(report.asked)},
            {"join", name(report.join)},
            {"cell_mm", nullptr},
            {"threads", report.threads},
            {"thickness_map", nullptr},
            {"rim", nullptr}};
  if (report.thicknessMap)
    json["thickness_map"] = {{"least_mm", report.thicknessMap->least},
                             {"most_mm", report.thicknessMap->most},
                             {"steepest", report.thicknessMap->steepest},
                             {"lowered_vertices", report.thicknessMap->lowered}};
  if (report.rim)
    json["rim"] = {{"thickness_mm", orNull(report.rim->thickness)},
                   {"width_mm", orNull(report.rim->width)},
                   {"round_mm", orNull(report.rim->round)},
                   {"row_mm", orNull(report.rim->row)}};
  if (report.cell > 0) json["cell_mm"] = report.cell;
  return json;
}

Json fallbackFacts(const std::vector<Fallback>& fallbacks) {
  Json json = Json::array();
  for (const Fallback& f : fallbacks)
    json.push_back({{"stage", f.stage},
                    {"reason", f.reason},
                    {"place_mm", {f.place.x(), f.place.y(), f.place.z()}},
                    {"area_mm2", f.area}});
  return json;
}

Json stages(const std::vector<std::pair<std::string, double>>& seconds) {
  Json json = Json::object();
  double total = 0;
  for (const auto& [stage, time] : seconds) {
    json[stage] = json.value(stage, 0.0) + time;
    total += time;
  }
  json["total"] = total;
  return json;
}

// The stages that made the shell: a result has no method "auto".
std::string_view makerOf(Method method) {
  switch (method) {
    case Method::kSweep:
      return "sweep";
    case Method::kReconstruct:
      return "contour";
    case Method::kAuto:
      return "sweep-and-contour";
  }
  return "sweep-and-contour";
}

Json known(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json enoughMemory(std::size_t bytes) {
  return {{"enough_bytes", bytes > 0 ? Json(bytes) : Json()}};
}

Json outputFacts(const Report& report) {
  return {{"triangles", report.triangles},
          {"vertices", report.vertices},
          {"components", report.components},
          {"parts", report.parts},
          {"crumbs", report.crumbs},
          {"crumb_volume_mm3", report.crumbVolume},
          {"made_by", makerOf(report.method)},
          {"original_triangles", report.originalTriangles},
          {"shell_triangles", report.shellTriangles},
          {"wall_triangles", report.wallTriangles},
          {"volume_mm3", report.volume},
          {"volume_ml", report.volume / kCubicMillimetresPerMillilitre},
          {"area_mm2", report.area},
          {"dropped_copies", report.droppedCopies},
          {"sweep_rounds", report.rounds},
          {"contour_attempts", report.attempts}};
}

Json errorFacts(const ErrorFacts& facts) {
  return {{"mean", facts.mean}, {"p99", facts.p99}, {"max", facts.max}};
}

Json thinPlace(double mm, const Vec3& place, double share) {
  return {{"mm", mm}, {"share_of_thickness", share}, {"place_mm", toPlace(place)}};
}

Json simplifyFacts(const SimplifyFacts& facts) {
  return {{"triangles_before", facts.before},
          {"triangles_after", facts.after},
          {"deviation_mm", facts.deviation},
          {"worst_aspect", facts.worstAspect}};
}

Json verdicts(const AuditFacts& audit) {
  return {{"passed", audit.passed()},
          {"closed", audit.closed},
          {"edge_manifold", audit.edgeManifold},
          {"vertex_manifold", audit.vertexManifold},
          {"oriented", audit.oriented},
          {"non_degenerate", audit.nonDegenerate},
          {"intersection_free", audit.intersectionFree},
          {"positive_volume", audit.positiveVolume},
          {"surface_kept", audit.surfaceKept}};
}

Json defectList(const std::vector<Defect>& defects) {
  Json list = Json::array();
  for (const Defect& defect : defects) {
    list.push_back({{"code", name(defect.code)},
                    {"sentence", defect.sentence},
                    {"count", defect.count},
                    {"place_mm", toPlace(defect.place)},
                    {"vertices", defect.vertices},
                    {"edges", defect.edges},
                    {"triangles", defect.triangles}});
  }
  return list;
}

Json repairFacts(const std::optional<RepairFacts>& facts) {
  if (!facts) return nullptr;
  Json changes = Json::array();
  for (const RepairChange& change : facts->changes) {
    Json places = Json::array();
    for (const Vec3& place : change.places) places.push_back(toPlace(place));
    changes.push_back({{"kind", name(change.kind)},
                       {"removed", removes(change.kind)},
                       {"added", adds(change.kind)},
                       {"count", change.count},
                       {"area_mm2", change.area},
                       {"triangles", change.triangles},
                       {"places_mm", places}});
  }
  Json left = Json::array();
  for (const Vec3& place : facts->seams.leftPlaces) left.push_back(toPlace(place));
  Json open = Json::array();
  for (const Vec3& place : facts->added.leftPlaces) open.push_back(toPlace(place));
  return {{"added_triangles", facts->added.triangles},
          {"added_area_mm2", facts->added.area},
          {"strips", facts->added.strips},
          {"filled_holes", facts->added.holes},
          {"left_holes", facts->added.left},
          {"left_hole_places_mm", open},
          {"weld_distance_mm", facts->weldDistance},
          {"joined_edges", facts->seams.joinedEdges},
          {"left_corners", facts->seams.left},
          {"left_places_mm", left},
          {"removed_triangles", facts->removed},
          {"removed_area_mm2", facts->removedArea},
          {"largest_place_mm", toPlace(facts->largestPlace)},
          {"changes", changes},
          {"surface", surfaceFacts(facts->surface)}};
}

Json nearRimFacts(const NearRims& facts) {
  return {{"corners", facts.corners}, {"distance_mm", facts.distance}};
}

Json gapFacts(const std::optional<GapFacts>& gap) {
  if (!gap) return nullptr;
  return {{"mm", gap->asked},
          {"least_mm", gap->least},
          {"least_place_mm", toPlace(gap->leastPlace)},
          {"short_share", gap->shortShare},
          {"error", errorFacts(gap->error)},
          {"left_out_mm2", gap->leftOut},
          {"surface", surfaceFacts(gap->surface)}};
}

Json head(const char* status) {
  return {{"version", kVersion}, {"status", status}};
}

// A sentence may quote a file name that is no UTF-8: JSON has a replacement for that, and a report
// must not fail over it. Numbers that are not finite become null.
std::string text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json reportOf(const Report& report, const FileFacts& files) {
  Json json = head("ok");
  json["key"] = known(files.key);
  json["input"] = surfaceFacts(report.input);
  json["near_rims"] = nearRimFacts(report.nearRims);
  json["repair"] = repairFacts(report.repair);
  json["gap"] = gapFacts(report.gap);
  json["parameters"] = parameters(report);
  json["field"] = {{"cells", report.fieldCells}, {"nodes", report.fieldNodes}, {"finest_cell_mm", nullptr}};
  if (report.finestCell > 0) json["field"]["finest_cell_mm"] = report.finestCell;
  json["seconds"] = stages(report.seconds);
  json["predicted_seconds"] = report.predictedSeconds;
  json["memory"] = {{"predicted_bytes", report.predictedMemory},
                    {"peak_bytes", report.peakMemory},
                    {"enough_bytes", report.enoughMemory}};
  json["output"] = outputFacts(report);
  json["output"]["sha256"] = known(files.outputDigest);
  json["surface_deviation_mm"] = report.surfaceDeviation;
  json["shell_error"] = errorFacts(report.shellError);
  json["shell_error_full_depth"] = errorFacts(report.shellErrorFullDepth);
  if (report.shellErrorBound) json["shell_error_bound_mm"] = *report.shellErrorBound;
  json["thinnest_wall"] = thinPlace(report.thinnestWall, report.thinnestPlace, report.thinnestShare);
  json["thinnest_through"] =
      thinPlace(report.thinnestThrough, report.thinnestThroughPlace, report.thinnestThroughShare);
  json["thin_share"] = report.thinShare;
  json["simplify"] = simplifyFacts(report.simplify);
  json["audit"] = verdicts(report.audit);
  json["fallbacks"] = fallbackFacts(report.fallbacks);
  json["warnings"] = report.warnings;
  return json;
}

}  // namespace

std::string toJson(const Report& report, const FileFacts& files) {
  return text(reportOf(report, files));
}

std::string toJson(std::span<const Report> sheets, const FileFacts& files) {
  Json json = head("ok");
  json["sheets"] = Json::array();
  for (const Report& report : sheets) json["sheets"].push_back(reportOf(report, files));
  return text(json);
}

std::string toJson(const Error& error, const FileFacts& files) {
  Json json = head("refused");
  json["key"] = known(files.key);
  json["code"] = name(error.code());
  json["exit_status"] = exitStatus(error.code());
  json["sentence"] = error.what();
  json["input"] = error.input() ? surfaceFacts(*error.input()) : Json();
  json["repair"] = repairFacts(error.repair());
  json["memory"] = enoughMemory(error.enoughMemory());
  json["time"] = {{"enough_seconds", error.enoughSeconds() > 0 ? Json(error.enoughSeconds()) : Json()}};
  json["defects"] = defectList(error.defects());
  return text(json);
}

std::string toJson(const RepairFacts& facts) {
  return text(repairFacts(facts));
}

std::string toJson(const TrimFacts& facts) {
  Json json = head("ok");
  json["input"] = surfaceFacts(facts.input);
  json["loops"] = Json::array();
  for (const TrimFacts::Loop& loop : facts.loops)
    json["loops"].push_back(
        {{"points", loop.points}, {"path_mm", loop.length}, {"farthest_mm", loop.farthest}});
  json["untouched_triangles"] = facts.untouched;
  json["divided_triangles"] = facts.divided;
  json["path_deviation_mm"] = facts.deviation;
  json["surface"] = surfaceFacts(facts.surface);
  json["warnings"] = facts.warnings;
  return text(json);
}

std::string toJson(const CheckResult& result) {
  Json json = head(result.valid() ? "ok" : "refused");
  if (!result.valid()) {
    const Defect& first = result.defects.front();
    json["code"] = name(first.code);
    json["exit_status"] = exitStatus(first.code);
    json["sentence"] = first.sentence;
  }
  json["input"] = surfaceFacts(result.facts);
  if (result.nearRims) json["near_rims"] = nearRimFacts(*result.nearRims);
  json["memory"] = enoughMemory(result.enoughMemory);
  json["defects"] = defectList(result.defects);
  json["warnings"] = result.warnings;
  return text(json);
}

std::string toJson(const Inspection& inspection) {
  Json json = head(inspection.audit.passed() ? "ok" : "refused");
  json["volume_mm3"] = inspection.volume;
  json["area_mm2"] = inspection.area;
  json["audit"] = verdicts(inspection.audit);
  json["defects"] = defectList(inspection.defects);
  json["shells"] = Json::array();
  for (const SolidShell& shell : inspection.shells) {
    Json within;
    if (shell.within != SolidShell::kNoShell) within = shell.within;
    json["shells"].push_back({{"triangles", shell.triangles},
                              {"volume_mm3", shell.volume},
                              {"cavity", shell.cavity},
                              {"within", within}});
  }
  return text(json);
}

}  // namespace thicken
