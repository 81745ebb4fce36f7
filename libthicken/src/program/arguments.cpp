// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/arguments.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <string_view>

#include "program/machine_memory.h"
#include "thicken/error.h"
#include "thicken/version.h"

namespace thicken::program {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
// Above this a number of mebibytes is a slip, and its bytes would not fit 64 bits.
constexpr double kMostMebibytes = 1e12;

// CLI11's own sentences for ranges name neither unit nor reason.
CLI::Validator positive(const std::string& unit) {
  return {[unit](std::string& text) -> std::string {
            double value = 0;
            if (!CLI::detail::lexical_cast(text, value)) return {};  // CLI11 reports what is no number
            if (std::isfinite(value) && value > 0) return {};
            return "it must be a number of " + unit + " above 0, not " + text;
          },
          ""};
}

CLI::Validator wholeWithin(int lowest, int highest) {
  return {[lowest, highest](std::string& text) -> std::string {
            int value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= lowest && value <= highest) return {};
            return "it must be a whole number from " + std::to_string(lowest) + " to " +
                   std::to_string(highest) + ", not " + text;
          },
          ""};
}

const std::map<std::string, Side> kSides{
    {"negative", Side::kNegative}, {"positive", Side::kPositive}, {"both", Side::kBoth}};
const std::map<std::string, Method> kMethods{
    {"auto", Method::kAuto}, {"sweep", Method::kSweep}, {"reconstruct", Method::kReconstruct}};

// A choice by word; CLI11's own transformer lists the numbers behind the words, too.
template <class Value>
CLI::Option* addChoice(CLI::App& app, const std::string& flag, Value& value,
                       const std::map<std::string, Value>& words, const std::string& help) {
  std::string list;
  for (const auto& [word, meaning] : words) list += (list.empty() ? "" : ", ") + word;
  return app
      .add_option_function<std::string>(
          flag,
          [&value, &words, flag, list](const std::string& word) {
            const auto found = words.find(word);
            if (found == words.end())
              throw CLI::ValidationError(flag, "it must be one of " + list + ", not " + word);
            value = found->second;
          },
          help)
      ->type_name("WORD");
}

void describeRun(CLI::App& app, Arguments& arguments, double& memory) {
  app.add_option("--report", arguments.report, "Write the facts of the run to this file, as JSON")
      ->type_name("FILE");
  app.add_option("--threads", arguments.options.threads, "Threads; 0: all that the machine has")
      ->check(wholeWithin(0, 4096))
      ->type_name("T");
  app.add_option("--memory", memory, "Most memory that the run may take; default: what the machine has")
      ->check(positive("MiB"))
      ->type_name("MIB");
  app.add_flag("--quiet", arguments.quiet, "No progress, no warnings, no summary; errors are still printed");
  app.set_version_flag("--version", std::string("thicken ") + kVersion, "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
}

void describeThicken(CLI::App& app, Arguments& arguments) {
  app.description(
      "Turns an open surface into a printable solid that keeps every triangle of the surface.\n"
      "Lengths are millimetres. `thicken check INPUT` examines a surface only.");
  app.add_option("INPUT", arguments.input, "Surface: .stl, .ply, .obj or .off")->required()->type_name("");
  app.add_option("OUTPUT", arguments.output, "Solid: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
  Options& options = arguments.options;
  app.add_option("--thickness", options.thickness, "Thickness of the solid, mm")
      ->required()
      ->check(positive("millimetres"))
      ->type_name("R");
  addChoice(app, "--side", options.side, kSides,
            "Side of the surface for the material: negative, positive, both");
  addChoice(app, "--method", options.method, kMethods, "Way to build the solid: auto, sweep, reconstruct");
  auto* cell = app.add_option("--cell", options.cell, "Width of the field's cells, mm");
  cell->check(positive("millimetres"))->type_name("W");
  auto* resolution = app.add_option("--resolution", options.resolution, "Cells along the longest side");
  resolution->check(wholeWithin(1, 1 << 20))->type_name("N")->excludes(cell);
  app.add_option("--tolerance", options.tolerance, "Farthest that the shell may be from its definition, mm")
      ->check(positive("millimetres"))
      ->type_name("E")
      ->excludes(cell)
      ->excludes(resolution);
  app.add_option("--smooth", options.smooth, "Rounds of shape optimisation")
      ->check(wholeWithin(0, 100))
      ->type_name("ROUNDS");
  app.add_flag("--repair", options.repair, "Mend a defective surface first and report every change");
}

void describeCheck(CLI::App& app, Arguments& arguments) {
  app.description("Says whether a surface can be thickened, or everything that is wrong with it.");
  app.add_option("INPUT", arguments.input, "Surface: .stl, .ply, .obj or .off")->required()->type_name("");
}

// The report must not take the place of a file of the user's, nor of the result.
void refuseSharedPaths(const Arguments& arguments) {
  if (arguments.report.empty()) return;
  const auto same = [&](const std::filesystem::path& other) {
    std::error_code ignored;
    return !other.empty() && (arguments.report.lexically_normal() == other.lexically_normal() ||
                              std::filesystem::equivalent(arguments.report, other, ignored));
  };
  if (same(arguments.input) || same(arguments.output))
    throw Error(
        ErrorCode::kInvalidArgument,
        "--report names a file that the run reads or writes itself; give the report a name of its own.");
}

Error usageError(const CLI::ParseError& error, const std::string& command) {
  std::string sentence = error.what();
  while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == '\n')) sentence.pop_back();
  return {ErrorCode::kInvalidArgument, sentence + ". Run `" + command + " --help` for the options."};
}

}  // namespace

Request readArguments(int argc, const char* const* argv) {
  Arguments arguments;
  const bool check = argc > 1 && std::string_view(argv[1]) == "check";
  arguments.command = check ? Command::kCheck : Command::kThicken;
  const std::string command = check ? "thicken check" : "thicken";
  CLI::App app("", command);
  double memory = 0;
  check ? describeCheck(app, arguments) : describeThicken(app, arguments);
  describeRun(app, arguments, memory);
  try {
    app.parse(argc - (check ? 1 : 0), argv + (check ? 1 : 0));
  } catch (const CLI::CallForHelp&) {
    return {{}, app.help()};
  } catch (const CLI::CallForVersion& version) {
    return {{}, std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw usageError(error, command);
  }
  if (memory > kMostMebibytes) memory = 0;
  arguments.memoryLimit = memory > 0 ? static_cast<std::size_t>(memory * kMebibyte) : machineMemory();
  refuseSharedPaths(arguments);
  return {arguments, {}};
}

}  // namespace thicken::program
