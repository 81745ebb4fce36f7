// SPDX-License-Identifier: LGPL-2.1-or-later
#include "program/made_before.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/sha256.h"
#include "thicken/version.h"

namespace thicken::program {

std::string keyOf(const Arguments& arguments) {
  const std::optional<std::string> input = io::sha256Of(arguments.input);
  if (!input) return {};
  io::Sha256 key;
  // A zero byte ends each item: none can hold one.
  const auto add = [&key](std::string item) { key.add(item += '\0'); };
  add(kVersion);
  add(*input);
  add(arguments.input.extension().string());
  add(arguments.output.extension().string());
  for (const std::string& item : arguments.given) add(item);
  return key.digits();
}

bool isMadeBefore(const Arguments& arguments, const std::string& key) {
  std::error_code ignored;
  if (key.empty() || (!arguments.picture.empty() && !std::filesystem::exists(arguments.picture, ignored)))
    return false;
  std::ifstream file(arguments.report, std::ios::binary);
  const nlohmann::json report = nlohmann::json::parse(file, nullptr, false);
  if (!report.is_object() || report.value("status", nlohmann::json()) != "ok" ||
      report.value("key", nlohmann::json()) != key)
    return false;
  const nlohmann::json::json_pointer digest("/output/sha256");
  const std::optional<std::string> output = io::sha256Of(arguments.output);
  return output && report.contains(digest) && report.at(digest) == *output;
}

}  // namespace thicken::program
