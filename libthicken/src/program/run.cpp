// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "io/sha256.h"
#include "job/stopwatch.h"
#include "mesh/vertex_values.h"
#include "platform/memory.h"
#include "program/draw_solid.h"
#include "program/files.h"
#include "program/made_before.h"
#include "program/messages.h"
#include "program/progress_line.h"
#include "thicken/thicken.h"

namespace thicken::program {

using job::Stopwatch;

namespace {

// Rough shares of the program's own stages in a whole run.
constexpr double kReadShare = 0.02;
constexpr double kWriteShare = 0.98;

// `warnings`: what was passed over in the file is added to them.
TriangleMesh readSurface(const Arguments& arguments, RunContext& context,
                         std::vector<std::string>& warnings) {
  context.enter(Stage::kReading, 0, kReadShare, 0);
  auto [surface, passedOver] = readMeshFile(arguments.input);
  warnings.insert(warnings.end(), passedOver.begin(), passedOver.end());
  if (arguments.unit != 1)
    for (Vec3& p : surface.positions) p *= arguments.unit;
  context.throwIfCancelled();
  return surface;
}

// What joins rims that are near each other; nothing where none are.
std::string joinOf(const NearRims& near) {
  if (near.corners == 0) return {};
  // rounded up, so that a weld over what is printed reaches them all
  const double unit = std::pow(10, std::floor(std::log10(near.distance)) - 2);
  const double distance = std::ceil(near.distance / unit) * unit;
  return fmt::format(
      "{0} corners of rims lie within {1:.6g} mm of another rim: --repair --weld {1:.6g} joins them",
      near.corners, distance);
}

// Whether a repair looks for what the surface was refused for.
bool isForRepair(const Error& error) {
  switch (error.code()) {
    case ErrorCode::kNotManifold:
    case ErrorCode::kNotOriented:
    case ErrorCode::kDegenerate:
    case ErrorCode::kSelfIntersecting:
      return true;
    case ErrorCode::kNoSolid:  // folds that no wall fits below are opened
      return !error.defects().empty() && !error.defects().front().vertices.empty();
    default:
      return false;
  }
}

// The same with the option that may help.
Error withRemedy(const Error& error, const NearRims& near) {
  const std::string join = joinOf(near);
  Error told(
      error.code(),
      fmt::format("{}; {}", error.what(),
                  join.empty() ? "--repair mends such places where it can, and reports every change" : join),
      error.defects());
  if (error.input()) told.setInput(*error.input());
  told.setEnoughMemory(error.enoughMemory());
  return told;
}

// thicken(), whose refusals say what of this program may help.
Solid thickenOrAdvise(const TriangleMesh& surface, const Options& options, const RunContext& context) {
  try {
    return thicken(surface, options, context);
  } catch (const Error& error) {
    if (options.repair || !isForRepair(error)) throw;
    throw withRemedy(error, nearRims(weld(surface), context, options.threads));
  }
}

// Numbered files must not take the place of what the run reads or writes besides.
void requireFree(const Arguments& arguments, std::size_t count) {
  for (const std::filesystem::path& path : pathsOfMeshes(arguments.output, count))
    if (samePath(path, arguments.input) || samePath(path, arguments.report))
      throw Error(ErrorCode::kInvalidArgument,
                  "the solid of a sheet would be written to " + oneLine(path.string()) +
                      ", which the run reads or writes itself; give the output another name");
}

// Solids, and what each report says; one of each but for --sheets.
struct Made {
  std::vector<TriangleMesh> meshes;
  std::vector<std::vector<Region>> regions;
  std::vector<Report> reports;
};

// The regions that are to be written as colours; none unless asked for.
std::span<const std::vector<Region>> coloursOf(const Arguments& arguments,
                                               std::span<const std::vector<Region>> regions) {
  return arguments.colours ? regions : std::span<const std::vector<Region>>();
}

// Proves all before it writes any.
Made makeSheets(const Arguments& arguments, const TriangleMesh& surface, const Options& options,
                RunContext& context) {
  const std::vector<Sheet> sheets = divideIntoSheets(surface);
  if (sheets.empty()) throw Error(ErrorCode::kEmpty, "the surface has no triangles");
  requireFree(arguments, sheets.size());
  Made made;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    try {
      const double share = (kWriteShare - kReadShare) / static_cast<double>(sheets.size());
      context.setPart(kReadShare + share * static_cast<double>(i),
                      kReadShare + share * static_cast<double>(i + 1));
      Options own = options;
      if (!own.thicknessMap.empty())
        own.thicknessMap = mesh::valuesAt(surface, options.thicknessMap, sheets[i].mesh, "the thickness map");
      Solid solid = thicken(sheets[i].mesh, own, context);
      made.meshes.push_back(std::move(solid.mesh));
      made.regions.push_back(std::move(solid.region));
      made.reports.push_back(std::move(solid.report));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled || error.code() == ErrorCode::kTimeLimit) throw;
      Error told(error.code(),
                 "sheet " + std::to_string(i + 1) + " of " + std::to_string(sheets.size()) + " (" +
                     std::to_string(sheets[i].mesh.triangles.size()) + " triangles): " + error.what(),
                 error.defects());
      if (error.input()) told.setInput(*error.input());
      if (error.repair()) told.setRepair(*error.repair());
      throw told;
    }
  }
  context.throwIfCancelled();
  context.setPart(kWriteShare, 1);
  context.enter(Stage::kWriting, 0, 1, 0);
  writeMeshes(arguments.output, made.meshes, coloursOf(arguments, made.regions));
  return made;
}

