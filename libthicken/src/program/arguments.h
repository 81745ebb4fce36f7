// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The command line of the program, read into values. docs/program.md documents it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "thicken/options.h"
#include "thicken/trim.h"

namespace thicken::program {

enum class Command { kThicken, kCheck, kTrim };

struct Arguments {
  Command command = Command::kThicken;
  std::filesystem::path input;
  std::filesystem::path output;      ///< not of kCheck
  std::filesystem::path report;      ///< empty: none
  std::filesystem::path repaired;    ///< kThicken only: where the repaired surface goes; empty: nowhere
  Options options;                   ///< kThicken only; precision follows from the output
  std::string thicknessMap;          ///< kThicken only: a property of the vertices; empty: none
  std::size_t memoryLimit = 0;       ///< bytes; 0: no limit
  double timeLimit = 0;              ///< seconds; 0: no limit
  bool skipIfSame = false;           ///< kThicken only: not to make once more what is there
  std::vector<std::string> given;    ///< the options that the output depends on, as they were given
  bool limitGiven = false;           ///< whether it was asked for, and is not just what the machine has
  std::filesystem::path gapSurface;  ///< kThicken only: where the surface at the gap goes; empty: nowhere
  std::filesystem::path picture;     ///< kThicken only: where a picture of the solid goes; empty: nowhere
  int pictureWidth = 1280, pictureHeight = 480;
  double unit = 1;  ///< mm, of the numbers of the input and of loops
  bool quiet = false;
  bool colours = false;                      ///< kThicken only: the regions as colours, in a .3mf
  bool sheets = false;                       ///< kThicken only: a solid for each sheet of the surface
  std::vector<std::filesystem::path> loops;  ///< kTrim only
  TrimOptions trim;                          ///< kTrim only; precision follows from the output
};

/// What the command line asks for: a run, or a text that answers it (--help, --version).
struct Request {
  std::optional<Arguments> arguments;
  std::string answer;
};

/// Whether both name one file; an empty path names none.
[[nodiscard]] bool samePath(const std::filesystem::path& a, const std::filesystem::path& b);

/// Reads the command line. Throws Error(kInvalidArgument) with a sentence that names the option.
[[nodiscard]] Request readArguments(int argc, const char* const* argv);

}  // namespace thicken::program
