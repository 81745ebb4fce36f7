// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace thicken::platform {

/// The words of the command line in UTF-8; from here on the console shows UTF-8, too.
[[nodiscard]] std::vector<std::string> commandLine(int argc, const char* const* argv);

/// A number that no other running process has.
[[nodiscard]] long processId() noexcept;

/// Whether somebody may be watching stderr.
[[nodiscard]] bool stderrIsTerminal() noexcept;

/// Writes to stderr without buffers or locks. Signal handlers may call it.
void writeToStderr(std::string_view text) noexcept;

/// Ends the process without any cleaning up. Signal handlers may call it.
[[noreturn]] void endProcess(int status) noexcept;

}  // namespace thicken::platform
