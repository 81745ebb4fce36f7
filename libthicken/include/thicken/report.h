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

namespace thicken {

[[nodiscard]] std::string toJson(const Report& report);
[[nodiscard]] std::string toJson(const Error& error);
[[nodiscard]] std::string toJson(const CheckResult& result);
[[nodiscard]] std::string toJson(const RepairFacts& facts);
/// Of a run sheet by sheet: the report of each.
[[nodiscard]] std::string toJson(std::span<const Report> sheets);
[[nodiscard]] std::string toJson(const Inspection& inspection);  ///< without the shell of each triangle

}  // namespace thicken
