// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/run.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "io/sha256.h"
#include "measure/stopwatch.h"
#include "program/files.h"
#include "program/made_before.h"
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
  context.enter(Stage::kReading, 0, kReadShare, 0);
  auto [surface, passedOver] = readMeshFile(arguments.input);
  warnings.insert(warnings.end(), passedOver.begin(), passedOver.end());
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

Solid makeSolid(const Arguments& arguments, RunContext& context, std::vector<std::string>& warnings) {
  ProgressLine line(context, arguments.quiet);
  Stopwatch reading;
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  reading.lap("read");
  Options options = arguments.options;
  options.precision = storedPrecision(arguments.output);
  // The repaired surface has to be found in the solid bit for bit, whatever either file stores.
  if (!arguments.repaired.empty() && storedPrecision(arguments.repaired) == Precision::kSingle)
    options.precision = Precision::kSingle;
  line.expect(forecast(sizesOf(surface), options).seconds);
  context.setPart(kReadShare, kWriteShare);
  Solid solid = thickenOrAdvise(surface, options, context);
  context.throwIfCancelled();
  context.setPart(kWriteShare, 1);
  context.enter(Stage::kWriting, 0, 1, 0);
  Stopwatch writing;
  if (!arguments.repaired.empty()) writeMesh(arguments.repaired, *solid.repaired);
  writeMesh(arguments.output, solid.mesh);
  writing.lap("write");
  auto& seconds = solid.report.seconds;
  seconds.insert(seconds.begin(), reading.laps().front());
  seconds.push_back(writing.laps().front());
  solid.report.warnings.insert(solid.report.warnings.begin(), warnings.begin(), warnings.end());
  return solid;
}

CheckResult checkSurface(const Arguments& arguments, RunContext& context,
                         std::vector<std::string>& warnings) {
  const ProgressLine line(context, arguments.quiet);
  const TriangleMesh surface = readSurface(arguments, context, warnings);
  context.enter(Stage::kChecking, kReadShare, 1, 0);
  CheckResult result = check(surface, context, arguments.options.threads);
  result.nearRims = nearRims(surface, context, arguments.options.threads);
  result.enoughMemory = peakMemory();
  result.warnings = warnings;
  return result;
}

void printSummary(const Arguments& arguments, const Report& report) {
  std::cout << oneLine(arguments.output.string()) << ": " << report.triangles << " triangles, "
            << report.volume / 1000 << " mL, thinnest wall " << report.thinnestWall << " of "
            << report.thickness << " mm"
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
  if (arguments.repaired.empty()) return;
  requireWritable(arguments.repaired);
  requireFolderFor(arguments.repaired);
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
  std::optional<Solid> solid;
  FileFacts files;
  withReport(arguments, files, [&](std::vector<std::string>& warnings) {
    requireFiles(arguments);
    if (isReported) files.key = keyOf(arguments);
    if (arguments.skipIfSame && isMadeBefore(arguments, files.key)) return;
    solid = makeSolid(arguments, context, warnings);
  });
  if (!solid) {
    if (!arguments.quiet) std::cout << oneLine(arguments.output.string()) << ": made before\n";
    return;
  }
  if (isReported) files.outputDigest = io::sha256Of(arguments.output).value_or("");
  writeReport(arguments, toJson(solid->report, files));
  printWarnings(arguments, solid->report.warnings);
  if (arguments.quiet) return;
  printSummary(arguments, solid->report);
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

}  // namespace thicken::program