Made makeSolid(const Arguments& arguments, RunContext& context, std::vector<std::string>& warnings) {
  ProgressLine line(context, arguments.quiet);
  Stopwatch reading;
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  reading.lap("read");
  Options options = arguments.options;
  options.precision = storedPrecision(arguments.output);
  // The surface that is written has to be found in the solid bit for bit, whatever either file stores. That
  // at a gap is of floats in either case.
  if (!arguments.repaired.empty() && storedPrecision(arguments.repaired) == Precision::kSingle)
    options.precision = Precision::kSingle;
  if (!arguments.thicknessMap.empty())
    options.thicknessMap = readVertexProperty(arguments.input, arguments.thicknessMap);
  if (arguments.sheets) return makeSheets(arguments, surface, options, context);
  line.expect(forecast(sizesOf(surface), options).seconds);
  context.setPart(kReadShare, kWriteShare);
  Solid solid = thickenOrAdvise(surface, options, context);
  context.throwIfCancelled();
  context.setPart(kWriteShare, 1);
  context.enter(Stage::kWriting, 0, 1, 0);
  Stopwatch writing;
  if (!arguments.repaired.empty()) writeMesh(arguments.repaired, *solid.repaired);
  if (!arguments.gapSurface.empty()) writeMesh(arguments.gapSurface, *solid.gapSurface);
  writeMeshes(arguments.output, std::span(&solid.mesh, 1), coloursOf(arguments, std::span(&solid.region, 1)));
  writing.lap("write");
  auto& seconds = solid.report.seconds;
  seconds.insert(seconds.begin(), reading.laps().front());
  seconds.push_back(writing.laps().front());
  solid.report.warnings.insert(solid.report.warnings.begin(), warnings.begin(), warnings.end());
  Made made;
  made.meshes.push_back(std::move(solid.mesh));
  made.regions.push_back(std::move(solid.region));
  made.reports.push_back(std::move(solid.report));
  return made;
}

CheckResult checkSurface(const Arguments& arguments, RunContext& context,
                         std::vector<std::string>& warnings) {
  const ProgressLine line(context, arguments.quiet);
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  context.enter(Stage::kChecking, kReadShare, 1, 0);
  CheckResult result = check(surface, context, arguments.options.threads);
  result.nearRims = nearRims(surface, context, arguments.options.threads);
  result.enoughMemory = platform::peakMemory();
  result.warnings = warnings;
  return result;
}

TrimmedSurface trimSurface(const Arguments& arguments, RunContext& context,
                           std::vector<std::string>& warnings) {
  const ProgressLine line(context, arguments.quiet);
  std::vector<TrimLoop> loops;
  for (const std::filesystem::path& path : arguments.loops) {
    loops.push_back(readLoop(path));
    for (Vec3& p : loops.back()) p *= arguments.unit;
  }
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  TrimOptions options = arguments.trim;
  if (options.keep) *options.keep *= arguments.unit;
  options.precision = storedPrecision(arguments.output);
  context.setPart(kReadShare, kWriteShare);
  TrimmedSurface part = trim(surface, loops, options, context, arguments.options.threads);
  context.throwIfCancelled();
  context.setPart(kWriteShare, 1);
  context.enter(Stage::kWriting, 0, 1, 0);
  writeMesh(arguments.output, part.mesh);
  part.facts.warnings.insert(part.facts.warnings.begin(), warnings.begin(), warnings.end());
  return part;
}

std::string thicknessText(const Report& report) {
  return report.thicknessMap
             ? fmt::format("{:.6g} to {:.6g}", report.thicknessMap->least, report.thicknessMap->most)
             : fmt::format("{:.6g}", report.thickness);
}

void printSummary(const std::filesystem::path& path, const Report& report) {
  std::cout << oneLine(path.string()) << ": " << report.triangles << " triangles, " << report.volume / 1000
            << " mL, thinnest wall " << report.thinnestWall << " of " << thicknessText(report) << " mm"
            << (report.parts > 1 ? ", " + std::to_string(report.parts) + " parts" : "") << '\n';
}

void printSummary(const Arguments& arguments, const SurfaceFacts& facts) {
  std::cout << oneLine(arguments.input.string()) << ": a valid " << (facts.closed ? "closed" : "open")
            << " surface of " << facts.triangles << " triangles, " << facts.rims << " rims, "
            << facts.components << " components\n";
}

