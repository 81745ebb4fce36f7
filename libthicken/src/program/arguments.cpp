// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "plan.h"
#include "platform/memory.h"
#include "thicken/error.h"
#include "thicken/io.h"
#include "thicken/version.h"

namespace thicken::program {
namespace {

constexpr double kMebibyte = 1024.0 * 1024.0;
// Above this a number of mebibytes is a slip, and its bytes would not fit 64 bits.
constexpr double kMostMebibytes = 1e12;
constexpr double kMostSeconds = 1e9;

// What the library has no opinion about, because it depends on the machine, is checked here;
// requireValid() has the last word on everything else.
constexpr int kMostThreads = 1024;
// As large as renderPicture() takes.
constexpr int kMostPixels = 8192;

CLI::Validator threadNumber() {
  return {[](std::string& text) -> std::string {
            int value = 0;
            if (CLI::detail::lexical_cast(text, value) && value >= 0 && value <= kMostThreads) return {};
            return "it must be a whole number from 0 to " + std::to_string(kMostThreads) + ", not " + text;
          },
          ""};
}

// Says what is wrong with a length before CLI11 finds that it cannot convert it.
CLI::Validator length() {
  return {[](std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value)) return {};
            std::string pointed = text;
            if (const auto comma = pointed.find(','); comma != std::string::npos) {
              pointed[comma] = '.';
              if (CLI::detail::lexical_cast(pointed, value))
                return "numbers are written with a point: " + pointed + ", not " + text;
            }
            return "it must be a number of millimetres without a unit, such as 2.5, not " + text;
          },
          ""};
}

CLI::Validator mebibytes() {
  return {[](std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value > 0 && value <= kMostMebibytes) return {};
            return "it must be a number of MiB above 0, not " + text;
          },
          ""};
}

CLI::Validator seconds() {
  return {[](std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value > 0 && value <= kMostSeconds) return {};
            return "it must be a number of seconds above 0, not " + text;
          },
          ""};
}

// A choice by the words that the library prints. CLI11's own transformer lists the numbers behind
// the words, too.
template <class Value, class Target>
void addChoice(CLI::App& app, const std::string& flag, Target& value, const std::vector<Value>& choices,
               const std::string& help) {
  std::string list;
  for (const Value choice : choices) list += (list.empty() ? "" : ", ") + std::string(name(choice));
  const auto choose = [&value, choices, flag, list](const std::string& word) {
    const auto found =
        std::find_if(choices.begin(), choices.end(), [&](Value choice) { return name(choice) == word; });
    if (found == choices.end())
      throw CLI::ValidationError(flag, "it must be one of " + list + ", not " + word);
    value = *found;
  };
  app.add_option_function<std::string>(flag, choose, help + ": " + list)->type_name("WORD");
}

// mm
double toUnit(const std::string& word) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
      {{"mm", 1}, {"cm", 10}, {"m", 1000}, {"in", 25.4}}};
  const auto* found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& u) { return u.first == word; });
  if (found == kUnits.end())
    throw CLI::ValidationError("--unit", "it must be one of mm, cm, m, in, not " + word);
  return found->second;
}

// "1280x480"
void setPictureSize(Arguments& arguments, const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos ||
      !CLI::detail::lexical_cast(text.substr(0, cross), arguments.pictureWidth) ||
      !CLI::detail::lexical_cast(text.substr(cross + 1), arguments.pictureHeight) ||
      std::min(arguments.pictureWidth, arguments.pictureHeight) < 1 ||
      std::max(arguments.pictureWidth, arguments.pictureHeight) > kMostPixels)
    throw CLI::ValidationError("--picture-size",
                               "it must be two numbers of pixels up to 8192, such as 640x480, not " + text);
}

void describeRun(CLI::App& app, Arguments& arguments, double& memory) {
  app.add_option("--report", arguments.report, "Write the facts of the run to this file, as JSON")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--unit", [&arguments](const std::string& word) { arguments.unit = toUnit(word); },
         "Unit of the numbers of the input, which become millimetres: mm, cm, m, in; default: mm")
      ->type_name("WORD");
  app.add_option("--threads", arguments.options.threads, "Threads; 0: all that the machine has")
      ->check(threadNumber())
      ->type_name("T");
  app.add_option("--memory", memory, "Most memory that the run may take; default: what the machine has")
      ->check(mebibytes())
      ->type_name("MIB");
  app.add_option("--timeout", arguments.timeLimit, "Most seconds that the run may take; default: any number")
      ->check(seconds())
      ->type_name("S");
  app.add_flag("--quiet", arguments.quiet, "No progress, no warnings, no summary; errors are still printed");
  app.set_version_flag("--version", std::string("thicken ") + kVersion, "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
}

