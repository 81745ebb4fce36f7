// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string_view>

namespace thicken {

/// A number that no other running process has.
[[nodiscard]] long processId() noexcept;

/// Whether somebody may be watching stderr.
[[nodiscard]] bool stderrIsTerminal() noexcept;

/// Writes to stderr without buffers or locks. Signal handlers may call it.
void writeToStderr(std::string_view text) noexcept;

/// Ends the process without any cleaning up. Signal handlers may call it.
[[noreturn]] void endProcess(int status) noexcept;

}  // namespace thicken
