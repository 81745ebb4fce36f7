// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/messages.h"

#include <algorithm>
#include <iostream>

namespace thicken::program {
namespace {

void printLine(std::string_view kind, std::string_view sentence) {
  std::cerr << "thicken: " << kind << ": " << oneLine(sentence) << '\n';
}

}  // namespace

std::string oneLine(std::string_view text) {
  std::string line(text);
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(line.begin(), line.end(), isControl, ' ');
  return line;
}

void printWarning(std::string_view sentence) {
  printLine("warning", sentence);
}

void printError(const Error& error, bool quiet) {
  const std::string_view last = error.what();
  if (!quiet) {
    for (const Defect& defect : error.defects()) {
      if (!last.starts_with(defect.sentence)) printLine(name(defect.code), defect.sentence);
    }
  }
  printLine(name(error.code()), last);
  std::cerr.flush();
}

}  // namespace thicken::program