// What the solid is like.
void describeSolid(CLI::App& app, Arguments& arguments) {
  app.description(
      "Turns an open surface into a printable solid that keeps every triangle of the surface.\n"
      "Lengths are millimetres. `thicken check INPUT` examines a surface only, `thicken trim` cuts a part "
      "out.");
  app.add_option("INPUT", arguments.input, "Surface: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
  app.add_option("OUTPUT", arguments.output, "Solid: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
  Options& options = arguments.options;
  app.add_option("--thickness", options.thickness, "Thickness of the solid, mm")
      ->required()
      ->check(length())
      ->type_name("R");
  app.add_option("--gap", options.gap,
                 "The solid begins so far from the surface, mm; default: at the surface")
      ->check(length())
      ->type_name("G");
  app.add_option("--gap-surface", arguments.gapSurface,
                 "With --gap: write the surface that the solid begins at")
      ->type_name("FILE");
  app.add_option("--thickness-map", arguments.thicknessMap,
                 "Property of the vertices of a .ply surface: factors of the thickness")
      ->type_name("NAME");
  app.add_option("--rim-thickness", options.rimThickness,
                 "Thickness at the rim, which changes over --rim-width to what it is elsewhere, mm")
      ->check(length())
      ->type_name("T");
  app.add_option("--rim-width", options.rimWidth, "With --rim-thickness: how far from the rim, mm")
      ->check(length())
      ->type_name("W");
  app.add_option("--rim-round", options.rimRound, "Radius of the edge between shell and wall, mm")
      ->check(length())
      ->type_name("R");
  addChoice(app, "--side", options.side, std::vector{Side::kNegative, Side::kPositive, Side::kBoth},
            "Side of the surface for the material");
  addChoice(app, "--method", options.method, std::vector{Method::kAuto, Method::kSweep, Method::kReconstruct},
            "Way to build the solid");
  app.add_option("--cell", options.cell, "Width of the field's cells, mm")->check(length())->type_name("W");
  app.add_option("--resolution", options.resolution, "Or: cells along the longest side")->type_name("N");
  app.add_option("--tolerance", options.tolerance,
                 "Or: farthest that the shell may be from its definition, mm")
      ->check(length())
      ->type_name("E");
  addChoice(app, "--join", options.join, std::vector{Join::kMitre, Join::kRound},
            "Shell outside of convex edges");
  addChoice(app, "--simplify", options.simplify,
            std::vector{Simplify::kOff, Simplify::kAuto, Simplify::kShell},
            "Merge triangles that were added, within the tolerance");
  app.add_option("--smooth", options.smooth, "Rounds of shape optimisation")->type_name("ROUNDS");
}

void describeThicken(CLI::App& app, Arguments& arguments) {
  describeSolid(app, arguments);
  Options& options = arguments.options;
  app.add_flag("--repair", options.repair, "Mend a defective surface first and report every change");
  app.add_option("--weld", options.weld, "With --repair: join rims that are at most so far apart, mm")
      ->check(length())
      ->type_name("E");
  app.add_option(
         "--bridge", options.bridge,
         "With --repair: join rims that run beside each other by strips, over gaps of at most this, mm")
      ->check(length())
      ->type_name("E");
  app.add_option("--fill-holes", options.fillHoles,
                 "With --repair: close rims that are shorter than this, mm")
      ->check(length())
      ->type_name("D");
  app.add_flag("--strict", options.strict,
               "With --repair: refuse a solid that lost more than 5 % of the area or is mostly too thin");
  app.add_flag("--skip-if-same", arguments.skipIfSame,
               "With --report: do nothing where the report and the output are those of the same run");
  app.add_flag(
      "--sheets", arguments.sheets,
      "A solid for each sheet of a surface with three and more triangles at edges: objects of a .3mf, "
      "or numbered files");
  app.add_flag("--colours", arguments.colours,
               "Into a .3mf: surface, shell and wall in colours of their own");
  app.add_option("--picture", arguments.picture, "Draw the solid into this file, a .png")->type_name("FILE");
  app.add_option_function<std::string>(
         "--picture-size", [&arguments](const std::string& text) { setPictureSize(arguments, text); },
         "Pixels of the picture; twice as wide as high: from two sides; default: 1280x480")
      ->type_name("WIDTHxHEIGHT");
  app.add_option("--repaired", arguments.repaired, "With --repair: write the surface that came of it, too")
      ->type_name("FILE");
}

void describeCheck(CLI::App& app, Arguments& arguments) {
  app.description("Says whether a surface can be thickened, or everything that is wrong with it.");
  app.add_option("INPUT", arguments.input, "Surface: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
}

// "X,Y,Z"
Vec3 toPoint(const std::string& text) {
  Vec3 point;
  std::size_t begin = 0;
  for (int k = 0; k < 3; ++k) {
    const std::size_t end = k < 2 ? text.find(',', begin) : text.size();
    if (end == std::string::npos || !CLI::detail::lexical_cast(text.substr(begin, end - begin), point[k]) ||
        !std::isfinite(point[k]))
      throw CLI::ValidationError("--keep",
                                 "it must be three numbers with commas, such as 1.5,0,-20, not " + text);
    begin = end + 1;
  }
  return point;
}

void describeTrim(CLI::App& app, Arguments& arguments) {
  app.description(
      "Cuts a part out of a surface along loops that run on it, and keeps all other triangles of it.");
  app.add_option("INPUT", arguments.input, "Surface: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
  app.add_option("OUTPUT", arguments.output, "Part: .stl, .ply, .obj, .off or .3mf")
      ->required()
      ->type_name("");
  app.add_option("--loop", arguments.loops,
                 "Closed line near the surface: a text file with a point, three numbers, on each line")
      ->required()
      ->expected(1, 1000)
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--keep", [&arguments](const std::string& text) { arguments.trim.keep = toPoint(text); },
         "Point of the part that stays, mm; default: inside of the loops")
      ->type_name("X,Y,Z");
  app.add_option("--smooth", arguments.trim.smooth, "Rounds of rounding the corners of the loops")
      ->type_name("ROUNDS");
}

// What is written beside the result must not take the place of a file of the user's, nor of the result.
void refuseSharedPaths(const Arguments& arguments) {
  const auto isLoop = [&](const std::filesystem::path& path) {
    return std::any_of(arguments.loops.begin(), arguments.loops.end(),
                       [&](const std::filesystem::path& loop) { return samePath(path, loop); });
  };
  if (isLoop(arguments.output))
    throw Error(ErrorCode::kInvalidArgument,
                "OUTPUT names the file of a loop; give the part a name of its own");
  std::vector<std::filesystem::path> taken{arguments.input, arguments.output};
  for (const auto& [path, flag, what] : {std::tuple{arguments.repaired, "--repaired", "repaired surface"},
                                         std::tuple{arguments.gapSurface, "--gap-surface", "gap surface"},
                                         std::tuple{arguments.picture, "--picture", "picture"},
                                         std::tuple{arguments.report, "--report", "report"}}) {
    const auto isPath = [&path = path](const std::filesystem::path& other) { return samePath(path, other); };
    if (isLoop(path) || std::any_of(taken.begin(), taken.end(), isPath))
      throw Error(ErrorCode::kInvalidArgument,
                  std::string(flag) + " names a file that the run reads or writes itself; give the " + what +
                      " a name of its own");
    taken.push_back(path);
  }
}

void refuseSkipping(const Arguments& arguments) {
  if (!arguments.skipIfSame) return;
  if (arguments.report.empty())
    throw Error(ErrorCode::kInvalidArgument,
                "--skip-if-same compares with the report of the last run; give --report, too");
  for (const auto& [other, flag] :
       {std::pair{arguments.repaired, "--repaired"}, std::pair{arguments.gapSurface, "--gap-surface"}})
    if (!other.empty())
      throw Error(ErrorCode::kInvalidArgument, std::string("--skip-if-same looks at one output; leave out ") +
                                                   flag + ", or --skip-if-same");
  if (arguments.sheets)
    throw Error(ErrorCode::kInvalidArgument,
                "--skip-if-same looks at one solid; leave out --sheets, or --skip-if-same");
}

// What was given of the options, but for those that no byte of the output depends on. An option that is new
// here counts until it is known to be one of them.
std::vector<std::string> optionsOfOutput(const CLI::App& app) {
  constexpr std::array<std::string_view, 11> kOthers{
      "INPUT",   "OUTPUT",         "--report",  "--repaired",     "--threads",    "--timeout",
      "--quiet", "--skip-if-same", "--picture", "--picture-size", "--gap-surface"};
  std::vector<std::string> given;
  for (const CLI::Option* option : app.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::find(kOthers.begin(), kOthers.end(), name) != kOthers.end()) continue;
    given.push_back(name);
    const CLI::results_t& values = option->results();
    given.insert(given.end(), values.begin(), values.end());
  }
  return given;
}

Error usageError(const CLI::ParseError& error, const std::string& command) {
  std::string sentence = error.what();
  while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == '\n')) sentence.pop_back();
  return {ErrorCode::kInvalidArgument, sentence + "; `" + command + " --help` lists the options"};
}

}  // namespace

