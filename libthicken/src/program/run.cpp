// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "measure/stopwatch.h"
#include "program/files.h"
#include "program/messages.h"
#include "program/progress_line.h"
#include "thicken/thicken.h"

namespace thicken::program {
namespace {

// Rough shares of the program's own stages in a whole run.
constexpr double kReadShare = 0.02;
constexpr double kWriteShare = 0.98;

// `warnings`: what was passed over in the file is added to them.
TriangleMesh readSurface(const Arguments& arguments, RunContext& context,
                         std::vector<std::string>& warnings) {
  context.enter(Stage::kReading, 0, kReadShare);
  auto [surface, passedOver] = readMeshFile(arguments.input);
  warnings.insert(warnings.end(), passedOver.begin(), passedOver.end());
  context.throwIfCancelled();
  return surface;
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
  std::vector<Report> reports;
};

// Proves all before it writes any.
Made makeSheets(const Arguments& arguments, const TriangleMesh& surface, const Options& options,
                RunContext& context) {
  const std::vector<Sheet> sheets = divideIntoSheets(surface);
  if (sheets.empty()) throw Error(ErrorCode::kEmpty, "the surface has no triangles");
  requireFree(arguments, sheets.size());
  Made made;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    try {
      Solid solid = thicken(sheets[i].mesh, options, context);
      made.meshes.push_back(std::move(solid.mesh));
      made.reports.push_back(std::move(solid.report));
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
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
  context.enter(Stage::kWriting, kWriteShare, 1);
  writeMeshes(arguments.output, made.meshes);
  return made;
}

Made makeSolid(const Arguments& arguments, RunContext& context, std::vector<std::string>& warnings) {
  const ProgressLine line(context, arguments.quiet);
  Stopwatch reading;
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  reading.lap("read");
  Options options = arguments.options;
  options.precision = storedPrecision(arguments.output);
  // The repaired surface has to be found in the solid bit for bit, whatever either file stores.
  if (!arguments.repaired.empty() && storedPrecision(arguments.repaired) == Precision::kSingle)
    options.precision = Precision::kSingle;
  if (arguments.sheets) return makeSheets(arguments, surface, options, context);
  Solid solid = thicken(surface, options, context);
  context.throwIfCancelled();
  context.enter(Stage::kWriting, kWriteShare, 1);
  Stopwatch writing;
  if (!arguments.repaired.empty()) writeMesh(arguments.repaired, *solid.repaired);
  writeMesh(arguments.output, solid.mesh);
  writing.lap("write");
  auto& seconds = solid.report.seconds;
  seconds.insert(seconds.begin(), reading.laps().front());
  seconds.push_back(writing.laps().front());
  solid.report.warnings.insert(solid.report.warnings.begin(), warnings.begin(), warnings.end());
  Made made;
  made.meshes.push_back(std::move(solid.mesh));
  made.reports.push_back(std::move(solid.report));
  return made;
}

CheckResult checkSurface(const Arguments& arguments, RunContext& context,
                         std::vector<std::string>& warnings) {
  const ProgressLine line(context, arguments.quiet);
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  context.enter(Stage::kChecking, kReadShare, 1);
  CheckResult result = check(surface, context, arguments.options.threads);
  result.nearRims = nearRims(surface, context, arguments.options.threads);
  result.warnings = warnings;
  return result;
}

void printSummary(const std::filesystem::path& path, const Report& report) {
  std::cout << oneLine(path.string()) << ": " << report.triangles << " triangles, " << report.volume / 1000
            << " mL, thinnest wall " << report.thinnestWall << " of " << report.thickness << " mm"
            << (report.parts > 1 ? ", " + std::to_string(report.parts) + " parts" : "") << '\n';
}

void printNearRims(const NearRims& near) {
  if (near.corners == 0) return;
  // rounded up, so that a weld over what is printed reaches them all
  const double unit = std::pow(10, std::floor(std::log10(near.distance)) - 2);
  const double distance = std::ceil(near.distance / unit) * unit;
  std::cout << near.corners << " corners on rims are up to " << distance
            << " mm from another rim: --repair --weld " << distance << " would join them\n";
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
// warned of until then.
template <class Run>
void withReport(const Arguments& arguments, Run run) {
  std::vector<std::string> warnings;
  try {
    try {
      run(warnings);
    } catch (const std::bad_alloc&) {
      throw Error(ErrorCode::kMemoryLimit,
                  "the machine ran out of memory; free some, or use a larger --cell or a coarser surface");
    }
  } catch (const Error& error) {
    printWarnings(arguments, warnings);
    if (error.code() != ErrorCode::kCancelled) writeReport(arguments, toJson(error));
    throw;
  }
}

}  // namespace

void runThicken(const Arguments& arguments, RunContext context) {
  if (!arguments.report.empty()) requireFolderFor(arguments.report);
  Made made;
  withReport(arguments, [&](std::vector<std::string>& warnings) {
    requireReadable(arguments.input);
    requireWritable(arguments.output);
    requireFolderFor(arguments.output);
    if (!arguments.repaired.empty()) {
      requireWritable(arguments.repaired);
      requireFolderFor(arguments.repaired);
    }
    made = makeSolid(arguments, context, warnings);
    if (arguments.sheets) printWarnings(arguments, warnings);
  });
  writeReport(arguments, arguments.sheets ? toJson(std::span<const Report>(made.reports))
                                          : toJson(made.reports.front()));
  const auto paths = pathsOfMeshes(arguments.output, made.meshes.size());
  for (std::size_t i = 0; i < made.reports.size(); ++i) {
    printWarnings(arguments, made.reports[i].warnings);
    if (!arguments.quiet) printSummary(paths[std::min(i, paths.size() - 1)], made.reports[i]);
  }
}

void runCheck(const Arguments& arguments, RunContext context) {
  if (!arguments.report.empty()) requireFolderFor(arguments.report);
  CheckResult result;
  withReport(arguments, [&](std::vector<std::string>& warnings) {
    requireReadable(arguments.input);
    result = checkSurface(arguments, context, warnings);
  });
  writeReport(arguments, toJson(result));
  if (!arguments.quiet && result.nearRims) printNearRims(*result.nearRims);
  printWarnings(arguments, result.warnings);
  if (!result.valid()) {
    const Defect& first = result.defects.front();
    throw Error(first.code, first.sentence, result.defects);
  }
  if (!arguments.quiet) printSummary(arguments, result.facts);
}

}  // namespace thicken::program
