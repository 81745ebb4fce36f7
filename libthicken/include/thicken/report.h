// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Reports as JSON text: one object, documented in docs/report.md.
#pragma once

#include <span>
#include <string>

#include "thicken/check.h"
#include "thicken/error.h"
#include "thicken/inspect.h"
#include "thicken/result.h"
#include "thicken/trim.h"

namespace thicken {

/// What a run over files knows beside: as SHA-256 in hexadecimal digits, empty where it is not known.
struct FileFacts {
  std::string key;  ///< of the input's bytes, the options that the output depends on, and the version
  std::string outputDigest;  ///< of the output's bytes
};

[[nodiscard]] std::string toJson(const Report& report, const FileFacts& files = {});
[[nodiscard]] std::string toJson(const Error& error, const FileFacts& files = {});
[[nodiscard]] std::string toJson(const CheckResult& result);
[[nodiscard]] std::string toJson(const RepairFacts& facts);
[[nodiscard]] std::string toJson(const TrimFacts& facts);
/// Of a run sheet by sheet: the report of each.
[[nodiscard]] std::string toJson(std::span<const Report> sheets, const FileFacts& files = {});
[[nodiscard]] std::string toJson(const Inspection& inspection);  ///< without the shell of each triangle

}  // namespace thicken