bool samePath(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  return !a.empty() && !b.empty() &&
         (a.lexically_normal() == b.lexically_normal() || std::filesystem::equivalent(a, b, ignored));
}

Request readArguments(int argc, const char* const* argv) {
  Arguments arguments;
  const std::string_view word = argc > 1 ? argv[1] : "";
  const bool check = word == "check", trim = word == "trim";
  arguments.command = check ? Command::kCheck : trim ? Command::kTrim : Command::kThicken;
  const std::string command = check ? "thicken check" : trim ? "thicken trim" : "thicken";
  CLI::App app("", command);
  app.allow_windows_style_options(false);  // "/tmp/scan.ply" is a file there, too
  double memory = 0;
  check ? describeCheck(app, arguments)
        : (trim ? describeTrim(app, arguments) : describeThicken(app, arguments));
  describeRun(app, arguments, memory);
  try {
    const int words = check || trim ? 1 : 0;
    app.parse(argc - words, argv + words);
  } catch (const CLI::CallForHelp&) {
    return {{}, app.help()};
  } catch (const CLI::CallForVersion& version) {
    return {{}, std::string(version.what()) + "\n"};
  } catch (const CLI::ParseError& error) {
    throw usageError(error, command);
  }
  if (!check && !trim) pipeline::requireValid(arguments.options);
  if (!arguments.repaired.empty() && !arguments.options.repair)
    throw Error(ErrorCode::kInvalidArgument, "--repaired writes what --repair makes; give --repair, too");
  if (!arguments.repaired.empty() && arguments.sheets)
    throw Error(ErrorCode::kInvalidArgument,
                "--repaired writes one surface, and --sheets makes several; leave out one");
  if (!arguments.gapSurface.empty() && (!(arguments.options.gap > 0) || arguments.sheets))
    throw Error(ErrorCode::kInvalidArgument,
                "--gap-surface writes what --gap makes of one surface; give --gap, and leave out --sheets");
  if ((arguments.options.rimThickness || arguments.options.rimRound) && arguments.sheets)
    throw Error(ErrorCode::kInvalidArgument,
                "a profile of the rim would thin the solids of --sheets where they meet, too; leave out one");
  if (arguments.unit != 1 && namesItsUnit(arguments.input))
    throw Error(ErrorCode::kInvalidArgument,
                "a 3MF file names its unit itself, and is read in it; leave out --unit");
  if (arguments.colours && !holdsColours(arguments.output))
    throw Error(ErrorCode::kInvalidArgument, "--colours is for an OUTPUT of type .3mf, which holds colours");
  arguments.limitGiven = memory > 0;
  arguments.memoryLimit =
      memory > 0 ? static_cast<std::size_t>(memory * kMebibyte) : platform::machineMemory();
  arguments.given = optionsOfOutput(app);
  refuseSharedPaths(arguments);
  refuseSkipping(arguments);
  return {arguments, {}};
}

}  // namespace thicken::program