void writeReport(const Arguments& arguments, const std::string& json) {
  if (!arguments.report.empty()) writeText(arguments.report, json);
}

void printWarnings(const Arguments& arguments, const std::vector<std::string>& warnings) {
  if (arguments.quiet) return;
  for (const std::string& warning : warnings) printWarning(warning);
}

// run(warnings); the error that it ends with, if any, as the one type that the program reports, after what it
// warned of until then. `files`: what is known of them when it ends.
template <class Run>
void withReport(const Arguments& arguments, const FileFacts& files, Run run) {
  std::vector<std::string> warnings;
  try {
    try {
      run(warnings);
    } catch (const Error&) {
      throw;
    } catch (const std::bad_alloc&) {
      throw Error(ErrorCode::kMemoryLimit,
                  "the machine ran out of memory; free some, or use a larger --cell or a coarser surface");
    } catch (const std::exception&) {
      throw brokenRule();
    }
  } catch (const Error& error) {
    printWarnings(arguments, warnings);
    writeReport(arguments, toJson(error, files));
    throw;
  }
}

void requireFiles(const Arguments& arguments) {
  requireReadable(arguments.input);
  requireWritable(arguments.output);
  requireFolderFor(arguments.output);
  if (!arguments.picture.empty()) requireFolderFor(arguments.picture);
  for (const std::filesystem::path& path : {arguments.repaired, arguments.gapSurface}) {
    if (path.empty()) continue;
    requireWritable(path);
    requireFolderFor(path);
  }
}

}  // namespace

Error brokenRule() {
  return {
      ErrorCode::kInternal,
      "the program broke one of its own rules; nothing was written; please report it with the surface that "
      "caused it"};
}

void runThicken(const Arguments& arguments, RunContext context) {
  const bool isReported = !arguments.report.empty();
  if (isReported) requireFolderFor(arguments.report);
  Made made;
  FileFacts files;
  withReport(arguments, files, [&](std::vector<std::string>& warnings) {
    requireFiles(arguments);
    if (isReported) files.key = keyOf(arguments);
    if (arguments.skipIfSame && isMadeBefore(arguments, files.key)) return;
    made = makeSolid(arguments, context, warnings);
    if (!arguments.picture.empty())
      writePicture(arguments.picture,
                   drawSolids(made.meshes, made.regions, arguments.pictureWidth, arguments.pictureHeight));
    if (arguments.sheets) printWarnings(arguments, warnings);
  });
  if (made.reports.empty()) {
    if (!arguments.quiet) std::cout << oneLine(arguments.output.string()) << ": made before\n";
    return;
  }
  if (isReported && !arguments.sheets) files.outputDigest = io::sha256Of(arguments.output).value_or("");
  writeReport(arguments, arguments.sheets ? toJson(std::span<const Report>(made.reports), files)
                                          : toJson(made.reports.front(), files));
  const auto paths = pathsOfMeshes(arguments.output, made.meshes.size());
  for (std::size_t i = 0; i < made.reports.size(); ++i) {
    printWarnings(arguments, made.reports[i].warnings);
    if (!arguments.quiet) printSummary(paths[std::min(i, paths.size() - 1)], made.reports[i]);
  }
}

void runCheck(const Arguments& arguments, RunContext context) {
  if (!arguments.report.empty()) requireFolderFor(arguments.report);
  CheckResult result;
  withReport(arguments, {}, [&](std::vector<std::string>& warnings) {
    requireReadable(arguments.input);
    result = checkSurface(arguments, context, warnings);
  });
  writeReport(arguments, toJson(result));
  printWarnings(arguments, result.warnings);
  if (!result.valid()) {
    const Defect& first = result.defects.front();
    const Error error(first.code, first.sentence, result.defects);
    throw isForRepair(error) ? withRemedy(error, *result.nearRims) : error;
  }
  if (arguments.quiet) return;
  if (const std::string join = joinOf(*result.nearRims); !join.empty()) std::cout << join << '\n';
  printSummary(arguments, result.facts);
}

void runTrim(const Arguments& arguments, RunContext context) {
  if (!arguments.report.empty()) requireFolderFor(arguments.report);
  TrimmedSurface part;
  withReport(arguments, {}, [&](std::vector<std::string>& warnings) {
    requireFiles(arguments);
    part = trimSurface(arguments, context, warnings);
  });
  writeReport(arguments, toJson(part.facts));
  printWarnings(arguments, part.facts.warnings);
  if (arguments.quiet) return;
  std::cout << oneLine(arguments.output.string()) << ": " << part.mesh.triangles.size() << " triangles, "
            << part.facts.untouched << " of them the surface's own, " << part.facts.surface.area << " mm2, "
            << part.facts.surface.rims << (part.facts.surface.rims == 1 ? " rim\n" : " rims\n");
}

}  // namespace thicken::program
