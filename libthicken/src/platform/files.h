// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What the standard library does not do with files: create a new one or fail, replace one in a single step,
// and remove one in a signal handler. Failures leave their reason in errno.
#pragma once

#include <cstdio>
#include <filesystem>

namespace thicken::platform {

using PathChar = std::filesystem::path::value_type;

/// The file opened to be read; nullptr on failure.
[[nodiscard]] std::FILE* openFile(const std::filesystem::path& path) noexcept;

/// A new file opened to be written; nullptr on failure, with EEXIST where there is a file of that name.
[[nodiscard]] std::FILE* createFile(const std::filesystem::path& path) noexcept;

/// Gives a file the name of another, in one step, which others see whole or not at all. Returns whether it
/// did.
[[nodiscard]] bool replaceFile(const std::filesystem::path& from, const std::filesystem::path& to) noexcept;

/// Removes a file if it is there. Signal handlers may call it.
void removeFile(const PathChar* path) noexcept;

/// Whether this process may write to a file.
[[nodiscard]] bool mayWrite(const std::filesystem::path& file) noexcept;

/// Whether this process may make files in a folder.
[[nodiscard]] bool mayWriteInto(const std::filesystem::path& folder) noexcept;

}  // namespace thicken::platform
